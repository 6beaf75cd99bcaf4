#include "cli/packed_truth.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "accuracy/challenge.h"

namespace carom::tools {
namespace {

constexpr char kPrefix[] = "accuracy/";
constexpr std::size_t kMostBytes = 1 << 20;  // of one scene's truth: a page loads it; 18,700 poses

using accuracy::TruePose;

bool same_bodies(const std::vector<TruePose>& a, const std::vector<TruePose>& b) {
  bool same = a.size() == b.size();
  for (std::size_t i = 0; same && i < a.size(); ++i) same = a[i].actor == b[i].actor;
  return same;
}

std::string frame_of(const std::vector<TruePose>& poses) {
  std::string bytes;
  for (const TruePose& pose : poses) {
    double values[7];
    std::copy_n(pose.position.data(), 3, values);
    std::fill_n(values + 3, 4, std::nan(""));
    if (pose.orientation) std::copy_n(pose.orientation->coeffs().data(), 4, values + 3);
    bytes.append(reinterpret_cast<const char*>(values), sizeof values);
  }
  return bytes;
}

}  // namespace

bool is_accuracy_scene(const std::string& name) { return name.starts_with(kPrefix); }

const Scene& accuracy_scene(const std::string& name) {
  return accuracy::find_challenge(name.substr(sizeof kPrefix - 1)).scene;
}

std::vector<std::string> scenes_with_true_poses(Context& context) {
  std::vector<std::string> names;
  for (const accuracy::Challenge& challenge : accuracy::all_challenges()) {
    Engine engine(context.plugins());
    Stage stage(engine);
    const std::unique_ptr<Observer> trial = build(challenge.scene, {}, stage);
    if (!dynamic_cast<accuracy::Trial&>(*trial).truth(0).empty()) names.push_back(kPrefix + challenge.scene.name);
  }
  return names;
}

PackedTruth packed_truth(const Stage& stage, Observer& observer, double dt, double seconds) {
  PackedTruth packed;
  auto* trial = dynamic_cast<accuracy::Trial*>(&observer);
  const std::vector<TruePose> first = trial ? trial->truth(0) : std::vector<TruePose>();
  if (first.empty()) return packed;
  for (const TruePose& pose : first) packed.row["bodies"].push_back(pose.actor);
  const std::string start = frame_of(first);
  bool still = true;
  std::size_t frames = 1;
  const auto steps = static_cast<std::size_t>(std::ceil(seconds / dt - 1e-6));
  packed.content = start;
  for (; frames <= steps && packed.content.size() + start.size() <= kMostBytes; ++frames) {
    const double time = static_cast<double>(frames) * dt;
    trial->watch(stage, time);  // goes on with its equations of motion; the world stands
    const std::vector<TruePose> poses = trial->truth(time);
    if (!same_bodies(first, poses)) break;
    const std::string frame = frame_of(poses);
    still = still && frame == start;
    packed.content += frame;
  }
  if (still) packed.content = start, frames = 1;
  packed.row["frames"] = frames;
  return packed;
}

}  // namespace carom::tools
