// The structure of a world as bytes: what a whole snapshot has beside the state. Read into a world in which there is
// nothing yet, and which only the caller knows: where the bytes are wrong, it is thrown away.
#pragma once

#include "dynamics/snapshot/bytes.h"
#include "dynamics/snapshot/snapshot.h"
#include "dynamics/world.h"

namespace carom::dynamics::snapshot {

struct WholeSection {
  std::uint32_t tag;
  const char* name;  // for messages
};
inline constexpr std::size_t kWholeSections = 7;
/// In the order in which they are read. The first is in every whole snapshot, and in no other.
extern const WholeSection kWhole[kWholeSections];

/// Write one of them.
void save_whole(std::size_t section, Saver& io, const World& world, const ShapeNames& names);

/// What is to be kept from one section to the next while a world is built.
struct Builder {
  Builder(World& built, ShapeMaker& maker, SnapshotFault& why)
      : world(built), shapes(maker), fault(why), shape(built.memory) {}
  World& world;
  ShapeMaker& shapes;
  SnapshotFault& fault;
  Array<const Shape*> shape;  // by number
};
/// Read one of them. @return false: refused; where fault.kind is none, since the bytes hold what no world does
bool build_whole(std::size_t section, Checker& io, Builder& builder);

}  // namespace carom::dynamics::snapshot
