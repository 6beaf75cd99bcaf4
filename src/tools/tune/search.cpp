// Successive halving: all candidates over the first part of the scene, the better half over all of it, what is near the
// front beside them, and at last the front once more for its times.
#include <algorithm>
#include <cmath>
#include <limits>

#include "host/cpu_time.h"
#include "tune/tune.h"

namespace carom::tools::tune {
namespace {

constexpr double kFirstPart = 0.3;   // of the scene that all candidates are run over
constexpr double kLeastSeconds = 1;  // that it is worth to do so for
constexpr double kDear = 4;          // times the budget: a setting that takes longer is given up,
constexpr double kDearest = 12;      // as is one that takes so many times what the library's own does
constexpr double kApart = 0.3;       // of the median candidate's error: as far as the references may be from each other
constexpr double kClearly = 0.95;    // of the error of what is cheaper: more is no gain worth a millisecond
constexpr double kDistance = 1e-9;   // m: nearer than that, two runs are the same
constexpr double kNudge = 1e-6;      // m/s: chaos makes another run of it, of the same kind
constexpr double kWorkFull = 130;    // what a search takes, in runs of the library's own setting (measured: 90 to 150),
constexpr double kWorkFew = 45;      // and with few candidates and rough references
constexpr double kWorthAll = 3;      // s, simulated: with less left for it, few candidates are tried
constexpr double kShortest = 0.5;    // s, simulated, that anything is judged by
constexpr double kUntilLate = 0.75;  // of the patience: then nothing else is tried
constexpr double kRuns = 110;        // about so many, each of which has to start, or, with few candidates,
constexpr double kRunsFew = 45;
constexpr double kTimed = 0.05;  // s of computing: runs that take less together are repeated on, for their times
constexpr int kMostRepeats = 20;
constexpr double kProbe = 0.04;  // of the patience, to find out what a frame costs

/// How many of the others beat one in both time and error.
int beaten_by(const Measured& one, const std::vector<Measured>& all) {
  return static_cast<int>(std::count_if(all.begin(), all.end(), [&](const Measured& m) {
    return m.ms <= one.ms && m.error <= one.error && (m.ms < one.ms || m.error < one.error);
  }));
}

/// From the cheapest on, each that errs clearly less than all cheaper ones.   @param floor  errors below it are the
/// same
std::vector<Measured> front_of(std::vector<Measured> all, double floor) {
  std::sort(all.begin(), all.end(), [](const Measured& a, const Measured& b) { return a.ms < b.ms; });
  std::vector<Measured> front;
  double least = std::numeric_limits<double>::infinity();
  for (const Measured& m : all) {
    const double error = std::max(m.error, floor);
    if (!(error < kClearly * least)) continue;
    front.push_back(m);
    least = error;
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
      : engine_(engine), question_(question), progress_(progress), player_(engine, question) {}

  Result run() {
    result_.kind = question_.kind;
    probe();
    std::vector<Setting> settings = first_candidates(result_.who, few_);
    const bool halves = !few_ && result_.seconds * kFirstPart >= kLeastSeconds;
    total_ = static_cast<int>(settings.size()) * (halves ? 3 : 2) / 2 + (few_ ? 25 : 45);
    if (own_ms_ > kHopeless * question_.budget_ms) return hopeless();
    find_references(halves);
    std::vector<Measured> measured;
    if (halves) {
      measured = measure(settings, kFirstPart * result_.seconds, first_part_);
      judge_chaos(measured, first_part_);
      keep_better_half(measured);
      settings.clear();
      for (const Measured& m : measured) settings.push_back(m.setting);
    }
    measured = measure(settings, result_.seconds, whole_);
    if (!halves) judge_chaos(measured, whole_);
    find_floor();
    look_closer(measured);
    result_.front = front_of(measured, result_.floor);
    run_front_again(measured);
    result_.front = front_of(measured, result_.floor);
    result_.all = std::move(measured);
    std::sort(result_.all.begin(), result_.all.end(), [](const Measured& a, const Measured& b) { return a.ms < b.ms; });
    pick();
    return std::move(result_);
  }

 private:
  static constexpr double kHopeless =
      8;  // times the budget that the library's own setting takes: no dial makes up for it

  double now() const { return question_.threads == 1 ? cpu_time() : wall_time(); }
  /// What is left then is for the front's times.
  bool late() const { return question_.patience > 0 && now() - begun_ > kUntilLate * question_.patience; }

  void tell(const std::string& what) {
    ++done_;
    if (progress_) progress_(done_, std::max(total_, done_), what);
  }

  /// What takes part, what a frame costs, and so how much of the scene there is time for.
  void probe() {
    tell("a first look");
    result_.seconds = question_.seconds;
    Trace trace;
    const double patience = question_.patience > 0 ? question_.patience : 20;
    double length = std::min(question_.seconds, kShortest), took = 0;  // s
    for (;; length = std::min(question_.seconds, 4 * length)) {
      const double first = now();
      trace = player_.play({1, {}}, length);
      took = now() - first - player_.start_seconds();
      if (length >= question_.seconds || 5 * took > kProbe * patience) break;
    }
    result_.who = trace.who;
    // Nothing met in what was looked at, though there was no time to look further: it may yet.
    if (length < question_.seconds && trace.who.may_touch) result_.who.contacts = result_.who.bounces = true;
    own_ms_ = trace.ms;
    if (question_.patience <= 0 || question_.seconds_chosen) return;
    // Once more: the first run, and its start, made what all later ones find.
    double begun = now();
    own_ms_ = player_.play({1, {}}, length).ms;
    const double start = player_.start_seconds();
    double run_s = (now() - begun - start) / length;  // s of computing, a second of the scene
    // What happens later may cost more than the start did: what was found to fit is run once before it is believed.
    for (int attempt = 0; attempt < 3; ++attempt) {
      const double before = result_.seconds;
      fit(start, run_s);
      if (result_.seconds > 0.8 * before && attempt > 0) break;
      if (result_.seconds <= kShortest || result_.seconds <= length) break;
      begun = now();
      own_ms_ = player_.play({1, {}}, result_.seconds).ms;
      run_s = (now() - begun - player_.start_seconds()) / result_.seconds;
    }
  }

  /// So much of the scene, and as many settings, as there is time for.
  void fit(double start, double run_s) {
    const auto fits = [&](double runs, double work) {
      return (question_.patience - (now() - begun_) - runs * start) / (run_s * work);
    };
    few_ = fits(kRuns, kWorkFull) < std::min(kWorthAll, question_.seconds);
    const double most = few_ ? fits(kRunsFew, kWorkFew) : fits(kRuns, kWorkFull);
    result_.seconds = std::min(result_.seconds, std::max(kShortest, most));
  }

  Result hopeless() {
    result_.tried = result_.too_dear = 1;
    result_.all = {{{1, {}}, std::numeric_limits<double>::infinity(), own_ms_, own_ms_, true}};
    return std::move(result_);
  }

  References references(double seconds) {
    tell("reference");
    Trace full = player_.play(reference_setting(result_.who, few_), seconds);
    tell("half the reference");
    return {std::move(full), player_.play(half_reference_setting(result_.who, few_), seconds)};
  }

  void find_references(bool halves) {
    whole_ = references(result_.seconds);
    if (halves) first_part_ = references(kFirstPart * result_.seconds);
    result_.spread = between(whole_, ErrorKind::pose);
  }

  double between(const References& r, ErrorKind kind) const {
    return errors_of(r.half, r, question_.frame_rate)[static_cast<std::size_t>(kind)];
  }

  void judge(Measured& m, const Trace& trace, const References& references) const {
    m.errors = errors_of(trace, references, question_.frame_rate);
    take_errors(m, {m.errors[static_cast<std::size_t>(result_.kind)]});
    m.offences = offences_of(trace, references);
    m.fallen = trace.fell ? std::max(1, fallen(trace, references)) : fallen(trace, references);
    m.ms = trace.ms, m.worst_ms = trace.worst_ms;
  }

  double most_ms() const { return std::min(kDear * question_.budget_ms, kDearest * own_ms_ + 0.01); }

  std::vector<Measured> measure(const std::vector<Setting>& settings, double seconds, const References& references) {
    std::vector<Measured> all;
    for (const Setting& setting : settings) {
      if (late()) {
        ++result_.left_out;
        continue;
      }
      tell(setting.text());
      try {
        const bool own = setting == Setting{1, {}};
        const Trace trace = player_.play(setting, seconds, own ? kDear * question_.budget_ms : most_ms());
        ++result_.tried;
        if (trace.dear) {
          ++result_.too_dear;
          continue;
        }
        all.push_back({.setting = setting, .is_default = own});
        judge(all.back(), trace, references);
        result_.let_fall += all.back().fallen > 0;
      } catch (const Error&) {
        // A solver that does not know what this scene is made of.
      }
    }
    return all;
  }

  /// If the two finest runs are as far from each other as candidates are from them, there is nothing to compare with.
  void judge_chaos(std::vector<Measured>& measured, const References& references) {
    if (question_.kind != ErrorKind::pose && question_.kind != ErrorKind::drift) return;
    std::vector<double> errors;
    for (const Measured& m : measured)
      if (std::isfinite(m.error)) errors.push_back(m.error);
    // Also where the whole scene departs though its first part does not.
    const double apart = std::max(between(references, question_.kind), between(whole_, question_.kind));
    result_.chaotic = apart > kApart * median(errors) + kDistance;
    if (!result_.chaotic || question_.kind_chosen) return;
    result_.kind = ErrorKind::laws;
    for (Measured& m : measured) take_errors(m, {m.errors[static_cast<std::size_t>(result_.kind)]});
  }

  /// Below it errors are not told apart.
  void find_floor() {
    const bool told_alone =
        result_.kind == ErrorKind::truth || result_.kind == ErrorKind::gap || result_.kind == ErrorKind::laws;
    result_.floor = told_alone ? 0 : between(whole_, result_.kind);
    if (result_.kind == ErrorKind::pose || result_.kind == ErrorKind::drift)
      result_.floor = std::max(result_.floor, kDistance);
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
    for (const Measured& m : front_of(measured, result_.floor))
      for (Setting& s : neighbours(m.setting, result_.who))
        if (std::none_of(measured.begin(), measured.end(), [&](const Measured& k) { return k.setting == s; }))
          near.push_back(std::move(s));
    for (Measured& m : measure(near, result_.seconds, whole_)) measured.push_back(std::move(m));
  }

  /// For their times; and where all is chaos, for errors of more than one run.
  void run_front_again(std::vector<Measured>& measured) {
    for (Measured& m : measured) {
      const bool on_front = std::any_of(result_.front.begin(), result_.front.end(),
                                        [&](const Measured& f) { return f.setting == m.setting; });
      if (!on_front && !m.is_default) continue;
      std::vector<double> ms = {m.ms}, worst = {m.worst_ms}, errors = {m.error};
      const double frames = result_.seconds * question_.frame_rate;
      double timed = 1e-3 * m.ms * frames;  // s
      for (int k = 1; (k < question_.repeats || (timed < kTimed && k < kMostRepeats)) && (k == 1 || !late()); ++k) {
        tell("again: " + m.setting.text());
        Measured again = m;
        judge(again, player_.play(m.setting, result_.seconds, 1e300, nudge(k)), whole_);
        ms.push_back(again.ms), worst.push_back(again.worst_ms), errors.push_back(again.error);
        timed += 1e-3 * again.ms * frames;
      }
      m.ms = median(ms), m.worst_ms = median(worst);
      if (result_.chaotic) take_errors(m, errors);
    }
  }

  static void take_errors(Measured& m, const std::vector<double>& errors) {
    const auto [least, most] = std::minmax_element(errors.begin(), errors.end());
    m.least_error = *least, m.most_error = *most, m.error = median(errors);
  }

  double nudge(int k) const { return result_.chaotic ? k * kNudge : 0; }

  void pick() {
    for (std::size_t i = 0; i < result_.front.size(); ++i)
      if (result_.front[i].ms <= question_.budget_ms) result_.pick = static_cast<int>(i);  // later ones err less
    if (result_.pick < 0) return;
    tell("the pick in a new world");
    result_.fresh = result_.front[static_cast<std::size_t>(result_.pick)];
    const Setting& chosen = result_.fresh.setting;
    Player fresh(engine_, question_);
    std::vector<double> ms, errors;
    // Where all is chaos, as many runs as its error is the median of, and none of those again: one may be an outlier.
    const std::size_t least = result_.chaotic ? static_cast<std::size_t>(question_.repeats) : 1;
    for (double timed = 0; ms.size() < least || (timed < kTimed && ms.size() < kMostRepeats);) {
      const double other = nudge(question_.repeats + static_cast<int>(ms.size()));
      judge(result_.fresh, fresh.play(chosen, result_.seconds, 1e300, other), whole_);
      ms.push_back(result_.fresh.ms), errors.push_back(result_.fresh.error);
      timed += 1e-3 * ms.back() * result_.seconds * question_.frame_rate;
    }
    result_.fresh.ms = median(ms);
    if (result_.chaotic) take_errors(result_.fresh, errors);
  }

  Engine& engine_;
  const Question& question_;
  const std::function<void(int, int, const std::string&)>& progress_;
  Player player_;
  Result result_;
  References whole_, first_part_;
  const double begun_ = question_.threads == 1 ? cpu_time() : wall_time();
  double own_ms_ = 0;
  bool few_ = false;
  int done_ = 0, total_ = 100;
};

}  // namespace

Result search(Engine& engine, const Question& question,
              const std::function<void(int, int, const std::string&)>& progress) {
  return Search(engine, question, progress).run();
}

}  // namespace carom::tools::tune
