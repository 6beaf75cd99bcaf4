// Successive halving: all candidates over the first part of the scene, the better half over all of it, what is near the
// front beside them, and at last the front once more for its times.
#include <algorithm>
#include <cmath>
#include <limits>

#include "tune/tune.h"

namespace carom::tools::tune {
namespace {

constexpr double kFirstPart = 0.3;   // of the scene that all candidates are run over
constexpr double kLeastSeconds = 1;  // that it is worth to do so for
constexpr double kDear = 8;          // times the budget: a setting that takes longer is given up
constexpr double kApart = 0.3;       // of the median candidate's error: as far as the references may be from each other
constexpr double kClearly = 0.95;    // of the error of what is cheaper: more is no gain worth a millisecond
constexpr double kDistance = 1e-9;   // m: nearer than that, two runs are the same

/// How many of the others beat one in both time and error.
int beaten_by(const Measured& one, const std::vector<Measured>& all) {
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const Measured& m) {
    return m.ms <= one.ms && m.error <= one.error && (m.ms < one.ms || m.error < one.error);
  }));
}

/// From the cheapest on, each that errs clearly less than all cheaper ones.
std::vector<Measured> front_of(std::vector<Measured> all) {
  std::sort(all.begin(), all.end(), [](const Measured& a, const Measured& b) { return a.ms < b.ms; });
  std::vector<Measured> front;
  double least = std::numeric_limits<double>::infinity();
  for (const Measured& m : all) {
    if (!(m.error < kClearly * least)) continue;
    front.push_back(m);
    least = m.error;
  }
  return front;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

class Search {
 public:
  Search(Engine& engine, const Question& question, const std::function<void(int, int, const std::string&)>& progress)
      : engine_(engine), question_(question), progress_(progress) {}

  Answer run() {
    answer_.kind = question_.kind;
    std::vector<Setting> settings = first_candidates();
    const bool halves = question_.seconds * kFirstPart >= kLeastSeconds;
    total_ = static_cast<int>(settings.size()) * (halves ? 3 : 2) / 2 + 40;
    find_references();
    std::vector<Measured> measured;
    if (halves) {
      measured = measure(settings, kFirstPart * question_.seconds, first_part_);
      judge_chaos(measured);
      keep_better_half(measured);
      settings.clear();
      for (const Measured& m : measured) settings.push_back(m.setting);
    }
    measured = measure(settings, question_.seconds, reference_);
    if (!halves) judge_chaos(measured);
    look_closer(measured);
    answer_.front = front_of(measured);
    time_front(measured);
    answer_.front = front_of(measured);
    answer_.all = std::move(measured);
    std::sort(answer_.all.begin(), answer_.all.end(), [](const Measured& a, const Measured& b) { return a.ms < b.ms; });
    pick();
    return std::move(answer_);
  }

 private:
  void tell(const std::string& what) {
    ++done_;
    if (progress_) progress_(done_, std::max(total_, done_), what);
  }

  void find_references() {
    tell("reference");
    reference_ = play(engine_, question_, reference_setting(), question_.seconds);
    tell("half the reference");
    half_ = play(engine_, question_, half_reference_setting(), question_.seconds);
    first_part_ = play(engine_, question_, reference_setting(), kFirstPart * question_.seconds);
    answer_.spread = error_of(half_, reference_, ErrorKind::pose);
  }

  std::vector<Measured> measure(const std::vector<Setting>& settings, double seconds, const Trace& reference) {
    std::vector<Measured> all;
    traces_.clear();
    for (const Setting& setting : settings) {
      tell(setting.text());
      try {
        Trace trace = play(engine_, question_, setting, seconds, kDear * question_.budget_ms);
        ++answer_.tried;
        if (trace.dear) {
          ++answer_.too_dear;
          continue;
        }
        all.push_back(
            {setting, error_of(trace, reference, answer_.kind), trace.ms, trace.worst_ms, setting == Setting{1, {}}});
        traces_.push_back(std::move(trace));
      } catch (const Error&) {
        // A solver that does not know what this scene is made of.
      }
    }
    reference_of_traces_ = &reference;
    return all;
  }

  /// If the two finest runs are as far from each other as candidates are from them, there is nothing to compare with.
  void judge_chaos(std::vector<Measured>& measured) {
    if (question_.kind != ErrorKind::pose && question_.kind != ErrorKind::drift) return;
    std::vector<double> errors;
    for (const Measured& m : measured)
      if (std::isfinite(m.error)) errors.push_back(m.error);
    const bool whole = reference_of_traces_ == &reference_;
    const double apart =
        whole ? error_of(half_, reference_, question_.kind)
              : error_of(play(engine_, question_, half_reference_setting(), kFirstPart * question_.seconds),
                         first_part_, question_.kind);
    // Also where the whole scene departs though its first part does not.
    answer_.chaotic =
        std::max(apart, error_of(half_, reference_, question_.kind)) > kApart * median(errors) + kDistance;
    if (!answer_.chaotic || question_.kind_chosen) return;
    answer_.kind = ErrorKind::gap;
    for (std::size_t i = 0; i < measured.size(); ++i)
      measured[i].error = error_of(traces_[i], *reference_of_traces_, answer_.kind);
  }

  /// By how many others beat each; the library's own setting stays in any case.
  static void keep_better_half(std::vector<Measured>& measured) {
    const std::vector<Measured> all = measured;
    std::stable_sort(measured.begin(), measured.end(), [&](const Measured& a, const Measured& b) {
      if (a.is_default != b.is_default) return a.is_default;
      return beaten_by(a, all) < beaten_by(b, all);
    });
    measured.resize((measured.size() + 1) / 2);
  }

  void look_closer(std::vector<Measured>& measured) {
    std::vector<Setting> near;
    for (const Measured& m : front_of(measured))
      for (Setting& s : neighbours(m.setting)) near.push_back(std::move(s));
    for (Measured& m : measure(near, question_.seconds, reference_)) measured.push_back(std::move(m));
  }

  void time_front(std::vector<Measured>& measured) {
    for (Measured& m : measured) {
      const bool on_front = std::any_of(answer_.front.begin(), answer_.front.end(),
                                        [&](const Measured& f) { return f.setting == m.setting; });
      if (!on_front && !m.is_default) continue;
      std::vector<double> ms = {m.ms}, worst = {m.worst_ms};
      for (int k = 1; k < question_.repeats; ++k) {
        tell("again: " + m.setting.text());
        const Trace trace = play(engine_, question_, m.setting, question_.seconds);
        ms.push_back(trace.ms), worst.push_back(trace.worst_ms);
      }
      m.ms = median(ms), m.worst_ms = median(worst);
    }
  }

  void pick() {
    for (std::size_t i = 0; i < answer_.front.size(); ++i)
      if (answer_.front[i].ms <= question_.budget_ms) answer_.pick = static_cast<int>(i);  // later ones err less
    answer_.floor = answer_.kind == ErrorKind::truth || answer_.kind == ErrorKind::gap
                        ? 0
                        : error_of(half_, reference_, answer_.kind);
    if (answer_.pick < 0) return;
    tell("the pick in a new world");
    const Measured& chosen = answer_.front[static_cast<std::size_t>(answer_.pick)];
    const Trace trace = play(engine_, question_, chosen.setting, question_.seconds);
    answer_.fresh = {chosen.setting, error_of(trace, reference_, answer_.kind), trace.ms, trace.worst_ms, false};
  }

  Engine& engine_;
  const Question& question_;
  const std::function<void(int, int, const std::string&)>& progress_;
  Answer answer_;
  Trace reference_, half_, first_part_;
  std::vector<Trace> traces_;
  const Trace* reference_of_traces_ = nullptr;
  int done_ = 0, total_ = 0;
};

}  // namespace

Answer search(Engine& engine, const Question& question,
              const std::function<void(int, int, const std::string&)>& progress) {
  return Search(engine, question, progress).run();
}

}  // namespace carom::tools::tune
