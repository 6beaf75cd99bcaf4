// The model: which handles live, which bodies take what along, and what each call may answer
// (tests/abi/hostile/table.h). Engines, their first shapes and three worlds last for the process. A sequence works on
// forks of these worlds, each forked when it is first called on, or, one in sixty-four, on worlds made anew; they, and
// all else that it makes, go with it.
#include "calls.h"

#include <algorithm>
#include <optional>

#include "abi/hostile/table.h"
#include "bytes.h"
#ifdef CAROM_FUZZ_REPLAYS
#include "replay/replay.h"
#endif

namespace carom::fuzz {
namespace {

using namespace hostile;

constexpr std::size_t kMostBodies = 16, kMostShapes = 10, kMostOthers = 8;
constexpr unsigned kMostSteps = 24;

class Chosen : public Source {
 public:
  explicit Chosen(Bytes& bytes) : bytes_(bytes) {}
  unsigned below(unsigned n) override {
    const unsigned x = n > 256 ? bytes_.byte() << 8 | bytes_.byte() : bytes_.byte();
    return x % n;
  }
  double unit() override { return (bytes_.byte() + 0.5) / 256; }

 private:
  Bytes& bytes_;
};

/// Three worlds: 0 and 1 of one engine, 2 of another.
constexpr int kWorlds = 3;
struct Room {
  Stage stages[kWorlds];
  Stage nobody;
  std::size_t base_shapes = 0, base_plugins = 0;

  Room() {
    good = make_engine(stages[0]) && make_engine(stages[2]);
    stages[1] = stages[0];
    for (Stage& s : stages) good = good && make_world(s);
    base_shapes = stages[0].live[kShape].size(), base_plugins = stages[0].live[kPlugin].size();
  }
  bool good;
};

Room& room() {
  static Room r;
  return r;
}

class Sequence {
 public:
  Sequence(const std::uint8_t* bytes, std::size_t size, bool trace, bool to_the_edge)
      : bytes_(bytes, size),
        source_(bytes_),
        trace_(trace),
        to_the_edge_(to_the_edge),
        records_(size > 0 && bytes[size - 1] % 4 == 0) {}

  Heard run(std::size_t size) {
    if (!room_.good) return complain("the engines and their worlds could not be made"), heard_;
    for (int i = 0; i < kWorlds; ++i) stages_[i] = room_.stages[i], hash_[i] = hash(stages_[i]);
    makes_anew_ = source_.below(64) == 0, roams_ = source_.below(4) == 0, solver_ = source_.below(8);
    if (records_ && take(0)) record();
    const std::size_t most = 1 + size / 14;
    for (std::size_t i = 0; i < most && heard_.complaint.empty(); ++i) one();
    for (int i = 0; i < kWorlds && heard_.complaint.empty(); ++i) {
      if (is_own_[i]) count(stages_[i]);
      if (hash(stages_[i]) != hash_[i]) complain("world " + std::to_string(i) + " was changed by calls on others");
    }
    if (records_ && heard_.complaint.empty()) replay();
    tidy();
    return heard_;
  }

 private:
  void complain(const std::string& what) {
    if (heard_.complaint.empty()) heard_.complaint = what;
  }
  uint64_t hash(const Stage& s) {
    uint64_t h = 0;
    if (carom_world_hash(s.world, &h, nullptr) != CAROM_OK) complain("a world has no hash");
    return h;
  }
  /// A world of the sequence's own in place of the one that lasts.
  bool take(int i) {
    if (is_own_[i]) return true;
    Stage& s = stages_[i];
    carom_world* const lasts = s.world;
    is_own_[i] = makes_anew_ ? make_world(s) : fork(s);
    if (!is_own_[i])
      return s.world = lasts, complain(makes_anew_ ? "a world could not be made" : "a world could not be forked"),
             false;
    if (!makes_anew_ && hash(s) != hash_[i]) complain("a fork is not as the world was");
    // Each solver has its turn (but severity, which knows no joints: a sequence comes to it by its calls); the direct
    // one takes as long as all others together.
    constexpr double kSolvers[] = {CAROM_SOLVER_AUTO,      CAROM_SOLVER_DIRECT,    CAROM_SOLVER_AUTO,
                                   CAROM_SOLVER_AUTO,      CAROM_SOLVER_SOFT_STEP, CAROM_SOLVER_SOFT_STEP,
                                   CAROM_SOLVER_SOFT_STEP, CAROM_SOLVER_SOFT_STEP};
    if (carom_world_set_dial(s.world, CAROM_DIAL_SOLVER, kSolvers[solver_], nullptr) != CAROM_OK)
      complain("a solver was refused");
    hash_[i] = hash(s);
    return true;
  }
  static bool fork(Stage& s) {
    carom_world* copy = nullptr;
    if (carom_world_fork(s.world, &copy, nullptr) != CAROM_OK) return false;
    s.world = copy;
    std::vector<uint64_t> handles;
    const auto each = [&](const auto& f) {
      for (const int kind : {kMaterial, kBody, kCollider, kParticles, kJoint, kField, kSpring})
        for (Owned& o : s.live[kind]) f(o.handle), f(o.owner[0]), f(o.owner[1]);
    };
    each([&](uint64_t h) { handles.push_back(h); });
    if (carom_world_translate_handles(copy, handles.data(), handles.size(), handles.data(), nullptr) != CAROM_OK)
      return carom_world_destroy(copy, nullptr), false;
    std::size_t i = 0;
    each([&](uint64_t& h) { h = handles[i++]; });
    return true;
  }

  /// With the budget, which is the host's.
  carom_world* copy_of(const Stage& s) {
    carom_world* copy = nullptr;
    double seconds = 0;
    uint32_t fewest = 0, most = 0;
    carom_error why = CAROM_ERROR_INIT;
    if (carom_world_fork(s.world, &copy, &why) != CAROM_OK ||
        carom_world_get_budget(s.world, &seconds, &fewest, &most, nullptr) != CAROM_OK ||
        (seconds > 0 && carom_world_set_budget(copy, seconds, fewest, most, nullptr) != CAROM_OK))
      complain(std::string("a world could not be copied before a step: ") + why.message);
    return copy;
  }
  static std::string what_differs(carom_world* copy, carom_world* world) {
    uint64_t size = 0;
    carom_world_save(copy, CAROM_SNAPSHOT_STATE, nullptr, 0, &size, nullptr);
    std::vector<char> bytes(size);
    carom_difference d{};
    d.struct_size = sizeof d;
    if (carom_world_save(copy, CAROM_SNAPSHOT_STATE, bytes.data(), size, &size, nullptr) != CAROM_OK ||
        carom_world_compare(world, bytes.data(), size, &d, nullptr) != CAROM_OK)
      return "its state cannot be compared";
    return d.differs ? d.sections : "nothing of its state";
  }
  /// A copy, whatever its original went through, steps as that does.
  void step_beside(carom_world* copy, double dt, const Stage& s, int32_t result) {
    uint64_t original = 0, other = 1;
    if (carom_world_step(copy, dt, nullptr) != result || carom_world_hash(s.world, &original, nullptr) != CAROM_OK ||
        carom_world_hash(copy, &other, nullptr) != CAROM_OK || original != other)
      complain("a copy steps another way than its original: " + what_differs(copy, s.world));
    if (carom_world_destroy(copy, nullptr) != CAROM_OK) complain("a copy could not be destroyed");
  }

  static bool named(const Call& call, const char* name) { return std::strcmp(call.name, name) == 0; }

  const Row& choose() {
    static const Row* step = std::find_if(std::begin(kRows), std::end(kRows),
                                          [](const Row& r) { return std::strcmp(r.name, "carom_world_step") == 0; });
    const unsigned x = source_.below(1024);
    if (x % 12 == 0) return *step;
    return kRows[x % std::size(kRows)];
  }

  /// What would make a sequence slow, or leave nothing to go on with.
  bool too_much(const Call& call, const Stage& s, const std::vector<Value>& values) {
    if (named(call, "carom_plugin_load")) return true;  // the loader's time, not ours
    if (named(call, "carom_world_step") && heard_.steps >= kMostSteps) return true;
    if (call.made == kBody && s.live[kBody].size() >= kMostBodies) return true;
    if (call.made == kShape && s.live[kShape].size() >= kMostShapes) return true;
    if (call.made >= 0 && call.made != kBody && call.made != kShape && s.live[call.made].size() >= 2 * kMostOthers)
      return true;
    // The first shapes and plugins stay, for those who come later.
    if (call.gone == kShape || call.gone == kPlugin) {
      const std::size_t base = call.gone == kShape ? room_.base_shapes : room_.base_plugins;
      for (std::size_t i = 0; i < base; ++i)
        if (values[1].u == s.live[call.gone][i].handle) return true;
    }
    return false;
  }

  void one() {
    const unsigned which = roams_ ? source_.below(6) : 0;
    const int at = which < 4 ? 0 : static_cast<int>(which) - 3;
    if (!take(at)) return;
    Stage& own = stages_[at];
    Stage& second = which < 4 ? stages_[1] : which == 4 ? stages_[0] : room_.nobody;
    Stage& other = which == 5 ? stages_[0] : stages_[2];
    Context c(own, other, second, source_);
    const unsigned sins = source_.below(8);  // 0 to 4: none
    c.wants_wrong = sins > 4, c.to_the_edge = to_the_edge_;
    const Row& row = choose();
    const Call call = row.make(c);
    std::vector<Value> values;
    for (const Argument& a : call.arguments) {
      if (a.impossible) return;
      values.push_back(a.good);
    }
    Codes expected = call.good_codes | (c.is_edged ? kPerhaps : 0);
    bool must_fail = false;
    std::string how;
    std::size_t sinned = SIZE_MAX;
    for (unsigned sin = sins > 4 ? sins == 7 ? 2 : 1 : 0; sin > 0 && !values.empty(); --sin) {
      const std::size_t k = source_.below(static_cast<unsigned>(values.size()));
      if (call.arguments[k].wrong.empty() || k == sinned) continue;
      sinned = k;
      const Wrong& w = call.arguments[k].wrong[source_.below(static_cast<unsigned>(call.arguments[k].wrong.size()))];
      values[k] = w.value;
      expected |= w.codes;
      must_fail = must_fail || !(w.codes & kFine);
      if (trace_) how += " " + std::to_string(k + 1) + ": " + w.what;
    }
    if (must_fail) expected &= ~kFine;
    if (!must_fail && call.alone) return;
    if (too_much(call, own, values)) return;
    if (trace_) heard_.trace += std::to_string(at) + " " + call.name + how + "\n";
    judge(call, values, expected, at, c);
  }

  void judge(const Call& call, const std::vector<Value>& values, Codes expected, int at, Context& c) {
    Stage& own = stages_[at];
    std::optional<Digest> whole;
    if (source_.below(16) == 0) whole.emplace(own);
    c.error = CAROM_ERROR_INIT;
    const bool steps = named(call, "carom_world_step");
    carom_world* const beside = steps && expected == kFine && heard_.calls % 4 == 0 ? copy_of(own) : nullptr;
    const int32_t r = call.invoke(values.data());
    ++heard_.calls;
    if (beside) step_beside(beside, values[1].d, own, r);
    if (trace_) heard_.trace += std::string("  ") + carom_result_name(r) + " " + c.error.message + "\n";
    const auto wrong = [&](const char* what) {
      complain(std::string(call.name) + ": " + what + " (" + carom_result_name(r) + ": " + c.error.message + ")");
    };
    if (r > 0 || r < kLastCode || !(expected & code(r))) wrong("an answer that the model does not expect");
    const auto changes = [&](int i) { return hash(stages_[i]) != hash_[i]; };
    for (int i = 0; trace_ && i < kWorlds; ++i)  // else looked at once, in the end
      if (i != at && changes(i)) wrong("changed another world");
    if (r != CAROM_OK && changes(at)) wrong("failed, and changed the world");
    if (r != CAROM_OK) {
      ++heard_.refused;
      if (whole && !(Digest(own) == *whole)) wrong("failed, and changed something");
      return;
    }
    if (call.undo) call.undo(values.data());
    hash_[at] = hash(own);
    if (steps) {
      ++heard_.steps;
      if (const std::string bad = not_finite(own.world); !bad.empty()) wrong(bad.c_str());
    }
    if (call.made >= 0) born(call, values, own, wrong);
    if (call.gone >= 0) own.dies(call.gone, values[1].u);
    if (call.made >= 0 || call.gone >= 0) count(own);
  }

  template <class F>
  void born(const Call& call, const std::vector<Value>& values, Stage& own, const F& wrong) {
    uint64_t handle = 0, a = 0, b = 0;
    std::memcpy(&handle, values[call.made_at].p, sizeof handle);
    for (const Owned& o : own.live[call.made])
      if (o.handle == handle) wrong("gave a handle that lives");
    for (const uint64_t s : own.stale[call.made])
      if (s == handle) wrong("gave the handle of what was destroyed");
    if (call.owner_at >= 0) a = values[static_cast<std::size_t>(call.owner_at)].u;
    if (call.made == kJoint && std::strcmp(call.name, "carom_joint_couple") == 0)
      a = static_cast<const carom_joint_coupling*>(values[1].p)->follower,
      b = static_cast<const carom_joint_coupling*>(values[1].p)->leader;
    else if (call.made == kJoint)
      a = static_cast<const carom_joint_desc*>(values[1].p)->body_a,
      b = static_cast<const carom_joint_desc*>(values[1].p)->body_b;
    if (call.made == kSpring)
      a = static_cast<const carom_spring_desc*>(values[1].p)->body_a,
      b = static_cast<const carom_spring_desc*>(values[1].p)->body_b;
    own.born(call.made, handle, a, b);
  }

  /// One in four is written down, and then done again: every step comes out as it did.
  void record() {
#ifdef CAROM_FUZZ_REPLAYS
    const auto keep = [](void* to, const void* bytes, uint64_t size) -> int32_t {
      const auto* const from = static_cast<const std::byte*>(bytes);
      static_cast<std::vector<std::byte>*>(to)->insert(static_cast<std::vector<std::byte>*>(to)->end(), from,
                                                       from + size);
      return 0;
    };
    if (carom_world_record_begin(stages_[0].world, CAROM_RECORD_STATES, keep, &session_, nullptr) != CAROM_OK)
      complain("a new world could not be recorded");
#endif
  }
  void replay() {
#ifdef CAROM_FUZZ_REPLAYS
    const int32_t ended = carom_world_record_end(stages_[0].world, nullptr);
    if (ended != CAROM_OK && ended != CAROM_E_NOT_FOUND) complain("a recording could not be ended");
    try {
      const auto outcome = tools::replay::play(stages_[0].engine, session_);
      ++heard_.replayed;
      if (!outcome.ended && !outcome.parting) complain("a recording has no end");
      if (!outcome.parting) return;
      const auto& p = *outcome.parting;
      for (const auto& line : p.calls) heard_.trace += "since the last step: " + line + "\n";
      for (const auto& line : p.details) heard_.trace += "parted: " + line + "\n";
      complain("a replay parts at step " + std::to_string(p.step) + ": " + p.sections + p.refused +
               (p.calls.empty() ? "" : " after " + p.calls.back()));
    } catch (const tools::Error& e) {
      if (e.code != CAROM_E_NOT_FOUND)
        complain(std::string("a recording cannot be played: ") + e.what());  // else its plugin is gone
    }
#endif
  }

  /// As many live as the model says.
  void count(const Stage& s) {
    uint64_t n = 0;
    if (carom_world_get_bodies(s.world, nullptr, 0, &n, nullptr) != CAROM_OK || n != s.live[kBody].size())
      complain("there are " + std::to_string(n) + " bodies, not " + std::to_string(s.live[kBody].size()));
    if (carom_world_get_joints(s.world, nullptr, 0, &n, nullptr) != CAROM_OK || n != s.live[kJoint].size())
      complain("there are " + std::to_string(n) + " joints, not " + std::to_string(s.live[kJoint].size()));
    if (carom_world_get_particles(s.world, nullptr, 0, &n, nullptr) != CAROM_OK || n != s.live[kParticles].size())
      complain("there are " + std::to_string(n) + " sets, not " + std::to_string(s.live[kParticles].size()));
    for (const Owned& o : s.live[kCollider]) {
      uint32_t sensor = 0;
      if (carom_collider_is_sensor(s.world, o.handle, &sensor, nullptr) != CAROM_OK)
        complain("a collider that should live does not");
    }
  }

  void tidy() {
    for (int i = 0; i < kWorlds; ++i)
      if (is_own_[i] && carom_world_destroy(stages_[i].world, nullptr) != CAROM_OK)
        complain("a world could not be destroyed");
    for (Stage& s : stages_)
      while (s.live[kShape].size() > room_.base_shapes) {
        if (carom_shape_destroy(s.engine, s.live[kShape].back().handle, nullptr) != CAROM_OK)
          complain("a shape could not be destroyed");
        s.live[kShape].pop_back();
      }
  }

  Room& room_ = room();
  Bytes bytes_;
  Chosen source_;
  bool trace_, to_the_edge_, records_, makes_anew_ = false, roams_ = false;
  unsigned solver_ = 0;
  Stage stages_[kWorlds];
  uint64_t hash_[kWorlds] = {};
  bool is_own_[kWorlds] = {};  // else it is the room's, which no call is made on
  std::vector<std::byte> session_;
  Heard heard_;
};

}  // namespace

Heard run_calls(const std::uint8_t* bytes, std::size_t size, bool trace, bool to_the_edge) {
  return Sequence(bytes, size, trace, to_the_edge).run(size);
}

}  // namespace carom::fuzz
