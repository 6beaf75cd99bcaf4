// Distances of many pairs: each asked alone, whichever thread does it, so that no result depends on threads.
#include "abi/pairs.h"

#include <atomic>
#include <cstdio>

#include "abi/distance.h"
#include "core/float_guard.h"
#include "core/float_scope.h"

namespace carom::abi {
namespace {

constexpr std::uint64_t kMostPairs = std::uint64_t(1) << 24;

/// "a shape_a of pair 7", for messages.
struct PairName {
  PairName(const char* what, std::uint64_t i) {
    std::snprintf(text, sizeof text, "%s of pair %llu", what, static_cast<unsigned long long>(i));
  }
  char text[64];
};

constexpr const char* kPositionNames[] = {"position_a", "position_b"};
constexpr const char* kOrientationNames[] = {"orientation_a", "orientation_b"};
constexpr const char* kShapeNames[] = {"shape_a", "shape_b"};

/// Which threads an engine lends does not change as long as this lives.
class LentJobs {
 public:
  explicit LentJobs(carom_engine& engine) : engine_(engine) {
    const std::lock_guard lock(engine_.mutex);
    ++engine_.loops;
  }
  ~LentJobs() {
    const std::lock_guard lock(engine_.mutex);
    --engine_.loops;
  }
  LentJobs(const LentJobs&) = delete;
  LentJobs& operator=(const LentJobs&) = delete;
  Jobs* get() const { return engine_.jobs.get(); }

 private:
  carom_engine& engine_;
};

}  // namespace

ShapeTable::~ShapeTable() {
  const std::lock_guard lock(engine_.mutex);
  for (std::size_t slot = 0; slot < shapes_.size(); ++slot)
    if (shapes_[slot]) engine_.shapes[slot].uses -= 1;
}

bool ShapeTable::add(Call& call, int argument, const char* name, const Column& handles, std::uint64_t begin,
                     std::uint64_t end) {
  const std::lock_guard lock(engine_.mutex);
  shapes_.resize(engine_.shapes.size());
  for (std::uint64_t i = begin; i < end; ++i) {
    carom_shape handle;
    std::memcpy(&handle, handles.at + i * handles.stride, sizeof handle);
    if (engine_.shape_slots.check(handle) != HandleFault::none)
      return resolve(call, argument, PairName(name, i).text, engine_.shape_slots, handle);
    const std::uint32_t slot = handle_slot(handle);
    if (shapes_[slot]) continue;
    shapes_[slot] = engine_.shapes[slot].shape;
    engine_.shapes[slot].uses += 1;
  }
  return true;
}

bool PairColumns::read(Call& call, int argument, const carom_pairs* given) {
  carom_pairs p{};
  if (!read_struct(call, argument, "pairs", given, p) || !only_bits(call, argument, "pairs->reserved", p.reserved, 0) ||
      !in_range(call, argument, "pairs->count", static_cast<double>(p.count), 0, static_cast<double>(kMostPairs)))
    return false;
  count_ = p.count;
  const void* const shapes[] = {p.shapes_a, p.shapes_b};
  const void* const positions[] = {p.positions_a, p.positions_b};
  const void* const orientations[] = {p.orientations_a, p.orientations_b};
  if (count_ && (!present(call, argument, "pairs->shapes_a", shapes[0]) ||
                 !present(call, argument, "pairs->shapes_b", shapes[1]) ||
                 !present(call, argument, "pairs->positions_a", positions[0]) ||
                 !present(call, argument, "pairs->orientations_a", orientations[0]) ||
                 !present(call, argument, "pairs->positions_b", positions[1]) ||
                 !present(call, argument, "pairs->orientations_b", orientations[1])))
    return false;
  const std::uint64_t shape_strides[] = {p.shape_a_stride, p.shape_b_stride};
  const std::uint64_t position_strides[] = {p.position_a_stride, p.position_b_stride};
  const std::uint64_t orientation_strides[] = {p.orientation_a_stride, p.orientation_b_stride};
  for (int side = 0; side < 2; ++side)
    if (!make_column(call, argument, kShapeNames[side], shapes[side], shape_strides[side], sizeof(carom_shape), count_,
                     handles_[side]) ||
        !make_column(call, argument, kPositionNames[side], positions[side], position_strides[side], 3 * sizeof(double),
                     count_, positions_[side]) ||
        !make_column(call, argument, kOrientationNames[side], orientations[side], orientation_strides[side],
                     4 * sizeof(double), count_, orientations_[side]))
      return false;
  constexpr std::uint64_t kBlock = 4096;  // handles: others who want the engine's lock wait for no more than that
  for (int side = 0; side < 2; ++side)
    for (std::uint64_t i = 0; i < count_; i += kBlock)
      if (!shapes_.add(call, argument, kShapeNames[side], handles_[side], i, std::min(count_, i + kBlock)))
        return false;
  return check_poses(call, argument, 0) && check_poses(call, argument, 1);
}

bool PairColumns::read_all(Call& call, const carom_pairs* given, const carom_distance_desc* desc,
                           carom_distance_desc& known_desc, const carom_distance* dst, std::uint64_t stride) {
  return read(call, 2, given) && have_distances(call, 2) && read_distance_desc(call, 3, desc, known_desc) &&
         (count_ == 0 || present(call, 4, "dst", dst)) && element_stride<carom_distance>(call, 5, stride) &&
         spans(call, 5, 2, count_, stride, sizeof(carom_distance));
}

bool PairColumns::check_poses(Call& call, int argument, int side) const {
  for (std::uint64_t i = 0; i < count_; ++i) {
    double at[7];
    pose(side, i, at);
    const double *const p = at, *const q = at + 3;
    const Real length2 = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    const bool good = to_vec3(p).all_finite() && std::fabs(std::sqrt(length2) - 1) <= kUnitTolerance;
    if (good) continue;  // names are made for what is wrong alone
    if (!finite(call, argument, PairName(kPositionNames[side], i).text, p, 3) ||
        !unit(call, argument, PairName(kOrientationNames[side], i).text, q, 4))
      return false;
  }
  return true;
}

bool PairColumns::have_distances(Call& call, int argument) const {
  for (std::uint64_t i = 0; i < count_; ++i) {
    const Shape &a = shape(0, i), &b = shape(1, i);
    if (a.support && b.support) continue;
    if (!has_distance(call, argument, PairName("", i).text, a, b)) return false;
  }
  return true;
}

namespace {

/// Pairs that a part of the loop has: some 50 us.
constexpr std::size_t kPairsAPart = 32;

/// All of them, on the engine's threads; what only the calling one may be asked comes after.
void measure_pairs(carom_engine& engine, const PairColumns& pairs, const QuerySettings& settings, carom_distance* dst,
                   std::uint64_t stride) {
  std::atomic<bool> left{false};
  const auto part = [&](std::uint32_t begin, std::uint32_t end, bool on_host_thread) {
    const FloatGuard guard;
    for (std::uint32_t i = begin; i < end; ++i) {
      const Shape &a = pairs.shape(0, i), &b = pairs.shape(1, i);
      if ((a.host_thread || b.host_thread) != on_host_thread) {
        left.store(true, std::memory_order_relaxed);
        continue;
      }
      carom_distance found = measure_distance(a, pairs.frame(0, i), b, pairs.frame(1, i), settings);
      guard.put_back();
      found.struct_size = static_cast<std::uint32_t>(std::min<std::uint64_t>(stride, sizeof found));
      write_element(found, dst, i, stride);
    }
  };
  const LentJobs jobs(engine);
  in_parts(jobs.get(), pairs.count(), kPairsAPart,
           [&](std::uint32_t begin, std::uint32_t end) { part(begin, end, false); });
  if (left.load(std::memory_order_relaxed)) part(0, static_cast<std::uint32_t>(pairs.count()), true);
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_pairs_distance(carom_engine* engine, const carom_pairs* pairs, const carom_distance_desc* desc,
                             carom_distance* dst, uint64_t stride, carom_error* error) {
  return guarded(error, [&](Call& call) {
    if (!present(call, 1, "engine", engine)) return;
    carom_distance_desc known_desc;
    PairColumns columns(*engine);
    const FloatScope scope;
    if (columns.read_all(call, pairs, desc, known_desc, dst, stride))
      measure_pairs(*engine, columns, query_settings(known_desc), dst, stride);
  });
}

}  // extern "C"
