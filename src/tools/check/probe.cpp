// Puts a shape plugin on trial: thousands of directions of every length through its support function.
#include "check/probe.h"

#include <carom/carom.h>

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <limits>
#include <thread>

#include "check/sets.h"
#include "host/system.h"

namespace carom::tools {
namespace {

using Params = std::vector<double>;

// Relative to the farthest point. Valid closed forms err by 1e-15, the engine's contacts resolve 1e-6: in between.
constexpr double kTolerance = 1e-9;
constexpr std::size_t kDirections = 2000;

bool same_bits(const Direction& a, const Direction& b) { return std::memcmp(a.data(), b.data(), sizeof a) == 0; }
double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Direction scaled(const Direction& d, int exponent) {  // exact
  return {std::ldexp(d[0], exponent), std::ldexp(d[1], exponent), std::ldexp(d[2], exponent)};
}

/// Are numbers below the smallest normal one still kept, and is rounding to nearest?
bool float_environment_is_ours() {
  volatile double tiny = std::numeric_limits<double>::min();
  tiny = tiny / 4;
  return tiny > 0 && std::fegetround() == FE_TONEAREST;
}

/// The trial of one plugin.
class Trial {
 public:
  Trial(Verdict& verdict, const ProbeRequest& request) : verdict_(verdict), request_(request) {}

  void run() {
    enter(Phase::load);
    std::fenv_t environment;
    std::fegetenv(&environment);
    std::string why;
    plugin_ = static_cast<const carom_shape_plugin*>(load_symbol(request_.path, CAROM_SHAPE_PLUGIN_SYMBOL, why));
    std::fesetenv(&environment);  // a plugin built with -Ofast flushes small numbers from the moment it is loaded
    if (!plugin_) return cannot_load(why);
    enter(Phase::describe);
    if (!description_is_sound() || !parameters_fit()) return;
    std::size_t ordinary = 1;
    const std::vector<Params> sets =
        request_.params_given ? std::vector<Params>{request_.params} : trial_params(*plugin_, &ordinary);
    verdict_.param_sets = sets.size();
    if (sets.empty())
      return find(Lie::bad_parameters, nullptr, "none of the sets of parameters that were drawn keeps its rules",
                  "give a set that does (--params), and look whether the rules can be kept at all");
    enter(Phase::sample);
    const std::vector<Direction> directions = trial_directions(kDirections);
    for (const Params& params : sets) sample(params, directions);
    if (!(plugin_->flags & CAROM_PLUGIN_HOST_THREAD)) ask_from_threads(sets.front(), directions);
    // A function already caught lying would only be caught again, with less to say about it.
    if (!guilty()) make_shapes(std::vector<Params>(sets.begin(), sets.begin() + static_cast<std::ptrdiff_t>(ordinary)));
    if (!guilty()) load_into_engine();
    enter(Phase::done);
  }

 private:
  void enter(Phase phase) { verdict_.phase = phase; }

  bool guilty() const {
    return std::any_of(std::begin(verdict_.findings), std::end(verdict_.findings),
                       [](const Finding& f) { return f.seen; });
  }

  void find(Lie lie, const Witness* witness, const std::string& what, const std::string& remedy) {
    Finding& finding = verdict_.findings[static_cast<std::size_t>(lie)];
    if (finding.seen++) return;
    std::snprintf(finding.what, sizeof finding.what, "%s", what.c_str());
    std::snprintf(finding.remedy, sizeof finding.remedy, "%s", remedy.c_str());
    if (witness) {
      finding.has_witness = 1;
      finding.witness = *witness;
    }
  }

  /// The engine knows more of the file than the system says: for which machine it is, say.
  void cannot_load(const std::string& why) {
    load_into_engine();
    if (guilty()) return;
    find(Lie::cannot_load, nullptr, "the loader refuses it: " + why,
         "build it as a shared object for this machine, with all that it needs linked in");
  }

  bool description_is_sound() {
    const carom_shape_plugin& p = *plugin_;
    std::string wrong;
    if (p.struct_size < sizeof(carom_shape_plugin))
      wrong = "struct_size is too small";
    else if (p.abi_major != CAROM_PLUGIN_ABI_MAJOR)
      wrong = "abi_major is " + std::to_string(p.abi_major);
    else if (!p.id || !*p.id)
      wrong = "it has no id";
    else if (!p.support)
      wrong = "support is NULL";
    else if (p.param_count && !p.params)
      wrong = "param_count is not 0 but params is NULL";
    else if (p.param_tail_group > p.param_count)
      wrong = "param_tail_group is larger than param_count";
    else
      for (std::uint32_t i = 0; i < p.param_count && wrong.empty(); ++i) {
        const carom_param& b = p.params[i];
        if (!b.name || !*b.name || !b.unit)
          wrong = "parameter " + std::to_string(i) + " has no name or unit";
        else if (!(b.min <= b.max))
          wrong = std::string("parameter ") + b.name + " has no value between its bounds";
      }
    if (!wrong.empty())
      find(Lie::bad_description, nullptr, "its description is wrong: " + wrong,
           "fill carom_shape_plugin_v1 as plugins/template does, with this library's plugin.h");
    else
      std::snprintf(verdict_.id, sizeof verdict_.id, "%s, version %u", p.id, p.version);
    return wrong.empty();
  }

  /// Parameters given on the command line must be ones that the plugin's own bounds allow.
  bool parameters_fit() {
    if (!request_.params_given) return true;
    const carom_shape_plugin& p = *plugin_;
    const std::size_t n = request_.params.size(), tail = p.param_tail_group;
    const bool count_fits = n == p.param_count || (tail && n > p.param_count && (n - p.param_count) % tail == 0);
    std::string wrong;
    if (!count_fits) {
      wrong = "it takes " + std::to_string(p.param_count) + " parameters";
      for (std::uint32_t i = 0; i < p.param_count; ++i) wrong += (i ? ", " : " (") + std::string(p.params[i].name);
      wrong += (p.param_count ? ")" : "") +
               std::string(tail ? ", the last " + std::to_string(tail) + " repeating" : "") + "; given are " +
               std::to_string(n);
    }
    for (std::size_t i = 0; i < n && wrong.empty(); ++i) {
      const carom_param& b = p.params[i < p.param_count ? i : p.param_count - tail + (i - p.param_count) % tail];
      if (!(request_.params[i] >= b.min && request_.params[i] <= b.max)) {
        char text[200];
        std::snprintf(text, sizeof text, "parameter %zu (%.60s) must be from %g to %g; given is %g", i + 1, b.name,
                      b.min, b.max, request_.params[i]);
        wrong = text;
      }
    }
    verdict_.usage = !wrong.empty();
    std::snprintf(verdict_.usage_text, sizeof verdict_.usage_text, "%s", wrong.c_str());
    return wrong.empty();
  }

  void remember(const double* params, std::uint64_t count, const Direction& dir) {
    Witness& w = verdict_.current;
    w.param_count = count;
    std::copy_n(params, std::min<std::uint64_t>(count, kParamsShown), w.params);
    std::copy(dir.begin(), dir.end(), w.dir);
  }

  /// One call, with guards around everything that the function may only read.
  /// @return false: a finding was made and `out` is of no use
  bool ask(const Params& params, const Direction& dir, Direction& out) {
    constexpr double kGuard = 1234.5;
    double guarded[5] = {kGuard, NAN, NAN, NAN, kGuard};  // what is not written stays NaN
    Direction given = dir;
    std::copy(dir.begin(), dir.end(), verdict_.current.dir);
    ++verdict_.calls;
    const std::int32_t result =
        plugin_->support(plugin_->user, params.data(), params.size(), given.data(), guarded + 1);
    std::copy_n(guarded + 1, 3, out.begin());
    std::copy_n(guarded + 1, 3, verdict_.current.out);
    if (!same_bits(given, dir) || guarded[0] != kGuard || guarded[4] != kGuard)
      find(Lie::writes_input, &verdict_.current, "it writes to memory other than out[]",
           "write out[0], out[1] and out[2] only; dir and params are read-only");
    if (result != 0) {
      find(Lie::fault_returned, &verdict_.current,
           "it returned " + std::to_string(result) + " (a fault) for legal input",
           "return 0 for every finite, nonzero direction and parameters within the bounds");
      return false;
    }
    if (!std::isfinite(out[0]) || !std::isfinite(out[1]) || !std::isfinite(out[2])) {
      find(Lie::not_finite, &verdict_.current, "it returned NaN or infinity, or left out[] unwritten",
           "dir may have any length: divide it by its largest component first, and guard every division by zero");
      return false;
    }
    return true;
  }

  void sample(const Params& params, const std::vector<Direction>& directions) {
    remember(params.data(), params.size(), {});
    const Params original = params;
    std::vector<Direction> asked, points;
    const auto start = std::chrono::steady_clock::now();
    const std::uint64_t calls = verdict_.calls;
    for (const Direction& dir : directions) {
      Direction first, again;
      if (!ask(params, dir, first) || !ask(params, dir, again)) continue;
      if (!same_bits(first, again))
        find(Lie::not_repeatable, &verdict_.current, "the same direction gave another point the second time",
             "keep no state between calls: no static variables, no random numbers, no clock");
      asked.push_back(dir);
      points.push_back(first);
    }
    const double spent = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    verdict_.seconds_per_call = spent / static_cast<double>(std::max<std::uint64_t>(1, verdict_.calls - calls));
    double radius = 0;
    for (const Direction& p : points) radius = std::max(radius, std::sqrt(dot(p, p)));
    judge_lengths(params, asked, points, kTolerance * radius);
    judge_convexity(asked, points, kTolerance * radius);
    if (!params.empty() && std::memcmp(original.data(), params.data(), params.size() * sizeof(double)) != 0)
      find(Lie::writes_input, &verdict_.current, "it changed its parameters",
           "params are shared by every body: read only");
    if (!float_environment_is_ours()) {
      find(Lie::changes_float_environment, &verdict_.current,
           "it changed the floating-point environment (rounding, or flushing small numbers to zero)",
           "do not call fesetround or set FTZ/DAZ; build without -Ofast and -ffast-math");
      std::fesetenv(FE_DFL_ENV);
    }
  }

  /// A direction's length says nothing: the point must reach as far along it.
  void judge_lengths(const Params& params, const std::vector<Direction>& asked, const std::vector<Direction>& points,
                     double tolerance) {
    auto compare = [&](const Direction& dir, const Direction& unit, const Direction& expected) {
      Direction out;
      if (!ask(params, dir, out)) return;
      const double lost = std::fabs(dot(unit, expected) - dot(unit, out));
      if (!(lost <= tolerance)) {
        char text[300];
        std::snprintf(text, sizeof text,
                      "its point depends on the length of the direction: at length 1 it reaches %.9g m "
                      "along it, at length %.3g it reaches %.9g m",
                      dot(unit, expected), std::hypot(dir[0], dir[1], dir[2]), dot(unit, out));
        find(Lie::depends_on_length, &verdict_.current, text,
             "dir is not normalized and may be 1e-300 or 1e300 long: divide by its largest component before squaring");
      }
    };
    for (std::size_t i = 0; i < asked.size(); i += i < 64 ? 1 : 8)
      for (int exponent : {-960, -500, -60, 60, 500, 1000}) {  // 2^-960: tilts of 1e-9 stay normal numbers
        const Direction dir = scaled(asked[i], exponent);
        compare(dir, asked[i], points[i]);
      }
    for (std::size_t axis = 0; axis < 3; ++axis)
      for (double sign : {-1.0, 1.0}) {
        Direction unit = {0, 0, 0}, smallest = {0, 0, 0}, expected;
        unit[axis] = sign;
        smallest[axis] = sign * std::numeric_limits<double>::denorm_min();
        if (ask(params, unit, expected)) compare(smallest, unit, expected);
      }
  }

  /// d_i . (p_j - p_i) <= 0 for all i, j: no point lies beyond another's supporting plane.
  void judge_convexity(const std::vector<Direction>& asked, const std::vector<Direction>& points, double tolerance) {
    double worst = tolerance;
    std::size_t invalid_plugin = asked.size(), better = 0;
    for (std::size_t i = 0; i < asked.size(); ++i) {
      const double reach = dot(asked[i], points[i]);
      for (std::size_t j = 0; j < points.size(); ++j) {
        const double beyond = dot(asked[i], points[j]) - reach;
        if (beyond > worst) {
          worst = beyond;
          invalid_plugin = i;
          better = j;
        }
      }
    }
    if (invalid_plugin == asked.size()) return;
    Witness witness = verdict_.current;
    std::copy(asked[invalid_plugin].begin(), asked[invalid_plugin].end(), witness.dir);
    std::copy(points[invalid_plugin].begin(), points[invalid_plugin].end(), witness.out);
    char text[400];
    std::snprintf(text, sizeof text,
                  "its points are not those of a convex set: for this direction there is a point %.6g m "
                  "farther along, (%.9g, %.9g, %.9g), which it gave for direction (%.9g, %.9g, %.9g)",
                  worst, points[better][0], points[better][1], points[better][2], asked[better][0], asked[better][1],
                  asked[better][2]);
    find(Lie::not_convex, &witness, text,
         "return the point of the set that is farthest along dir, for every dir; a set with a dent has no such "
         "function");
  }

  void ask_from_threads(const Params& params, const std::vector<Direction>& directions) {
    enter(Phase::threads);
    remember(params.data(), params.size(), {});
    std::vector<Direction> alone(directions.size());
    for (std::size_t i = 0; i < directions.size(); ++i)
      if (!ask(params, directions[i], alone[i])) return;
    std::atomic<std::size_t> differing{directions.size()};
    auto work = [&](std::size_t start) {
      for (std::size_t k = 0; k < 8 * directions.size(); ++k) {
        const std::size_t i = (start + k * 7) % directions.size();
        Direction out;
        const std::int32_t result =
            plugin_->support(plugin_->user, params.data(), params.size(), directions[i].data(), out.data());
        if (result != 0 || !same_bits(out, alone[i])) differing = i;
      }
    };
    std::thread threads[4];
    for (std::size_t t = 0; t < 4; ++t) threads[t] = std::thread(work, t * directions.size() / 4);
    for (std::thread& thread : threads) thread.join();
    verdict_.calls += 32 * directions.size();
    if (differing == directions.size()) return;
    std::copy(directions[differing].begin(), directions[differing].end(), verdict_.current.dir);
    std::copy(alone[differing].begin(), alone[differing].end(), verdict_.current.out);
    find(Lie::not_thread_safe, &verdict_.current, "with four threads at once, this direction gives another point",
         "keep no state between calls, or set the flag CAROM_PLUGIN_HOST_THREAD");
  }

  // The engine gets our stand-in, so that a call that never returns is on record.
  static Trial*& active() {
    static Trial* trial = nullptr;
    return trial;
  }
  static std::int32_t stand_in(void*, const double* params, std::uint64_t count, const double dir[3], double out[3]) {
    Trial& trial = *active();
    trial.remember(params, count, {dir[0], dir[1], dir[2]});
    ++trial.verdict_.calls;
    return trial.plugin_->support(trial.plugin_->user, params, count, dir, out);
  }

  void refused(const carom_error& error, const Params* params) {
    Witness witness = verdict_.current;
    witness.param_count = params ? params->size() : 0;
    if (params) std::copy_n(params->data(), std::min<std::size_t>(params->size(), kParamsShown), witness.params);
    std::copy_n(error.witness_dir, 3, witness.dir);
    std::copy_n(error.witness_out, 3, witness.out);
    find(Lie::refused_by_engine, error.has_witness ? &witness : nullptr,
         std::string("the engine refuses it (") + carom_result_name(error.code) + "): " + error.message, error.remedy);
  }

  /// Declarations are verified when a shape is made.
  void make_shapes(const std::vector<Params>& sets) {
    enter(Phase::shapes);
    active() = this;
    carom_shape_plugin description = *plugin_;
    description.support = stand_in;
    carom_error error = CAROM_ERROR_INIT;
    carom_engine* engine = nullptr;
    carom_plugin plugin = CAROM_NULL_HANDLE;
    if (carom_engine_create(nullptr, &engine, &error) != CAROM_OK) return refused(error, nullptr);
    if (carom_plugin_register(engine, &description, &plugin, &error) != CAROM_OK) return refused(error, nullptr);
    for (const Params& params : sets) {
      carom_shape shape = CAROM_NULL_HANDLE;
      if (carom_shape_create(engine, plugin, params.data(), params.size(), &shape, &error) != CAROM_OK)
        return refused(error, &params);
      ++verdict_.shapes;
    }
    carom_engine_destroy(engine, nullptr);
  }

  void load_into_engine() {
    enter(Phase::engine_load);
    carom_error error = CAROM_ERROR_INIT;
    carom_engine* engine = nullptr;
    carom_plugin plugin = CAROM_NULL_HANDLE;
    if (carom_engine_create(nullptr, &engine, &error) != CAROM_OK ||
        carom_plugin_load(engine, request_.path.c_str(), &plugin, &error) != CAROM_OK)
      return refused(error, nullptr);
    carom_engine_destroy(engine, nullptr);
  }

  Verdict& verdict_;
  const ProbeRequest& request_;
  const carom_shape_plugin* plugin_ = nullptr;
};

}  // namespace

void probe(Verdict& verdict, const ProbeRequest& request) {
  Trial trial(verdict, request);
  trial.run();
  verdict.complete = 1;
}

}  // namespace carom::tools
