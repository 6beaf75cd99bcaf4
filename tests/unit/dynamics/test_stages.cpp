// The table of stages: it is what runs, what the page shows, and what the watch holds stages to.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include "carom_test.h"
#include "dynamics/stages.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

std::string list_of(Parts parts) {
  std::string out;
  for (std::size_t i = 0; i < kPartCount; ++i)
    if (parts.has(static_cast<Part>(i)))
      out += (out.empty() ? "" : ", ") + std::string(part_name(static_cast<Part>(i)));
  return out.empty() ? "-" : out;
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(text.size(), width), ' ');
  return text + "  ";
}

/// The picture of a step, a line a stage.
std::string picture() {
  std::ostringstream out;
  const auto line = [&](std::string name, const char* as, const std::string& writes, std::string_view what) {
    out << "    " << padded(std::move(name), 20) << padded(as, 9) << padded(writes, 54) << what << "\n";
  };
  line("stage", "as", "writes", "what happens");
  bool within = false;
  for (const StageEntry& entry : stage_table()) {
    if (entry.each_substep != within) out << (entry.each_substep ? "    each substep\n" : "    after the last\n");
    within = entry.each_substep;
    line((within ? "  " : "") + std::string(entry.name), stage_name(entry.stage), list_of(entry.writes), entry.what);
  }
  return out.str();
}

void the_picture_on_the_page_is_that_of_the_table(void**) {
  std::ifstream file(std::string(CAROM_SOURCE_DIR) + "/src/README.md");
  const std::string page((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  const std::string begin = "<!-- stages: tests/unit/dynamics/test_stages.cpp -->\n\n",
                    end = "\n<!-- end of stages -->";
  const std::size_t from = page.find(begin), to = page.find(end);
  assert_true(from != std::string::npos && to != std::string::npos);
  const std::string shown = page.substr(from + begin.size(), to - from - begin.size());
  if (shown != picture())
    print_error("src/README.md is to show between its two marks what `tests_unit_dynamics stages --picture` prints\n");
  assert_true(shown == picture());
}

/// A pile that falls, bounces, rolls and comes to rest; a swept ball; joints; particles: every stage has work, and none
/// writes what it does not declare (the watch ends the program where one does).
void no_stage_writes_what_it_does_not_declare(void**) {
  for (const Real solver : {kSeverityChoice, kSoftChoice, kDirectChoice, kAutoChoice}) {
    TestWorld t;
    t.world.watches_stages = true;
    t.world.set_dial(Dial::solver, solver);
    t.world.set_dial(Dial::sleep, 1);
    Material material;
    material.restitution = 0.5, material.rolling = 0.01, material.spinning = 0.01;
    const std::uint32_t rough = handle_slot(t.world.add_material(material));
    t.ground(rough);
    for (int i = 0; i < 6; ++i) {
      const std::uint32_t b = t.add(t.keep(i % 2 ? sphere(0.3) : box(Vec3(0.3, 0.2, 0.25))), Vec3(0.1 * i, 0.5 + i, 0),
                                    BodyType::dynamic, Quat::identity(), rough);
      t.world.set_velocity(b, Vec3(0, -1, 0.2 * i), Vec3(1, 2, 3));
    }
    const std::uint32_t shot = t.add(t.keep(sphere(0.05)), Vec3(-20, 1, 0));
    t.world.set_continuous(shot, SweepMode::always);
    t.world.set_velocity(shot, Vec3(300, 0, 0), Vec3::zero());
    t.world.keep_ledger(true);
    for (int i = 0; i < 120; ++i) {
      if (i == 40) t.world.add_force(shot, Vec3(0, 5, 0), Vec3(0, 0, 1));
      t.world.step(1.0 / 60);
    }
    assert_true(std::isfinite(t.world.state.x[shot].x()));
  }
}

/// What the watch is told of a stage decides, not what it is called.
void the_watch_names_what_a_stage_did_not_declare(void**) {
  TestWorld t;
  const std::uint32_t b = t.add(t.keep(sphere(0.3)), Vec3(0, 5, 0));
  t.world.step(1.0 / 60);
  static std::uint32_t body;
  body = b;
  StageEntry entry;
  entry.name = "test", entry.stage = Stage::solve;
  entry.run = [](World& w, const StepTime&) { w.state.v[body].x() += 1, w.state.x[body].y() -= 1; };
  entry.writes = Part::velocities;
  assert_int_equal(run_watched(entry, t.world, {0.1, 0.1}).bits, Parts(Part::poses).bits);
  entry.writes = Part::velocities | Part::poses;
  assert_int_equal(run_watched(entry, t.world, {0.1, 0.1}).bits, 0);
  entry.run = [](World&, const StepTime&) {};
  entry.writes = {};
  assert_int_equal(run_watched(entry, t.world, {0.1, 0.1}).bits, 0);
}

void writes_nothing(const World&, const StepTime&) {}
void writes_two(const World&, Velocities& to, StepReport&, SleepFlags&, const StepTime&) { to.v[0].x() += 1; }
void writes_many(const World&, Writes<Poses, Joints> to, Colliders&, const StepTime&) {
  Poses& poses = to;
  poses.x[0].x() += 1;
}

/// What a function receives is what its entry says that it writes; and it gets what is the world's.
void parameters_say_what_a_stage_writes(void**) {
  static_assert(writes_of(writes_nothing).bits == 0);
  static_assert(writes_of(writes_two).bits == (Part::velocities | Part::sleep).bits);
  static_assert(writes_of(writes_many).bits == (Part::poses | Part::joints | Part::colliders).bits);
  TestWorld t;
  t.add(t.keep(sphere(0.3)), Vec3(0, 5, 0));
  constexpr StageEntry two = stage<writes_two>({.name = "two", .what = ""}),
                       many = stage<writes_many>({.name = "many", .what = ""});
  assert_int_equal(run_watched(two, t.world, {0.1, 0.1}).bits, 0);
  assert_int_equal(run_watched(many, t.world, {0.1, 0.1}).bits, 0);
  assert_true(t.world.state.v[0].x() == 1 && t.world.state.x[0].x() == 1);
  for (const StageEntry& entry : stage_table())
    if (entry.name == "resist") assert_int_equal(entry.writes.bits, Parts(Part::velocities).bits);
}

/// Watching changes no bit.
void a_watched_world_steps_the_same_bits(void**) {
  std::uint64_t hash[2];
  for (const bool watched : {false, true}) {
    TestWorld t;
    t.world.watches_stages = watched;
    t.ground();
    for (int i = 0; i < 5; ++i) t.add(t.keep(box(Vec3(0.3, 0.2, 0.25))), Vec3(0.1 * i, 0.5 + i, 0));
    t.run(60, 1.0 / 60);
    hash[watched] = t.world.hash();
  }
  assert_true(hash[0] == hash[1]);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc > 1 && std::string(argv[1]) == "--picture") return std::fputs(picture().c_str(), stdout) < 0;
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_picture_on_the_page_is_that_of_the_table),
      cmocka_unit_test(no_stage_writes_what_it_does_not_declare),
      cmocka_unit_test(the_watch_names_what_a_stage_did_not_declare),
      cmocka_unit_test(parameters_say_what_a_stage_writes),
      cmocka_unit_test(a_watched_world_steps_the_same_bits),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
