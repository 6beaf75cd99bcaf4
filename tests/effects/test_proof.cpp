// The third promise, over every effect: what no body needs executes nothing, allocates nothing, and changes no bit;
// what one body needs is done for that one, from the step on in which it needs it to the last in which it does.
#include "carom_test.h"
#include "dynamics/plan_view.h"
#include "subjects.h"

using namespace carom;
using namespace carom::test;

namespace {

constexpr int kSteps = 12;

/// All bodies are its participants, or none.
bool is_for_all(std::size_t row) { return row == +EffectId::sleep || row == +EffectId::ledger; }

template <class... A>
void wrong(const char* form, A... values) {
  print_error(form, values...);
  print_error("\n");
  assert_true(false);
}

std::string name_of(std::size_t row) { return effect_table()[row].name; }

PlanLine line_of(const Stage0& s, std::size_t row) { return plan_line(s.t.world, kStageCount + row); }

/// Poses and velocities alone: what a world knows of contacts may differ with what it is asked for.
std::uint64_t bits_of_crowd(const Stage0& s) {
  Hash h;
  const State& st = s.t.world.state;
  for (std::uint32_t i = 0; i < st.x.size(); ++i)
    if (i != s.one && i != s.other && i != s.other_floor) {
      for (int k = 0; k < 3; ++k) h.add(st.x[i][k]), h.add(st.v[i][k]);
    }
  return h.value();
}

std::uint64_t run_with_mode(const Subject& subject, EffectMode mode, bool called) {
  Stage0 s;
  s.t.world.set_mode(subject.row, mode);
  if (called) subject.call(s);
  s.steps(kSteps);
  return s.t.world.hash();
}

/// An effect of contacts, of joints, or on velocities, in a scene of two balls that touch, one of which may hang on a
/// hinge.
struct ScenePart {
  std::size_t row;
  std::function<void(Stage0&, Material&)> prepare;  // the material before there is a contact
  std::function<void(Stage0&)> call;                // once there is one
  bool hangs = false;
};

std::vector<ScenePart> parts() {
  const auto set = [](Real Material::*what, Real value) { return [=](Stage0&, Material& m) { m.*what = value; }; };
  const auto drive = [](bool limit) {
    return [=](Stage0& s) {
      JointDrive d = s.t.world.joints.joint[handle_slot(s.thing)].drive[static_cast<std::size_t>(Coordinate::twist)];
      if (limit)
        d.limit.on = true, d.limit.lower = -0.01, d.limit.upper = 0.01;
      else
        d.motor.on = true, d.motor.speed = 1, d.motor.max_force = 5;
      s.t.world.set_joint_drive(handle_slot(s.thing), Coordinate::twist, d);
    };
  };
  std::vector<ScenePart> all = {
      {+EffectId::friction, set(&Material::friction, 0.5), {}},
      {+EffectId::restitution, set(&Material::restitution, 0.8), {}},
      {+EffectId::rolling_resistance, set(&Material::rolling, 0.05), {}},
      {+EffectId::spinning_resistance, set(&Material::spinning, 0.05), {}},
      {+EffectId::surface_velocity,
       {},
       [](Stage0& s) {
         s.t.world.set_surface_velocity(s.t.world.scene.first_collider[s.one], {Vec3(0, 0, 1), Vec3::zero()});
       }},
      {+EffectId::joint_limits, {}, drive(true), true},
      {+EffectId::joint_motors, {}, drive(false), true},
  };
  for (const Subject& subject : subjects())  // those that bring a collider of their own are not for this scene
    if (subject.flies && subject.row != +EffectId::gyroscopic && subject.row != +EffectId::buoyancy &&
        subject.row != +EffectId::springs)
      all.push_back({subject.row, {}, subject.call});
  return all;
}

/// Where two parts lead, of which one may be forbidden, or not be there.
struct Outcome {
  std::uint64_t bits = 0;
  std::vector<std::uint64_t> evaluations;  // of the first step
};

Outcome outcome_of(const ScenePart& a, const ScenePart& b, bool with_a, std::size_t forbidden) {
  Stage0 s(2);
  if (forbidden < kEffectCount) s.t.world.set_mode(forbidden, EffectMode::forbid);
  Material m;
  m.friction = 0;
  for (const ScenePart* part : {&a, &b})
    if (part->prepare && (part == &b || with_a)) part->prepare(s, m);
  s.touching(handle_slot(s.t.world.add_material(m)));
  s.t.world.set_velocity(s.one, Vec3(0.5, 0, 0), Vec3(1, 2, 3));
  if (a.hangs || b.hangs) {
    JointDef def;
    def.kind = JointKind::hinge;
    def.body_a = s.one;
    def.frame_b.p = s.t.world.pose(s.one).p;
    s.thing = s.t.world.add_joint(def);
  }
  for (const ScenePart* part : {&a, &b})
    if (part->call && (part == &b || with_a)) part->call(s);
  Outcome o;
  s.steps(1);
  for (const PlannedEffect& e : s.t.world.plan->effects) o.evaluations.push_back(e.evaluations);
  s.steps(kSteps);
  Hash h;
  const State& st = s.t.world.state;
  for (std::uint32_t i = 0; i < st.x.size(); ++i)
    for (int k = 0; k < 3; ++k) h.add(st.x[i][k]), h.add(st.v[i][k]), h.add(st.omega[i][k]);
  o.bits = h.value();
  return o;
}

}  // namespace

static void an_effect_without_participants_does_not_exist(void**) {
  for (const Subject& subject : subjects()) {
    Stage0 s;
    s.steps(kSteps);
    const PlannedEffect& effect = s.t.world.plan->effects[subject.row];
    if (effect.evaluations != 0 || effect.participants.runs.capacity() || effect.candidates.runs.capacity())
      wrong("%s ran or allocated without a participant", name_of(subject.row).c_str());
    const PlanLine line = line_of(s, subject.row);
    assert_false(line.runs);
    assert_int_equal(line.participants, 0);
    assert_int_equal(line.bytes, 0);
    assert_string_equal(line.reason, effect.effect->missing);
    // And the world has the bits of one in which it is forbidden.
    Stage0 f;
    f.t.world.set_mode(subject.row, EffectMode::forbid);
    f.steps(kSteps);
    assert_true(s.t.world.hash() == f.t.world.hash());
  }
}

static void a_forbidden_effect_does_nothing_and_says_so(void**) {
  for (const Subject& subject : subjects()) {
    Stage0 s;
    subject.call(s);
    s.t.world.set_mode(subject.row, EffectMode::forbid);
    s.steps(kSteps);
    if (s.evaluations(subject.row) != 0) wrong("%s ran though it is forbidden", name_of(subject.row).c_str());
    const PlanLine line = line_of(s, subject.row);
    assert_false(line.runs);
    assert_true(line.mode == EffectMode::forbid);
    assert_non_null(strstr(line.reason, "forbidden by the host"));
    const bool in_contacts = effect_table()[subject.row].participants == ParticipantKind::contact_points ||
                             effect_table()[subject.row].participants == ParticipantKind::contact_pairs;
    if (!in_contacts) {
      if (line.wanted != 1 && !is_for_all(subject.row) && subject.row != +EffectId::collision)
        wrong("%s is wanted by %d", name_of(subject.row).c_str(), static_cast<int>(line.wanted));
      assert_non_null(strstr(line.reason, "though the scene calls for it"));
    }
    // Allowed again, it runs.
    s.t.world.set_mode(subject.row, EffectMode::as_needed);
    s.steps(1);
    if (subject.row != +EffectId::restitution && s.evaluations(subject.row) == 0)
      wrong("%s did not come back", name_of(subject.row).c_str());
  }
}

static void forbidden_it_has_the_bits_of_a_scene_that_does_not_call_for_it(void**) {
  for (const Subject& subject : subjects()) {
    if (!subject.flies || subject.row == +EffectId::gyroscopic || subject.row == +EffectId::buoyancy ||
        subject.row == +EffectId::wind)
      continue;  // the scene of these has a collider, or drag, more
    const std::uint64_t quiet = run_with_mode(subject, EffectMode::as_needed, false);
    if (run_with_mode(subject, EffectMode::forbid, true) != quiet)
      wrong("%s left a trace though it was forbidden", name_of(subject.row).c_str());
    assert_true(run_with_mode(subject, EffectMode::as_needed, true) != quiet);  // and it would have done something
  }
  Stage0 still, windy;
  for (Stage0* s : {&still, &windy}) s->t.world.set_attribute(s->one, AttributeId::drag, {0.1, 0.1});
  windy.t.world.set_wind(Vec3(3, 0, 0));
  windy.t.world.set_mode(+EffectId::wind, EffectMode::forbid);
  still.steps(kSteps), windy.steps(kSteps);
  assert_true(still.t.world.hash() == windy.t.world.hash());
}

static void one_body_can_be_spared(void**) {
  for (const Subject& subject : subjects()) {
    if (subject.row == +EffectId::particles || subject.row == +EffectId::events || is_for_all(subject.row)) continue;
    Stage0 s;
    subject.call(s);
    s.t.world.set_body_mode(s.one, subject.row, EffectMode::forbid);
    if (subject.row == +EffectId::scenery) s.t.world.set_body_mode(s.other_floor, subject.row, EffectMode::forbid);
    s.steps(kSteps);
    const std::uint64_t served = s.evaluations(subject.row);
    // The other of the pair still is a collider that may collide.
    if (served != 0 && subject.row != +EffectId::collision)
      wrong("%s served a body it is forbidden to, %d times", name_of(subject.row).c_str(), static_cast<int>(served));
    s.t.world.set_body_mode(s.one, subject.row, EffectMode::as_needed);
    if (subject.row == +EffectId::scenery) s.t.world.set_body_mode(s.other_floor, subject.row, EffectMode::as_needed);
    s.steps(1);
    if (subject.row != +EffectId::restitution) assert_true(s.evaluations(subject.row) > served);
  }
}

static void participants_switch_it_on_and_off_in_mid_run(void**) {
  for (const Subject& subject : subjects()) {
    Stage0 s;
    s.steps(3);
    assert_int_equal(s.evaluations(subject.row), 0);
    subject.call(s);
    assert_int_equal(s.evaluations(subject.row), 0);
    s.steps(1);
    const std::uint64_t first = s.evaluations(subject.row);
    if (first == 0) wrong("%s did not begin in the next step", name_of(subject.row).c_str());
    assert_true(line_of(s, subject.row).runs);
    subject.dismiss(s);
    s.steps(3);
    if (s.evaluations(subject.row) != first) wrong("%s went on", name_of(subject.row).c_str());
    assert_false(line_of(s, subject.row).runs);
  }
}

static void one_among_ten_thousand_is_one(void**) {
  for (const Subject& subject : subjects()) {
    if (is_for_all(subject.row)) continue;
    std::uint64_t served[2];
    for (const int crowd : {0, 10000}) {
      Stage0 s(crowd);
      subject.call(s);
      s.steps(2);
      served[crowd > 0] = s.evaluations(subject.row);
      if (crowd == 0 || !subject.spares) continue;
      Stage0 quiet(crowd);
      quiet.steps(2);
      if (bits_of_crowd(s) != bits_of_crowd(quiet)) wrong("%s touched the crowd", name_of(subject.row).c_str());
    }
    if (served[0] != served[1] || served[0] == 0)
      wrong("%s served %d alone, %d among 10,000", name_of(subject.row).c_str(), static_cast<int>(served[0]),
            static_cast<int>(served[1]));
  }
}

/// Every two effects on velocities, with forces that read the state: what one does is what it does beside the other.
static void every_two_effects_compose(void**) {
  const auto flying = [] {
    std::vector<Subject> all = subjects();
    std::erase_if(all, [](const Subject& s) { return !s.flies || s.row == +EffectId::axis_locks; });
    return all;
  }();
  // What a kick of one step changes, with forces that are evaluated once at the state that the step begins with.
  const auto change = [&](std::initializer_list<const Subject*> calling, std::size_t forbidden) {
    Stage0 s;
    s.t.world.set_dial(Dial::integrator, 2);  // rk4: effects are forces, none a flow
    s.t.world.set_dial(Dial::substeps, 1);
    for (const Subject* subject : calling) subject->call(s);
    if (forbidden < kEffectCount) s.t.world.set_mode(forbidden, EffectMode::forbid);
    s.steps(1);
    const State& st = s.t.world.state;
    struct {
      std::vector<std::uint64_t> evaluations;
      Vec3 v, omega;
    } r;
    for (const PlannedEffect& e : s.t.world.plan->effects) r.evaluations.push_back(e.evaluations);
    r.v = st.v[s.one], r.omega = st.omega[s.one];
    return r;
  };
  for (const Subject& a : flying)
    for (const Subject& b : flying) {
      if (a.row == b.row) continue;
      if (a.row == +EffectId::drag && b.row == +EffectId::wind)
        continue;  // wind is what drag is relative to: without it, nothing
      const auto both = change({&a, &b}, kEffectCount), without = change({&a, &b}, a.row);
      // Switched off, nobody else is served more or less often.
      for (std::size_t row = 0; row < kEffectCount; ++row)
        if (row != a.row && !(row == +EffectId::wind && a.row == +EffectId::drag) &&
            both.evaluations[row] != without.evaluations[row])
          wrong("without %s, %s is served %d times instead of %d", name_of(a.row).c_str(), name_of(row).c_str(),
                static_cast<int>(without.evaluations[row]), static_cast<int>(both.evaluations[row]));
    }
}

/// Switched off, an effect leaves what it would leave if nothing called for it, to the bit, whatever other acts on the
/// same contact, joint or body; and the other is served as before.
static void every_two_effects_of_a_contact_compose(void**) {
  const std::vector<ScenePart> all = parts();
  int pairs = 0;
  for (const ScenePart& a : all)
    for (const ScenePart& b : all) {
      // Wind is what drag is relative to; without it drag is left, @see above.
      if (a.row == b.row || a.row == +EffectId::wind || (a.row == +EffectId::drag && b.row == +EffectId::wind))
        continue;
      const std::string names = name_of(a.row) + " beside " + name_of(b.row);
      const Outcome both = outcome_of(a, b, true, kEffectCount), off = outcome_of(a, b, true, a.row),
                    without = outcome_of(a, b, false, kEffectCount);
      if (off.bits != without.bits) wrong("%s, forbidden, leaves a trace", names.c_str());
      if (both.evaluations[a.row] == 0) wrong("%s is not served", names.c_str());
      for (std::size_t row = 0; row < kEffectCount; ++row)
        if (row != a.row && !(row == +EffectId::wind && a.row == +EffectId::drag) &&
            both.evaluations[row] != off.evaluations[row])
          wrong("%s: without it %s is served %d times instead of %d", names.c_str(), name_of(row).c_str(),
                static_cast<int>(off.evaluations[row]), static_cast<int>(both.evaluations[row]));
      ++pairs;
    }
  assert_true(pairs > 150);
}

/// At one state, what all effects do together is the sum of what each does alone.
static void accelerations_add_up(void**) {
  Stage0 s;
  World& w = s.t.world;
  w.set_dial(Dial::integrator, 2);
  for (const Subject& subject : subjects())
    if (subject.flies && subject.row != +EffectId::axis_locks) subject.call(s);
  w.scene.inertia[s.one] = Mat3::diagonal(Vec3(0.1, 0.2, 0.3));
  w.scene.inv_inertia[s.one] = w.scene.inertia[s.one].inverse();
  w.scene.def[s.one].linear_damping = 0.5;
  w.add_force(s.one, Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3));
  w.set_gravity(Vec3(0, -9.81, 0));
  s.steps(1);
  w.add_force(s.one, Vec3(1, 2, 3), Vec3(0.1, 0.2, 0.3));
  for (const char* host : {"user_force", "user_torque"})
    find_candidates(w, *w.plan->find(host)), w.plan->find(host)->participants = w.plan->find(host)->candidates;
  const State& st = w.state;
  const Motion at{st.x.data(), st.q.data(), st.v.data(), st.omega.data()};
  const std::size_t n = st.x.size();
  const auto evaluate = [&](const std::function<void(const Accelerate&)>& f) {
    std::vector<Vec3> v(n, Vec3::zero()), omega(n, Vec3::zero());
    f({1, v.data(), omega.data()});
    return std::pair(v[s.one], omega[s.one]);
  };
  const auto all = evaluate([&](const Accelerate& out) { evaluate_forces(w, at, out); });
  Vec3 v = Vec3::zero(), omega = Vec3::zero();
  Real size = 0;
  int rows = 0;
  for (PlannedEffect& row : w.plan->effects) {
    if (row.served != Served::force || row.participants.count == 0) continue;
    const auto alone =
        evaluate([&](const Accelerate& out) { row.effect->force(w.scene, st, row.participants, at, out); });
    v += alone.first, omega += alone.second;
    size += alone.first.norm() + alone.second.norm();
    ++rows;
  }
  assert_int_equal(rows, std::ranges::count_if(effect_table(), [](const Effect& e) { return e.force != nullptr; }));
  assert_true((all.first - v).norm() <= 32 * kEpsilon * size);
  assert_true((all.second - omega).norm() <= 32 * kEpsilon * size);
}

static void forced_on_everybody_it_changes_nothing(void**) {
  for (const std::size_t row : {+EffectId::gravity, +EffectId::linear_damping, +EffectId::angular_damping,
                                +EffectId::drag, +EffectId::fields}) {
    Stage0 quiet, forced;
    forced.t.world.set_mode(row, EffectMode::force);
    quiet.steps(kSteps), forced.steps(kSteps);
    assert_true(quiet.t.world.hash() == forced.t.world.hash());
    assert_true(forced.evaluations(row) > 0);
    assert_non_null(strstr(line_of(forced, row).reason, "forced by the host"));
    Stage0 single;
    single.t.world.set_body_mode(single.one, row, EffectMode::force);
    single.steps(1);
    assert_int_equal(line_of(single, row).participants, 1);
  }
  Stage0 nobody;  // there is no joint that could be forced
  nobody.t.world.set_mode(+EffectId::joints, EffectMode::force);
  nobody.steps(1);
  assert_false(line_of(nobody, +EffectId::joints).runs);
  assert_non_null(strstr(line_of(nobody, +EffectId::joints).reason, "nothing it can act on"));
}

static void without_response_things_touch_and_pass(void**) {
  Stage0 s;
  s.touching();
  s.t.world.set_velocity(s.one, Vec3(1, 0, 0), Vec3::zero());
  s.t.world.set_mode(+EffectId::response, EffectMode::forbid);
  s.steps(64);
  assert_true(s.t.world.state.v[s.one] == Vec3(1, 0, 0));
  assert_true(s.t.world.state.v[s.other] == Vec3::zero());
  assert_true(s.t.world.report.broad_pairs > 0 || s.t.world.state.x[s.one].x() > 1.5);
}

int main(void) {
  const CMUnitTest tests[] = {
      cmocka_unit_test(an_effect_without_participants_does_not_exist),
      cmocka_unit_test(a_forbidden_effect_does_nothing_and_says_so),
      cmocka_unit_test(forbidden_it_has_the_bits_of_a_scene_that_does_not_call_for_it),
      cmocka_unit_test(one_body_can_be_spared),
      cmocka_unit_test(participants_switch_it_on_and_off_in_mid_run),
      cmocka_unit_test(one_among_ten_thousand_is_one),
      cmocka_unit_test(every_two_effects_compose),
      cmocka_unit_test(every_two_effects_of_a_contact_compose),
      cmocka_unit_test(accelerations_add_up),
      cmocka_unit_test(forced_on_everybody_it_changes_nothing),
      cmocka_unit_test(without_response_things_touch_and_pass),
  };
  return cmocka_run_group_tests(tests, nullptr, nullptr);
}
