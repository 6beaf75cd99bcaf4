// Judges a scene by where its bodies are after each step, and by nothing that an engine says of itself.
// README.md says what each verdict means and where its bound comes from.
#pragma once

#include <array>
#include <map>
#include <memory>

#include "jury/case.h"

namespace carom::tools::jury {

enum class Kind { fault, gain, throws, gape, sink, pass, stall, jitter, task };
inline constexpr std::size_t kKinds = 9;
const char* name_of(Kind kind);
const char* meaning_of(Kind kind);

/// The first time that something went wrong in one of the ways, and how far it went.
struct Failure {
  Kind kind = Kind::fault;
  std::size_t step = 0;  ///< the first; steps count from 1
  std::string who;       ///< "rod box 7", "rod box 7 in ramp 1"
  double value = 0;      ///< then, in `unit`
  double limit = 0;      ///< what would have been borne
  const char* unit = "";
  std::size_t plain_step = 0;  ///< from when on anybody would see it; 0: never
  std::size_t worst_step = 0;  ///< when it was farthest beyond its limit
  std::string worst_who;
  double worst = 0;
};

/// What a step cost. What is not known is 0.
struct Cost {
  double seconds = 0;
  double work = 0;  ///< support calls, impulses and moves: alike on every machine
  std::uint64_t faults = 0;
  std::string faulty;  ///< who, and how
};

struct Verdict {
  std::vector<Failure> failures;  ///< at most one of each kind, by kind
  double mean_seconds = 0, worst_seconds = 0;
  std::size_t worst_step = 0;
  double mean_work = 0, worst_work = 0;
  std::vector<double> seconds;  ///< of each step
  const Failure* of(Kind kind) const;
};

/// What is read off one step, for who wants to see it.
struct Reading {
  double kinetic = 0, potential = 0;    ///< J; potential from the origin
  double given = 0;                     ///< J, by paddles in this step, at most
  double excess = 0, excess_limit = 0;  ///< J, of the set of bodies that is nearest its limit
  std::size_t gainer = 0;               ///< the body that gained the most in this step
  double speed = 0;                     ///< m/s
  std::size_t fastest = 0;
  double depth = 0;  ///< m
  std::size_t deep_a = 0, deep_b = 0;
  double gap = 0;  ///< m
};

class Judge {
 public:
  /// @param engine  of the shapes   @param the_case  outlives the judge
  Judge(carom_engine* engine, const Case& the_case, double dt);
  ~Judge();
  void start(const Frame& frame);
  /// What the host does before the next step.   @param deeds  indices into those of the case
  /// @param now  where all is after them   @param dt  s, of the steps that follow
  void begin(double dt, const std::vector<std::size_t>& deeds, const Frame& now);
  /// @return what was read, until the next call
  const Reading& step(const Frame& frame, const Cost& cost = {});
  /// A step that was timed again: the least counts.
  void retime(std::size_t step, double seconds);
  bool may_stall() const;  ///< by time: worth timing again
  Verdict verdict() const;

 private:
  struct Inside;
  std::unique_ptr<Inside> inside_;
};

}  // namespace carom::tools::jury
