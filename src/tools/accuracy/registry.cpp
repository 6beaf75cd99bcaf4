// The list of challenges, in the order of the suite.
#include "accuracy/challenge.h"

namespace carom::tools::accuracy {

Challenge freefall_challenge();
Challenge drag_challenge();
Challenge gzbox_challenge();
Challenge top_challenge();
Challenge dzhanibekov_challenge();
Challenge heavytop_challenge();
Challenge pendulum_challenge();
Challenge fourbar_challenge();
Challenge bricard_challenge();
Challenge governor_challenge();
Challenge reach_challenge();
std::vector<Challenge> chain_challenges();
Challenge wrecking_challenge();
Challenge bridge_challenge();
Challenge bouncing_challenge();
Challenge bounce05_challenge();
Challenge cradle_challenge();
Challenge cannon_challenge();
Challenge elastic666_challenge();
Challenge pack666_challenge();
Challenge slide_challenge();
Challenge slip_challenge();
Challenge stick_challenge();
Challenge rolling_challenge();
Challenge skid_challenge();
Challenge coin_challenge();
Challenge wheel_challenge();
Challenge tray_challenge();
Challenge turntable_challenge();
Challenge cone_challenge();
Challenge ladder_challenge();
Challenge grip_challenge();
Challenge shake_challenge();
Challenge painleve_challenge();
std::vector<Challenge> stack_challenges();
std::vector<Challenge> massratio_challenges();
Challenge tower100_challenge();
Challenge overhang_challenge();
Challenge domino_challenge();
Challenge cards_challenge();
Challenge bullet_challenge();
Challenge spinning_rod_challenge();
Challenge arch_challenge();
Challenge thin_arch_challenge();
Challenge kapla_challenge();
Challenge overlap_challenge();
Challenge far_challenge();
std::vector<Challenge> cones_challenges();
Challenge pile_challenge();
Challenge tumble_challenge();
Challenge replay_challenge();
Challenge collisions_challenge();

const std::vector<Challenge>& all_challenges() {
  static const std::vector<Challenge> challenges = [] {
    std::vector<Challenge> list;
    for (auto make : {freefall_challenge, drag_challenge, gzbox_challenge, top_challenge, dzhanibekov_challenge,
                      heavytop_challenge, pendulum_challenge})
      list.push_back(make());
    for (Challenge& c : chain_challenges()) list.push_back(std::move(c));
    for (auto make : {fourbar_challenge, bricard_challenge, governor_challenge, reach_challenge})
      list.push_back(make());
    for (auto make : {bouncing_challenge, bounce05_challenge, cradle_challenge, cannon_challenge, elastic666_challenge,
                      pack666_challenge, slide_challenge, slip_challenge, stick_challenge, rolling_challenge,
                      skid_challenge, coin_challenge, wheel_challenge, tray_challenge, turntable_challenge,
                      cone_challenge, ladder_challenge, grip_challenge, shake_challenge})
      list.push_back(make());
    for (Challenge& c : stack_challenges()) list.push_back(std::move(c));
    for (Challenge& c : massratio_challenges()) list.push_back(std::move(c));
    for (auto make : {tower100_challenge, overhang_challenge, domino_challenge, cards_challenge, arch_challenge,
                      thin_arch_challenge, bridge_challenge, kapla_challenge, bullet_challenge, spinning_rod_challenge,
                      wrecking_challenge, painleve_challenge, overlap_challenge, far_challenge, pile_challenge,
                      tumble_challenge, replay_challenge, collisions_challenge})
      list.push_back(make());
    for (Challenge& c : cones_challenges()) list.push_back(std::move(c));
    return list;
  }();
  return challenges;
}

const Challenge& find_challenge(const std::string& name) {
  std::vector<std::string> names;
  std::string list;
  for (const Challenge& challenge : all_challenges()) {
    if (challenge.scene.name == name) return challenge;
    names.push_back(challenge.scene.name);
    list += (list.empty() ? "" : ", ") + challenge.scene.name;
  }
  const std::string near = nearest_name(name, names);
  throw Error("there is no accuracy scene called '" + name + "'",
              (near.empty() ? "" : "did you mean '" + near + "'? ") + "the scenes are: all, " + list);
}

}  // namespace carom::tools::accuracy
