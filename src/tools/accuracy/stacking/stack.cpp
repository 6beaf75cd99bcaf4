// stack, massratio, tower100: one column of cubes of 1 m, equal or with the weight on top. overhang: bricks that lean out.
#include "accuracy/stacking/stand.h"

namespace carom::tools::accuracy {
namespace {

constexpr double kSeconds = 30, kFallen = 0.5;  // s; m: half a cube

/// @param top_mass  kg, of the uppermost cube; all others weigh 1 kg
std::unique_ptr<Observer> column(Stage& stage, int cubes, double top_mass) {
  add_ground(stage, 0.5);
  for (int i = 0; i < cubes; ++i)
    add_box(stage, Vec(0, i + 0.5, 0), Vec::Constant(0.5), i + 1 == cubes ? top_mass : 1, {0.5, 0});
  stage.camera_from = Vec(0, 0.5 * cubes, 4 + 1.5 * cubes);
  stage.camera_to = Vec(0, 0.5 * cubes, 0);
  return std::make_unique<StandTrial>(stage, kFallen, kSeconds);
}

std::unique_ptr<Observer> fill_stack(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  return column(stage, static_cast<int>(knobs[0]), 1);
}

std::unique_ptr<Observer> fill_massratio(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  return column(stage, 2, knobs[0]);
}

std::unique_ptr<Observer> fill_tower(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  return column(stage, static_cast<int>(knobs[0]), knobs[1]);
}

/// Of k bricks the middle is under half a brick beyond the edge of the next where each lies 1 / (2 k) of a brick farther
/// out than the one below it: that is the limit of each brick at once, counted from above.
std::unique_ptr<Observer> fill_overhang(Stage& stage, const std::vector<double>& knobs, const std::string&) {
  constexpr double kLength = 1, kHeight = 0.25, kDepth = 0.5;  // m
  const int bricks = static_cast<int>(knobs[0]);
  add_ground(stage, 0.5);
  double out = 0;
  for (int i = 0; i < bricks; ++i) {
    add_box(stage, Vec(out, (i + 0.5) * kHeight, 0), Vec(kLength, kHeight, kDepth) / 2, 1, {0.5, 0});
    if (i + 1 < bricks) out += knobs[1] * kLength / (2 * (bricks - 1 - i));
  }
  stage.camera_from = Vec(out / 2, kHeight * bricks / 2, 2 + 0.4 * bricks);
  stage.camera_to = Vec(out / 2, kHeight * bricks / 2, 0);
  return std::make_unique<StandTrial>(stage, kHeight, kSeconds);
}

Challenge standing(int number, Scene scene, double bound, Peer at_60_hz, Peer at_any_step) {
  return {number,
          std::move(scene),
          "it rests where it was put",
          StandTrial::metrics(bound, bound, 0),
          std::move(at_60_hz),
          std::move(at_any_step)};
}

}  // namespace

std::vector<Challenge> stack_challenges() {
  std::vector<Challenge> list;
  for (int n : {10, 20, 50}) {
    const std::string count = std::to_string(n);
    const bool measured = n == 20;
    list.push_back(standing(22,
                            {"stack" + count,
                             count + " equal cubes, one on top of the other.",
                             "a column that stands",
                             {{"n", "", "how many", static_cast<double>(n), 1, 1000, true}},
                             kSeconds,
                             1.0 / 60,
                             fill_stack},
                            1e-3, measured ? Peer{1.4e-3, "MuJoCo stiff"} : Peer{},
                            measured ? Peer{2.3e-5, "Bullet 200, 1/480"} : Peer{}));
  }
  return list;
}

std::vector<Challenge> massratio_challenges() {
  const struct {
    double ratio;
    const char* name;
    Peer at_60_hz, at_any_step;
  } rows[] = {{1e2, "massratio1e2", {3.9e-9, "ODE exact LCP"}, {2.6e-10, "ODE exact LCP, 1/960"}},
              {1e3, "massratio1e3", {4.1e-8, "ODE exact LCP"}, {2.6e-9, "ODE exact LCP, 1/960"}},
              {1e4, "massratio1e4", {}, {}},
              {1e5, "massratio1e5", {}, {}},
              {1e6, "massratio1e6", {3.5e-5, "ODE exact LCP"}, {2.1e-6, "ODE exact LCP, 1/960"}}};
  std::vector<Challenge> list;
  for (const auto& row : rows)
    list.push_back(standing(23,
                            {row.name,
                             "A heavy cube on one of 1 kg.",
                             "the light one is not crushed",
                             {{"ratio", "", "of the masses", row.ratio, 1, 1e9}},
                             kSeconds,
                             1.0 / 60,
                             fill_massratio},
                            1e-4, row.at_60_hz, row.at_any_step));
  return list;
}

Challenge tower100_challenge() {
  return standing(24,
                  {"tower100",
                   "Nine cubes of 1 kg carry one of 100 kg.",
                   "a tower that stands",
                   {{"n", "", "cubes, the heavy one included", 10, 2, 100, true},
                    {"weight", "kg", "mass of the uppermost", 100, 1, 1e9}},
                   kSeconds,
                   1.0 / 60,
                   fill_tower},
                  1e-3, {1.2e-4, "MuJoCo stiff"}, {3.7e-5, "Bullet 200, 1/960"});
}

Challenge overhang_challenge() {
  return standing(54,
                  {"overhang",
                   "Ten bricks lean out as far as they can, less 1 %: the uppermost lies wholly beyond the lowest.",
                   "a tower that stands, and falls where it leans out by 2 % more",
                   {{"n", "", "bricks", 10, 2, 100, true}, {"reach", "", "of what just stands", 0.99, 0, 1.5}},
                   kSeconds,
                   1.0 / 60,
                   fill_overhang},
                  1e-3, {}, {});
}

}  // namespace carom::tools::accuracy
