// A script that makes one of everything, asks of everything and steps under every solver, with the k-th allocation failing, for
// every k by night and every fifth in CI: the call that it fails says OUT_OF_MEMORY and has changed nothing; called again it
// works, and the script goes on to its end. No leak, no block given back with another size.
#include <cstdlib>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "carom_test.h"
#include "hostile/table.h"
#include "sliced.h"

namespace {

using namespace hostile;

const uint64_t kEvery = carom::test::sliced<uint64_t>(1, 5, 41);

struct Memory {
  std::map<void*, std::pair<uint64_t, uint64_t>> live;
  uint64_t asked = 0, fails_at = ~uint64_t(0), wrong = 0;

  carom_engine_desc desc() {
    auto d = fresh<carom_engine_desc>(carom_engine_desc_init);
    d.alloc_user = this;
    d.alloc = [](void* user, uint64_t size, uint64_t alignment) -> void* {
      Memory& m = *static_cast<Memory*>(user);
      if (m.asked++ == m.fails_at) return nullptr;
      void* p = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment + (size ? 0 : alignment));
      m.live[p] = {size, alignment};
      return p;
    };
    d.free = [](void* user, void* p, uint64_t size, uint64_t alignment) {
      Memory& m = *static_cast<Memory*>(user);
      const auto at = m.live.find(p);
      if (at == m.live.end() || at->second != std::pair(size, alignment)) {
        ++m.wrong;
        return;
      }
      m.live.erase(at);
      std::free(p);
    };
    return d;
  }
};

struct Made {
  Stage s;
  carom_shape mesh = 0;
  carom_body sleeper = 0;
};
struct Line {
  std::string what;
  std::function<int32_t(Made&)> call;
  bool is_step = false;
};

carom_body body_at(const Made& m, std::size_t i) { return m.s.live[kBody][i].handle; }

/// Everything that may allocate, in an order in which each has something to work on.
std::vector<Line> script(double solver) {
  std::vector<Line> lines;
  const auto add = [&](std::string what, std::function<int32_t(Made&)> call) {
    lines.push_back({std::move(what), std::move(call)});
  };
  const auto steps = [&](int n) {
    for (int i = 0; i < n; ++i)
      lines.push_back({"step", [](Made& m) { return carom_world_step(m.s.world, 1. / 64, nullptr); }, true});
  };
  static const carom_shape_plugin* const plugins[] = {&kBall, &kCrate, &kLump};
  for (const carom_shape_plugin* p : plugins)
    add("plugin", [p](Made& m) {
      carom_plugin h;
      const int32_t r = carom_plugin_register(m.s.engine, p, &h, nullptr);
      if (!r) m.s.born(kPlugin, h);
      return r;
    });
  for (std::size_t i = 0; i < 3; ++i)
    add("shape", [i](Made& m) {
      const double half[3] = {0.5, 0.25, 0.75};
      carom_shape h;
      const int32_t r = carom_shape_create(m.s.engine, m.s.live[kPlugin][i].handle, half, i ? 3 : 1, &h, nullptr);
      if (!r) m.s.born(kShape, h);
      return r;
    });
  add("half-space", [](Made& m) {
    const double up[3] = {0, 1, 0};
    carom_shape h;
    const int32_t r = carom_shape_create_half_space(m.s.engine, up, 0, &h, nullptr);
    if (!r) m.s.born(kShape, h);
    return r;
  });
  add("mesh", [](Made& m) {
    const double corners[] = {-9, 0.1, -9, -9, 0.1, 9, 9, 0.1, 9, 9, 0.1, -9};
    const uint32_t triangles[] = {0, 1, 2, 0, 2, 3};
    auto d = fresh<carom_mesh_desc>(carom_mesh_desc_init);
    d.vertices = corners, d.vertex_count = 4, d.triangles = triangles, d.triangle_count = 2;
    const int32_t r = carom_shape_create_mesh(m.s.engine, &d, &m.mesh, nullptr);
    if (!r) m.s.born(kShape, m.mesh);
    return r;
  });
  add("height field", [](Made& m) {
    const double heights[4] = {-3, -3, -3, -3};
    auto d = fresh<carom_height_field_desc>(carom_height_field_desc_init);
    d.columns = d.rows = 2, d.heights = heights;
    carom_shape h;
    const int32_t r = carom_shape_create_height_field(m.s.engine, &d, &h, nullptr);
    if (!r) m.s.born(kShape, h);
    return r;
  });
  add("world", [](Made& m) { return carom_world_create(m.s.engine, nullptr, &m.s.world, nullptr); });
  add("solver", [solver](Made& m) { return carom_world_set_dial(m.s.world, CAROM_DIAL_SOLVER, solver, nullptr); });
  add("material", [](Made& m) {
    const auto d = fresh<carom_material_desc>(carom_material_desc_init);
    carom_material h;
    const int32_t r = carom_material_create(m.s.world, &d, &h, nullptr);
    if (!r) m.s.born(kMaterial, h);
    return r;
  });
  add("resistance", [](Made& m) {
    return carom_material_set_resistance(m.s.world, m.s.live[kMaterial][0].handle, 0.01, 0.01, nullptr);
  });
  const struct {
    uint32_t type;
    std::size_t shape;
    double x, y;
  } bodies[] = {{CAROM_BODY_STATIC, 3, 0, 0},      {CAROM_BODY_STATIC, 4, 20, 0},     {CAROM_BODY_DYNAMIC, 0, 0, 0.49},
                {CAROM_BODY_DYNAMIC, 1, 0.1, 1.2}, {CAROM_BODY_DYNAMIC, 2, 20, 0.34}, {CAROM_BODY_DYNAMIC, 0, 20, 1.1},
                {CAROM_BODY_KINEMATIC, 1, -5, 1},  {CAROM_BODY_DYNAMIC, 1, 3, 4}};
  for (const auto& b : bodies) {
    add("body", [b](Made& m) {
      auto d = fresh<carom_body_desc>(carom_body_desc_init);
      d.type = b.type, d.position[0] = b.x, d.position[1] = b.y;
      carom_body h;
      const int32_t r = carom_body_create(m.s.world, &d, &h, nullptr);
      if (!r) m.s.born(kBody, h);
      return r;
    });
    add("collider", [b](Made& m) {
      auto d = fresh<carom_collider_desc>(carom_collider_desc_init);
      d.shape = m.s.live[kShape][b.shape].handle, d.material = m.s.live[kMaterial][0].handle;
      carom_collider h;
      const int32_t r = carom_collider_create(m.s.world, m.s.live[kBody].back().handle, &d, &h, nullptr);
      if (!r) m.s.born(kCollider, h, m.s.live[kBody].back().handle);
      return r;
    });
  }
  steps(2);
  if (solver != CAROM_SOLVER_SEVERITY) {
    for (uint32_t kind = 0; kind < CAROM_JOINT_COUNT; kind += 2)
      add("joint", [kind](Made& m) {
        auto d = fresh<carom_joint_desc>(carom_joint_desc_init);
        d.kind = kind, d.fields = CAROM_JOINT_WORLD_FRAME;
        d.body_a = body_at(m, 2 + kind % 3), d.body_b = body_at(m, 7), d.position_a[1] = 1;
        carom_joint h;
        const int32_t r = carom_joint_create(m.s.world, &d, &h, nullptr);
        if (!r) m.s.born(kJoint, h, d.body_a, d.body_b);
        return r;
      });
    add("limit", [](Made& m) {
      auto d = fresh<carom_joint_limit>(carom_joint_limit_init);
      d.enabled = 1, d.lower = -1, d.upper = 1;
      return carom_joint_set_limit(m.s.world, m.s.live[kJoint][0].handle, CAROM_COORDINATE_TWIST, &d, nullptr);
    });
    add("locks", [](Made& m) { return carom_body_set_locks(m.s.world, body_at(m, 3), CAROM_LOCK_ANGULAR_X, nullptr); });
  }
  add("spring", [](Made& m) {
    auto d = fresh<carom_spring_desc>(carom_spring_desc_init);
    d.body_b = body_at(m, 3), d.anchor_a[1] = 3, d.stiffness = 10;
    carom_spring h;
    const int32_t r = carom_spring_create(m.s.world, &d, &h, nullptr);
    if (!r) m.s.born(kSpring, h, d.body_b);
    return r;
  });
  add("field", [](Made& m) {
    auto d = fresh<carom_force_field_desc>(carom_force_field_desc_init);
    d.vector[0] = 1;
    carom_force_field h;
    const int32_t r = carom_force_field_create(m.s.world, &d, &h, nullptr);
    if (!r) m.s.born(kField, h);
    return r;
  });
  add("set of particles", [](Made& m) {
    carom_particles h;
    const int32_t r = carom_particles_create(m.s.world, nullptr, &h, nullptr);
    if (!r) m.s.born(kParticles, h);
    return r;
  });
  add("particles", [](Made& m) {
    static const double x[40][3] = {};
    return carom_particles_add(m.s.world, m.s.live[kParticles][0].handle, 40, CAROM_SCALAR_F64, x, 0, nullptr, 0,
                               nullptr);
  });
  add("drag", [](Made& m) { return carom_body_set_drag(m.s.world, body_at(m, 3), 1, 1, nullptr); });
  add("water", [](Made& m) {
    const auto w = fresh<carom_water>(carom_water_init);
    return carom_world_set_water(m.s.world, &w, nullptr);
  });
  add("gravity factor", [](Made& m) { return carom_body_set_gravity_factor(m.s.world, body_at(m, 5), 0.5, nullptr); });
  add("mask", [](Made& m) { return carom_body_set_force_field_mask(m.s.world, body_at(m, 5), 2, nullptr); });
  add("effect", [](Made& m) {
    return carom_body_set_effect(m.s.world, body_at(m, 5), CAROM_EFFECT_GRAVITY, CAROM_MODE_FORBID, nullptr);
  });
  add("filter", [](Made& m) {
    return carom_collider_set_filter(m.s.world, m.s.live[kCollider][3].handle, 3, ~uint64_t(0), 0, nullptr);
  });
  add("held apart",
      [](Made& m) { return carom_body_ignore_collision(m.s.world, body_at(m, 2), body_at(m, 5), 1, nullptr); });
  add("sensor",
      [](Made& m) { return carom_collider_set_sensor(m.s.world, m.s.live[kCollider][6].handle, 1, nullptr); });
  add("surface velocity", [](Made& m) {
    const double v[3] = {1, 0, 0}, w[3] = {0, 0, 0};
    return carom_collider_set_surface_velocity(m.s.world, m.s.live[kCollider][0].handle, v, w, nullptr);
  });
  add("swept",
      [](Made& m) { return carom_body_set_continuous(m.s.world, body_at(m, 7), CAROM_CONTINUOUS_ALWAYS, nullptr); });
  add("events", [](Made& m) { return carom_world_collect_events(m.s.world, 31, 1, nullptr); });
  add("ledger", [](Made& m) { return carom_world_enable_ledger(m.s.world, 1, nullptr); });
  add("sleep", [](Made& m) { return carom_world_set_dial(m.s.world, CAROM_DIAL_SLEEP, 1, nullptr); });
  steps(3);
  add("accuracy", [](Made& m) {
    const auto a = fresh<carom_accuracy>(carom_accuracy_init);
    return carom_world_set_accuracy(m.s.world, &a, nullptr);
  });
  steps(2);
  add("growth", [](Made& m) {
    carom_growth growth = {};
    growth.struct_size = sizeof growth;
    return carom_world_measure_growth(m.s.world, 1.0 / 60, 2, &growth, nullptr);
  });
  add("no accuracy", [](Made& m) { return carom_world_set_accuracy(m.s.world, nullptr, nullptr); });
  add("ray", [](Made& m) {
    const double from[3] = {0, 9, 0}, down[3] = {0, -1, 0};
    carom_world_hit hit;
    return carom_world_cast_ray(m.s.world, from, down, 20, nullptr, &hit, sizeof hit, nullptr);
  });
  add("overlap", [](Made& m) {
    const double at[3] = {0, 0.5, 0};
    carom_query_shapes q = {};
    q.struct_size = sizeof q, q.scalar = CAROM_SCALAR_F64, q.count = 1, q.positions = at;
    uint64_t n;
    return carom_world_overlap_shapes(m.s.world, &q, nullptr, nullptr, 0, 0, &n, nullptr);
  });
  add("draw", [](Made& m) {
    uint64_t n;
    return carom_world_draw(m.s.world, nullptr, nullptr, 0, 0, &n, nullptr);
  });
  add("plan", [](Made& m) {
    static carom_plan_line plan[64];
    uint64_t n;
    return carom_world_get_plan(m.s.world, plan, sizeof *plan, 64, &n, nullptr);
  });
  add("recording", [](Made& m) {
    const int32_t r = carom_world_record_begin(
        m.s.world, 0, [](void*, const void*, uint64_t) { return 0; }, nullptr, nullptr);
    return r ? r : carom_world_record_end(m.s.world, nullptr);
  });
  for (const double broad : {CAROM_BROAD_BRUTE_FORCE, CAROM_BROAD_GRID, CAROM_BROAD_TREE}) {
    add("broad phase",
        [broad](Made& m) { return carom_world_set_dial(m.s.world, CAROM_DIAL_BROAD_PHASE, broad, nullptr); });
    steps(2);
  }
  add("body goes", [](Made& m) {
    const carom_body b = body_at(m, 7);
    const int32_t r = carom_body_destroy(m.s.world, b, nullptr);
    if (!r) m.s.dies(kBody, b);
    return r;
  });
  steps(2);
  return lines;
}

struct Outcome {
  uint64_t allocations = 0;
  std::string failed;  // which call was told so; empty: none
  bool hash_kept = true;
};

/// @param first  by line: allocations before it, of a run without a failure; empty: to be found
Outcome run(const std::vector<Line>& lines, uint64_t k, std::vector<uint64_t>& first) {
  Memory memory;
  const carom_engine_desc desc = memory.desc();
  Made m;
  Outcome outcome;
  memory.fails_at = k;
  int32_t r = carom_engine_create(&desc, &m.s.engine, nullptr);
  if (r == CAROM_E_OUT_OF_MEMORY) outcome.failed = "engine", r = carom_engine_create(&desc, &m.s.engine, nullptr);
  assert_int_equal(r, CAROM_OK);
  const bool finds = first.empty();
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& line = lines[i];
    if (finds) first.push_back(memory.asked);
    std::optional<Digest> before;
    uint64_t hash = 0;
    const bool fails_here = !finds && first[i] <= k && (i + 1 == lines.size() || k < first[i + 1]);
    if (fails_here && m.s.world) before.emplace(m.s), carom_world_hash(m.s.world, &hash, nullptr);
    r = line.call(m);
    if (r == CAROM_E_OUT_OF_MEMORY && outcome.failed.empty()) {
      outcome.failed = line.what;
      if (before) {
        uint64_t after = 0;
        assert_int_equal(carom_world_hash(m.s.world, &after, nullptr), CAROM_OK);
        outcome.hash_kept = hash == after;
        const bool kept = Digest(m.s) == *before;
        if (!kept && !line.is_step)
          print_error("allocation %llu: %s failed and changed something\n", static_cast<unsigned long long>(k),
                      line.what.c_str());
        assert_true(kept || line.is_step);
      }
      r = line.call(m);
    }
    if (r)
      print_error("allocation %llu: %s: %s\n", static_cast<unsigned long long>(k), line.what.c_str(),
                  carom_result_name(r));
    assert_int_equal(r, CAROM_OK);
    if (line.is_step) assert_true(not_finite(m.s.world).empty());
  }
  outcome.allocations = memory.asked;
  assert_int_equal(carom_world_destroy(m.s.world, nullptr), CAROM_OK);
  assert_int_equal(carom_engine_destroy(m.s.engine, nullptr), CAROM_OK);
  assert_int_equal(memory.live.size(), 0);
  assert_int_equal(memory.wrong, 0);
  return outcome;
}

void every_allocation_may_fail(void**) {
  // Auto has both soft_step and direct at work.
  for (const double solver : {CAROM_SOLVER_SEVERITY, CAROM_SOLVER_AUTO}) {
    const std::vector<Line> lines = script(solver);
    std::vector<uint64_t> first;
    const uint64_t all = run(lines, ~uint64_t(0), first).allocations;
    assert_true(all > 200);
    uint64_t tried = 0, told = 0, steps = 0, changed = 0;
    for (uint64_t k = 0; k < all; k += kEvery) {
      const Outcome o = run(lines, k, first);
      ++tried;
      told += !o.failed.empty();
      if (o.failed == "step") ++steps, changed += !o.hash_kept;
    }
    print_message(
        "solver %g: %llu allocations, %llu tried, %llu failures told, %llu of steps, after %llu of them the hash was another\n",
        solver, static_cast<unsigned long long>(all), static_cast<unsigned long long>(tried),
        static_cast<unsigned long long>(told), static_cast<unsigned long long>(steps),
        static_cast<unsigned long long>(changed));
    assert_true(told == tried && steps * kEvery > 100);
  }
}

}  // namespace

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(every_allocation_may_fail),
  };
  return cmocka_run_group_tests_name("abi/alloc_script", tests, nullptr, nullptr);
}
