// From estimates of an error to substeps: which an island takes, and when it is estimated. No world in it.
//
// A trial is one island in one step: runs of it, from the same state, until one is accepted. A run with half the
// substeps comes first where the step is estimated; the difference of the two ends, over 2^p - 1, is the error of the
// second one.
//
// @oracle tests/unit/dynamics/test_accuracy_control
#pragma once

#include <cstdint>

#include "core/constant.h"
#include "dynamics/dials.h"
#include "dynamics/state.h"

namespace carom::dynamics {

inline constexpr Constant<Real> kAccuracyHorizon{
    "accuracy_horizon", 1, "s", "for which an error of a velocity is taken to go on, where an accuracy is set",
    "larger: motion that forgets its velocity takes more substeps than need be; smaller: places drift beyond the "
    "tolerance"};
inline constexpr Constant<Real> kAccuracyHorizonTouching{
    "accuracy_horizon_touching", 0.1, "s",
    "likewise of what touches: contacts take most of it back within their own time to settle",
    "larger: what settles takes hundreds of substeps; smaller: what slides and rolls drifts beyond the tolerance"};
inline constexpr Constant<Real> kAccuracyAim{
    "accuracy_aim", 0.6, "1", "of the tolerance that a choice of substeps aims at: errors change from step to step",
    "larger: more steps are repeated; smaller: more substeps than need be"};
inline constexpr Constant<int> kAccuracyEvery{"accuracy_every", 2, "steps",
                                              "from one estimate of an island to the next: each costs half a step",
                                              "larger: errors that grow are seen late; smaller: estimates cost more"};
inline constexpr Constant<int> kAccuracyEveryQuiet{
    "accuracy_every_quiet", 8, "steps", "likewise of an island that one substep serves, far below its tolerance",
    "larger: what begins to move without touching anything is seen late; smaller: piles at rest cost more"};
inline constexpr Constant<Real> kAccuracyQuiet{
    "accuracy_quiet", 0.05, "1",
    "of the tolerance, to the power of the order, below which an island that takes one substep is quiet: it may become "
    "20 times as fast",
    "larger: errors that grow are seen late; smaller: piles at rest cost more"};
inline constexpr Constant<Real> kAccuracyStall{
    "accuracy_stall", 0.5, "1",
    "of the order that is claimed: where more substeps lessen an error by less, they are of no use",
    "larger: steps whose errors fall slowly are left as they are; smaller: hundreds of substeps for nothing"};
inline constexpr Constant<Real> kAccuracyStir{
    "accuracy_stir", 4, "1",
    "times the error at which more substeps were of no use, from which on they are tried again",
    "larger: errors that grow are left as they are; smaller: hundreds of substeps for nothing"};
inline constexpr Constant<Real> kAccuracyStop{
    "accuracy_stop", 1.5, "1",
    "times the change of a velocity within a step, below which what touches may come to rest within the next: that is "
    "estimated",
    "larger: what slides slowly is estimated more often; smaller: where something stops is missed where it slows down "
    "faster and faster"};
inline constexpr Constant<std::uint32_t> kAccuracyFew{
    "accuracy_few", 4, "bodies",
    "of an island in contact whose stops are looked for: in a heap something always comes to rest",
    "more: heaps are estimated in every step; fewer: where blocks on each other stop is missed"};
inline constexpr Constant<int> kAccuracyPatience{
    "accuracy_patience", 15, "estimates",
    "of an island that joints alone hold, at one substep, before a lower order is tried again, 15 at most",
    "larger: motion that slows down pays for its order for longer; smaller: trials of a lower order cost more than they save"};
inline constexpr ConstantRow kAccuracyConstants[] = {
    kAccuracyHorizon, kAccuracyHorizonTouching, kAccuracyAim,  kAccuracyEvery, kAccuracyEveryQuiet,
    kAccuracyQuiet,   kAccuracyStall,           kAccuracyStir, kAccuracyStop,  kAccuracyFew,
    kAccuracyPatience};

namespace accuracy {

/// Whether a host asks for an accuracy.
bool is_on(const Dials& dials);

inline constexpr int kMostLevel = 24;
/// Levels: 1, 2, 4, 6, 8, 12, 16, 24, ... substeps.
int substeps_at(int level);
/// The highest level of no more substeps than that; the lowest of no fewer.
int level_within(Real substeps);
int level_for(Real substeps);

/// Errors over what is borne in a step.
struct Shares {
  Real place = 0, turn = 0;
  Real most() const { return place > turn ? place : turn; }
};

/// What becomes of the end of a run.
enum class End : std::uint8_t { dropped, compared, accepted };  // compared: kept, for the next run to be compared with

struct Trial {
  int run = 0;     // substeps to go through next; 0: it is over
  int coarse = 0;  // substeps of the end that is kept to be compared with; 0: there is none
  int taken = 0;   // of the one accepted
  int level = 0, least = 0, most = 0, order = 1;
  bool is_estimated = false, estimates = false, hit_bound = false;
  bool is_stalled = false;  // more substeps do not lessen the error
  std::uint64_t work = 0;   // substeps of all runs
  Shares error;

  /// @param met    a number of what the island consists of: another one asks for an estimate
  /// @param order  of the error @param least, most  substeps at least and at most; most is 2 or more
  void begin(const AccuracyMemory& memory, std::uint8_t met, int order, int least, int most);
  /// The highest of `least`: twice its substeps are within the bound, so that it can be estimated.
  int highest_least() const;
  /// A run turned out to be of too few substeps to be judged.
  void raise_least(int least_substeps);
  /// It goes on with another order, from its first run.
  void change_order(int to, int at_level);
  /// A run has ended.   @param apart  of it and of the one it is compared with, where there is one
  End end_run(bool went_well, const Shares& apart);
  /// What the island's bodies are to remember.
  AccuracyMemory memory_after(const AccuracyMemory& before, std::uint8_t met) const;

 private:
  void restart(int at_level);
  bool stalls(int ended);
  int order_seen(int ended, Real share) const;
  int repeated = 0;         // substeps of the last run that was estimated and repeated; 0: none
  Real repeated_share = 0;  // its error; of a note that had stalled, the error then
};

// ---- orders of islands that joints alone hold: one of 2, 4 and 6, with 1, 5 and 9 stages a substep ----

/// A trial that is to take so many substeps that a higher order would take fewer stages goes on with that.
void climb(Trial& trial);
/// Likewise what is remembered of a trial: its order, or a lower one that is worth a try.
/// @param least  the lowest order that a host allows
void choose_order(AccuracyMemory& memory, const Trial& trial, int least);

/// A number that changes, mostly, where what an island consists of does.
/// @param rows, links  of contacts, of joints   @param softly  contacts of it were springs, or joints alone hold it
std::uint8_t number_of(std::uint32_t bodies, std::uint32_t rows, std::uint32_t links, bool softly);

/// Of an island, from its bodies': the highest level, and an estimate as soon as any wants one, or where they differ.
void join_memory(AccuracyMemory& to, const AccuracyMemory& other, bool is_first);

}  // namespace accuracy
}  // namespace carom::dynamics
