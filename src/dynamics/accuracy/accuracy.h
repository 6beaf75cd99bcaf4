// What a world that is asked for an accuracy keeps, and what a host reads of it.
#pragma once

#include "dynamics/accuracy/control.h"
#include "dynamics/accuracy/passes.h"
#include "dynamics/effects.h"

namespace carom::dynamics {

/// An island of the last step, as a host reads it.
struct AccuracyView {
  enum : std::uint32_t { kEstimated = 1, kHitBound = 2, kByJointsAlone = 4, kStalled = 8 };
  std::uint32_t body = 0;  // slot, its lowest
  std::uint32_t bodies = 0;
  std::uint32_t substeps = 0;
  std::uint32_t order = 1;  // of the error, as taken for the estimate
  std::uint32_t flags = 0;
  std::uint64_t work = 0;    // substeps of all its runs
  Real place = 0, turn = 0;  // error over tolerance, of the last estimate
  Real share() const { return place > turn ? place : turn; }
};

struct Accuracy {
  explicit Accuracy(Memory* m) : views(m), decided(m), passes(m) {}

  Array<AccuracyView> views;  // worst first, once a step has ended
  struct Decided {
    std::uint32_t body;
    AccuracyMemory memory;
  };
  Array<Decided> decided;  // in this step
  Passes passes;
};

namespace accuracy {

/// As a step begins: there is one where a host asks, and nothing is decided yet.
void begin(const World& world, Owned<Accuracy>& a);
/// An island's trial is over.   @param memory  what its bodies are to remember   @param each  each(f): f(slot) of its
/// bodies
template <class Each>
void decide(Accuracy& a, const Trial& trial, const AccuracyMemory& memory, std::uint32_t flags, const Each& each) {
  AccuracyView view;
  view.body = kInvalid;
  each([&](std::uint32_t i) {
    a.decided.push_back({i, memory});
    view.body = i < view.body ? i : view.body;
    ++view.bodies;
  });
  view.substeps = static_cast<std::uint32_t>(trial.taken), view.order = static_cast<std::uint32_t>(trial.order);
  view.flags = flags | (trial.is_estimated ? AccuracyView::kEstimated : 0u) |
               (trial.hit_bound ? AccuracyView::kHitBound : 0u) | (memory.stalled ? AccuracyView::kStalled : 0u);
  view.work = trial.work;
  view.place = memory.place, view.turn = memory.turn;
  a.views.push_back(view);
}

}  // namespace accuracy

/// Stage function of the page: what bodies remember, and the report.
void save_accuracy(const World& world, SolverMemory& memory, const StepTime& time);

}  // namespace carom::dynamics
