// Every function of the ABI with every wrong argument, one at a time (hostile/table.h): the result says what is wrong, the
// error names the argument and a remedy, outputs and worlds are as they were; or, where a number is extreme but legal, the
// world stays finite. A function without a row in the table fails this test.
#include <cstdio>
#include <fstream>
#include <regex>
#include <set>

#include "carom_test.h"
#include "hostile/table.h"
#include "sliced.h"

namespace {

using namespace hostile;

/// Choices of a generator (splitmix64) that begins anew with every call, so that a row comes out the same each time.
class Seeded : public Source {
 public:
  explicit Seeded(uint64_t seed) : seed_(seed) {}
  void begin(uint64_t row) { state_ = seed_ * 0x9E3779B97F4A7C15ull + row * 0xD1342543DE82EF95ull; }
  unsigned below(unsigned n) override { return static_cast<unsigned>(next() % n); }
  double unit() override { return static_cast<double>(next() >> 11) * 0x1p-53; }

 private:
  uint64_t next() {
    uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ (z >> 31);
  }
  uint64_t seed_, state_ = 0;
};

struct Stages {
  Stage own, other, second;
  Source first;
  Seeded* seeded = nullptr;  // or always the first choice

  Context context(const Row& row) {
    if (!seeded) return Context(own, other, second, first);
    seeded->begin(static_cast<uint64_t>(&row - kRows));
    return Context(own, other, second, *seeded);
  }

  bool make() {
    bool good = make_engine(own) && make_world(own) && make_engine(other) && make_world(other);
    second = own;
    good = good && make_world(second) && make_dead();
    return good;
  }
  /// A world in its first state again, after something was done to it.
  bool again() { return carom_world_destroy(own.world, nullptr) == CAROM_OK && make_world(own) && make_dead(); }
  /// Something of every kind that was destroyed.
  bool make_dead() {
    Context c(own, other, second, first);
    const double radius = 1;
    static const carom_shape_plugin spare = plugin_of("hostile.dead", kRadius, 1, &kSphereGeometry, point);
    uint64_t h[kKinds] = {};
    bool good = carom_plugin_register(own.engine, &spare, &h[kPlugin], nullptr) == CAROM_OK &&
                carom_shape_create(own.engine, h[kPlugin], &radius, 1, &h[kShape], nullptr) == CAROM_OK &&
                carom_shape_destroy(own.engine, h[kShape], nullptr) == CAROM_OK &&
                carom_plugin_unload(own.engine, h[kPlugin], nullptr) == CAROM_OK;
    own.stale[kPlugin].push_back(h[kPlugin]), own.stale[kShape].push_back(h[kShape]);
    const auto joint = fresh<carom_joint_desc>(carom_joint_desc_init);
    const auto field = fresh<carom_force_field_desc>(carom_force_field_desc_init);
    const auto material = fresh<carom_material_desc>(carom_material_desc_init);
    const carom_body body = add_body(own, CAROM_BODY_DYNAMIC, 0, 50, 50, 50);
    carom_joint_desc jd = joint;
    jd.body_a = body;
    auto sd = fresh<carom_spring_desc>(carom_spring_desc_init);
    sd.body_a = body;
    good = good && body && carom_joint_create(own.world, &jd, &h[kJoint], nullptr) == CAROM_OK &&
           carom_spring_create(own.world, &sd, &h[kSpring], nullptr) == CAROM_OK &&
           carom_force_field_create(own.world, &field, &h[kField], nullptr) == CAROM_OK &&
           carom_force_field_destroy(own.world, h[kField], nullptr) == CAROM_OK &&
           carom_material_create(own.world, &material, &h[kMaterial], nullptr) == CAROM_OK &&
           carom_material_destroy(own.world, h[kMaterial], nullptr) == CAROM_OK &&
           carom_particles_create(own.world, nullptr, &h[kParticles], nullptr) == CAROM_OK &&
           carom_particles_destroy(own.world, h[kParticles], nullptr) == CAROM_OK &&
           carom_body_destroy(own.world, body, nullptr) == CAROM_OK;
    own.born(kJoint, h[kJoint], body), own.born(kSpring, h[kSpring], body);
    own.dies(kBody, body);
    for (const int k : {kField, kMaterial, kParticles}) own.stale[k].push_back(h[k]);
    return good;
  }
  void clear() {
    carom_world_destroy(own.world, nullptr), carom_world_destroy(second.world, nullptr);
    carom_engine_destroy(own.engine, nullptr);
    carom_world_destroy(other.world, nullptr), carom_engine_destroy(other.engine, nullptr);
  }
};

void every_function_has_a_row(void**) {
  std::ifstream file(CAROM_SOURCE_DIR "/src/abi/carom.map");
  assert_true(file.good());
  const std::string text((std::istreambuf_iterator<char>(file)), {});
  std::set<std::string> exported, rows;
  const std::regex name("carom_[a-z0-9_]+(?=;)");
  for (std::sregex_iterator i(text.begin(), text.end(), name), end; i != end; ++i) exported.insert(i->str());
  for (const Row& row : kRows) rows.insert(row.name);
  for (const std::string& e : exported)
    if (!rows.count(e)) print_error("%s has no row in hostile/table.h\n", e.c_str());
  assert_true(exported.size() >= 162);
  assert_true(rows == exported);
  assert_int_equal(rows.size(), std::size(kRows));
}

/// The results that the comment of a function names, as bindings/api.json has them.
std::string documented_of(const std::string& function) {
  static const std::string text = [] {
    std::ifstream file(CAROM_SOURCE_DIR "/bindings/api.json");
    return std::string((std::istreambuf_iterator<char>(file)), {});
  }();
  const std::size_t begin = text.find("\"functions\"");
  const std::size_t at = text.find("\"name\": \"" + function + "\",\n   \"returns\"", begin);
  const std::size_t list = at == std::string::npos ? at : text.find("\"status\": [", at);
  return list == std::string::npos ? "" : text.substr(list, text.find(']', list) - list);
}
bool is_documented(const char* function, int32_t result) {
  const std::string name = carom_result_name(result);
  const std::string word = name.substr(name.find("CAROM_E_") == 0 ? 8 : 6);  // CAROM_OK
  return documented_of(function).find('"' + word + '"') != std::string::npos;
}

struct Tally {
  int calls = 0, refused = 0, taken = 0, bad = 0;
};

bool good_way(const Call& call, std::size_t at, std::size_t way) {
  return at == SIZE_MAX || way < call.arguments[at].wrong.size();
}

/// Make a call with argument `at` wrong in way `way`; at == SIZE_MAX: with none wrong.
void try_one(Stages& s, const Row& row, std::size_t at, std::size_t way, Tally& tally) {
  Context c = s.context(row);
  const Call call = row.make(c);
  if (!good_way(call, at, way)) return;  // other choices of another stage
  std::vector<Value> values;
  for (const Argument& a : call.arguments) values.push_back(a.good);
  const bool good = at == SIZE_MAX;
  const Wrong* wrong = good ? nullptr : &call.arguments[at].wrong[way];
  Codes expected = call.good_codes;
  if (wrong) {
    values[at] = wrong->value;
    // What is good alone may yet be refused for another reason that comes first (IN_USE, ...).
    const Codes first = s.seeded ? call.good_codes & ~kFine : call.good_codes & kInUse;
    expected = wrong->codes | (wrong->codes & kFine ? call.good_codes : first);
  }
  const Digest before(s.own);
  std::vector<std::string> outs;
  for (const Argument& a : call.arguments)
    outs.push_back(a.out ? std::string(static_cast<const char*>(a.out), a.out_size) : std::string());
  c.error = CAROM_ERROR_INIT;
  const int32_t r = call.invoke(values.data());
  ++tally.calls;
  const auto complain = [&](const char* what) {
    ++tally.bad;
    print_error("%s, argument %zu, %s: %s (got %s: %s)\n", call.name, good ? 0 : at + 1,
                wrong ? wrong->what.c_str() : "all good", what, carom_result_name(r), c.error.message);
  };
  if (r > 0 || r < kLastCode || !(expected & code(r))) complain("another result");
  // What is wrong with the error itself, and what gives a text, not a result, stand in ABI.md.
  if (!(wrong && r == CAROM_E_STRUCT_SIZE && at + 1 == call.arguments.size()) &&
      !documented_of(call.name).ends_with("[") && !is_documented(call.name, r))
    complain("its comment does not name this result");
  if (r == CAROM_OK) {
    ++tally.taken;
    if (call.undo) call.undo(values.data());
    if (call.gone == kPlugin || call.gone == kShape) s.own.dies(call.gone, values[1].u);
    const Digest after(s.own);
    if (call.gone >= 0 || !(after == before)) {
      // It did something: the world steps, and is finite whatever number it was given.
      const int32_t steps = carom_world_step(s.own.world, 1. / 64, nullptr);
      const std::string bad = not_finite(s.own.world);
      if (steps != CAROM_OK || !bad.empty()) complain(("the world does not go on: " + bad).c_str());
      assert_true(s.again());
    }
  } else {
    ++tally.refused;
    if (!(Digest(s.own) == before)) {
      complain("a call that failed has changed the world");
      assert_true(s.again());
    }
    for (std::size_t i = 0; i < outs.size(); ++i)
      if (call.arguments[i].out &&
          std::string(static_cast<const char*>(call.arguments[i].out), call.arguments[i].out_size) != outs[i] &&
          r != CAROM_E_PLUGIN_INVALID && !(r == CAROM_E_BUFFER_TOO_SMALL && call.arguments[i].out_size == 8))
        complain("a call that failed has written an output");
    const bool tells = !values.empty() && values.back().p == &c.error;
    if (tells) {
      const int32_t named =
          wrong ? wrong->argument >= 0 ? wrong->argument : static_cast<int32_t>(at) + 1 : c.error.argument;
      if (c.error.code != r) complain("the error has another code");
      if (!c.error.message[0] || !c.error.remedy[0]) complain("the error has no message or no remedy");
      if (c.error.argument != named && r != CAROM_E_IN_USE && !(s.seeded && call.good_codes & code(r)))
        complain(("the error names argument " + std::to_string(c.error.argument)).c_str());
    }
  }
}

void go_through_the_table(Stages& s, Tally& tally) {
  // Other choices are many: under a sanitizer they are of every seventh function.
  carom::test::OneOf turn(1, s.seeded ? 7 : 1);
  for (const Row& row : kRows) {
    if (!turn.next()) continue;
    std::vector<std::size_t> ways;
    bool alone = false, impossible = false;
    {
      Context c = s.context(row);
      const Call call = row.make(c);
      for (const Argument& a : call.arguments) {
        ways.push_back(a.wrong.size());
        impossible = impossible || a.impossible;
      }
      alone = call.alone;
    }
    if (impossible) print_error("%s has nothing good to be called with\n", row.name);
    assert_false(impossible);
    if (!alone) try_one(s, row, SIZE_MAX, 0, tally);
    for (std::size_t at = 0; at < ways.size(); ++at)
      for (std::size_t way = 0; way < ways[at]; ++way) try_one(s, row, at, way, tally);
  }
}

void every_wrong_argument_of_every_function_is_told_and_changes_nothing(void**) {
  Stages s;
  assert_true(s.make());
  Tally tally;
  const Digest other(s.other), second(s.second);
  go_through_the_table(s, tally);
  print_message("%d calls: %d refused, %d taken\n", tally.calls, tally.refused, tally.taken);
  assert_int_equal(tally.bad, 0);
  assert_true(Digest(s.other) == other && Digest(s.second) == second);  // nobody else has noticed
  s.clear();
}

void so_it_is_among_other_choices(void**) {
  Stages s;
  assert_true(s.make());
  Tally tally;
  for (uint64_t seed = 1; seed <= carom::test::sliced<uint64_t>(4, 1, 1); ++seed) {
    Seeded seeded(seed);
    s.seeded = &seeded;
    go_through_the_table(s, tally);
  }
  print_message("%d calls: %d refused, %d taken\n", tally.calls, tally.refused, tally.taken);
  assert_int_equal(tally.bad, 0);
  s.clear();
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_function_has_a_row),
      cmocka_unit_test(every_wrong_argument_of_every_function_is_told_and_changes_nothing),
      cmocka_unit_test(so_it_is_among_other_choices),
  };
  return cmocka_run_group_tests_name("abi/hostile", tests, nullptr, nullptr);
}
