// Trees of joints: their coordinates, inverse dynamics, mass matrix.
#include <carom/tree.h>

#include "abi/world.h"
#include "core/float_scope.h"
#include "dynamics/joint/parts.h"
#include "dynamics/joint/tree/joint_tree.h"

namespace carom::abi {
namespace {

bool refuse(Call& call, const World& world, const JointTree& tree, TreeFault fault) {
  const auto handle = [&](const SlotPool& pool, std::uint32_t slot) {
    return static_cast<unsigned long long>(pool.handle(slot));
  };
  const auto joint = [&] { return handle(world.joints.slots, tree.joint_at_fault()); };
  switch (fault) {
    case TreeFault::none:
      return true;
    case TreeFault::not_moved:
      call.fail(CAROM_E_OUT_OF_RANGE, 2, "body is static, kinematic, disabled or in quarantine: forces do not move it");
      return call.advise("name a dynamic body of the tree that is enabled");
    case TreeFault::loop:
      call.fail(CAROM_E_UNSUPPORTED, 2, "joint 0x%016llx closes a loop: the joints of this body make no tree", joint());
      return call.advise("leave out one joint of each loop; the world, static and kinematic bodies count as one body");
    case TreeFault::kind:
      call.fail(CAROM_E_UNSUPPORTED, 2, "joint 0x%016llx is a %s, which has no coordinates of a tree", joint(),
                row_of(world.joints.joint[tree.joint_at_fault()].def.kind).name);
      return call.advise("a tree is made of hinges, sliders, balls, universal, weld and six-axis joints");
    case TreeFault::locked:
      call.fail(CAROM_E_UNSUPPORTED, 2, "body 0x%016llx has locked axes or no inertia",
                handle(world.scene.bodies, tree.body_at_fault()));
      return call.advise("give bodies of a tree an inertia and no locked axes; a joint holds a plane instead");
  }
  return false;
}

/// The tree of a call's body, argument 2.
bool find_tree(Call& call, const Reading& world, carom_body body, JointTree& tree) {
  return resolve_body(call, *world, body) && refuse(call, *world, tree, tree.find(*world, handle_slot(body)));
}

bool is_size(Call& call, int argument, const JointTree& tree, std::uint64_t n) {
  return n == tree.size() ||
         call.fail(CAROM_E_OUT_OF_RANGE, argument, "n is %llu, the tree has %zu coordinates",
                   static_cast<unsigned long long>(n), tree.size()) ||
         call.advise("pass as many numbers as carom_tree_get_coordinates() counts");
}

/// Numbers of the host's, at any alignment, or none.
bool take(Call& call, int argument, const char* name, const double* given, std::uint64_t n, Array<Real>& to) {
  to.assign(n, 0);
  if (!given) return true;
  for (std::uint64_t i = 0; i < n; ++i) {
    if (!std::isfinite(given[i]))
      return call.fail(CAROM_E_NOT_FINITE, argument, "%s[%llu] is %g", name, static_cast<unsigned long long>(i),
                       given[i]);
    to[i] = given[i];
  }
  return true;
}

/// Results, where all of them are numbers.
bool give(Call& call, int argument, const char* what, const Array<Real>& from, double* to) {
  for (const Real x : from)
    if (!std::isfinite(x))
      return call.fail(CAROM_E_NOT_FINITE, argument, "%s are beyond what numbers hold", what) ||
             call.advise("pass smaller speeds and accelerations, or bring bodies of the tree nearer to each other");
  std::copy(from.begin(), from.end(), to);
  return true;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_tree_get_coordinates(carom_world* world, carom_body body, carom_tree_coordinate* dst, uint64_t stride,
                                   uint64_t capacity, uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading) return;
    const FloatScope scope;
    JointTree tree(&reading.engine().memory);
    if (!find_tree(call, reading, body, tree) || (capacity && !present(call, 3, "dst", dst)) ||
        (capacity && !element_stride<carom_tree_coordinate>(call, 4, stride)) || !present(call, 6, "count", count) ||
        (capacity && !spans(call, 4, 5, std::min<std::uint64_t>(capacity, tree.size()), stride, sizeof *dst)))
      return;
    tree.each_coordinate([&](std::size_t i, const JointTree::Coordinate& c) {
      if (i >= capacity) return;
      carom_tree_coordinate full{};
      full.joint = c.joint == kInvalid ? CAROM_NULL_HANDLE : reading->joints.slots.handle(c.joint);
      full.body = reading->scene.bodies.handle(c.body), full.axis = c.axis;
      write_element(full, dst, i, stride);
    });
    *count = tree.size();
  });
}

int32_t carom_tree_get_speeds(carom_world* world, carom_body body, double* speeds, uint64_t n, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading) return;
    const FloatScope scope;
    JointTree tree(&reading.engine().memory);
    if (!find_tree(call, reading, body, tree) || !is_size(call, 4, tree, n) ||
        (n && !present(call, 3, "speeds", speeds)))
      return;
    tree.read_speeds(*reading, speeds);
  });
}

int32_t carom_tree_get_forces(carom_world* world, carom_body body, const double* speeds, const double* accelerations,
                              double* forces, uint64_t n, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading) return;
    const FloatScope scope;
    Memory* const memory = &reading.engine().memory;
    JointTree tree(memory);
    Array<Real> at(memory), rates(memory), found(memory);
    if (!find_tree(call, reading, body, tree) || !is_size(call, 6, tree, n) ||
        (n && !present(call, 5, "forces", forces)) || !take(call, 3, "speeds", speeds, n, at) ||
        !take(call, 4, "accelerations", accelerations, n, rates))
      return;
    if (!speeds) tree.read_speeds(*reading, at.data());
    found.resize(n);
    tree.find_forces(*reading, at.data(), rates.data(), found.data());
    give(call, accelerations ? 4 : 3, "forces", found, forces);
  });
}

int32_t carom_tree_get_mass(carom_world* world, carom_body body, double* mass, uint64_t n, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading) return;
    const FloatScope scope;
    JointTree tree(&reading.engine().memory);
    Array<Real> found(&reading.engine().memory);
    if (!find_tree(call, reading, body, tree) || !is_size(call, 4, tree, n) || (n && !present(call, 3, "mass", mass)))
      return;
    found.resize(n * n);
    tree.find_mass(*reading, found.data());
    give(call, 2, "masses", found, mass);
  });
}

}  // extern "C"
