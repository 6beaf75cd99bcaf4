// Where every collider is now, and the tree that questions go through; brought up to date by the first question after a
// change. @see README.md
#pragma once

#include <atomic>
#include <mutex>

#include "collision/broad/query_tree.h"
#include "dynamics/effects.h"

namespace carom::dynamics {

class QueryIndex {
 public:
  explicit QueryIndex(Memory* m);

  // ---- by a writer, alone ----
  /// A host or a step moved a body. Allocates nothing.
  /// @param revised  the scene's collider_revision was, or is about to be, raised by one for this
  void mark_moved(std::uint32_t body, bool revised = false);
  /// A collider comes or goes, for which the revision is raised by one. Allocates nothing.
  void mark_changed(std::uint32_t slot);
  bool in_use() const { return whole_; }

  // ---- by readers, any number at a time ----
  /// Whoever comes first after a change does the work; others wait for it.
  void bring_up_to_date(const World& world);

  // As of then, by collider slot:
  const Frame& frame(std::uint32_t slot) const { return seen_as_[slot].frame; }  // shape -> world
  const Aabb& bounds(std::uint32_t slot) const { return bounds_[slot]; }         // m, world, exact to rounding
  const QueryTree& tree() const { return tree_; }
  Real largest_radius() const { return largest_; }  // m, of all but half-spaces

  /// Call f(slot) for those that are not in the tree: half-spaces, and the latest to come.
  template <class F>
  void each_beside(F&& f) const {
    for (const std::uint32_t slot : wide_) f(slot);
    for (const std::uint32_t slot : loose_) f(slot);
  }
  /// Call f(slot) for all.
  template <class F>
  void each(F&& f) const {
    for (std::uint32_t slot = 0; slot < where_.size(); ++slot)
      if (where_[slot] != Where::nowhere) f(slot);
  }

 private:
  enum class Where : std::uint8_t { nowhere, wide, loose, tree };
  static std::uint64_t changes(const World& world, std::uint64_t moves);
  void update(const World& world);
  void grow(const World& world);
  void look_at_all(const World& world);
  void look_at(const World& world, std::uint32_t slot);
  void place(const World& world, std::uint32_t slot);
  void put(std::uint32_t slot, Where where);
  void take_out(std::uint32_t slot);
  void rebuild();

  std::mutex mutex_;
  std::atomic<std::uint64_t> seen_{0};  // changes() that all below is up to date with
  std::uint64_t moves_ = 0;             // noted since the world was made
  std::uint64_t revision_ = 0;          // Scene::collider_revision, likewise
  std::uint64_t marked_ = 0;            // times that was raised since, for what is noted below
  bool whole_ = false;                  // it has been made; false again where memory ran out half-way

  QueryTree tree_;
  Array<Where> where_;
  struct SeenAs {
    Handle handle;
    Frame frame;
    Vec3 x;  // m, of the body then: a pose of the same bits needs no look
    Quat q;
  };
  Array<SeenAs> seen_as_;
  Array<Aabb> bounds_;
  Array<std::uint32_t> wide_, loose_, leaves_;
  Array<std::uint32_t> moved_;    // bodies, each once
  Array<std::uint8_t> is_moved_;  // by body
  Array<std::uint32_t> changed_;  // colliders
  Real largest_ = 0;
};

/// Where a collider stands now.
Frame collider_frame(const World& world, std::uint32_t slot);
/// Whether it makes contacts at all: neither its shape nor its body is in quarantine.
bool takes_part(const World& world, std::uint32_t slot);

/// Stage observe: the bodies that this step moved, if anybody asks.
void save_moved_bodies(const World& world, const StepTime& time);

}  // namespace carom::dynamics
