// Queries of a world beside their twins, which ask every collider: the same answers to the bit, whatever happened to
// the world since the tree was made, under every broad phase.
#include <cstring>

#include "carom_test.h"
#include "dynamics/query/index.h"
#include "dynamics/query/query.h"
#include "random_pairs.h"
#include "world_builder.h"

using namespace carom;
using namespace carom::test;

namespace {

struct Park : TestWorld {
  explicit Park(std::uint64_t seed, Real half = 6) : random(seed), spread(half) {
    ground();
    for (int family = 0; family < kFamilyCount; ++family)
      for (int k = 0; k < 3; ++k) {
        pool.push_back(keep(random_shape(random, family)));
        if (family == 3 || family == 4 || family == 8)  // hulls and what has no form: their masses do not matter here
          shapes.back().mass = mass_from_form(Form::sphere, 0.5, 0, Vec3::zero(), {});
      }
  }
  const Shape* any_shape() { return pool[static_cast<std::size_t>(random.uniform(0, Real(pool.size())))]; }

  std::uint32_t add_body() {
    const Real kind = random.uniform(0, 1);
    BodyDef def;
    def.type = kind < 0.2 ? BodyType::fixed : kind < 0.3 ? BodyType::kinematic : BodyType::dynamic;
    def.pose = {random_rotation(random), random.in_cube(spread) + Vec3(0, spread + 1, 0)};
    if (def.type == BodyType::kinematic) def.velocity = random.in_cube(1), def.omega = random.in_cube(1);
    const std::uint32_t body = handle_slot(world.add_body(def));
    const int parts = random.uniform(0, 1) < 0.2 ? 2 : 1;
    for (int k = 0; k < parts; ++k)
      world.add_collider(body, any_shape(), Pose{random_rotation(random), random.in_cube(0.5)}, 1000,
                         Colliders::kNoMaterial);
    bodies.push_back(body);
    return body;
  }
  void remove_one() {
    if (bodies.empty()) return;
    const auto i = static_cast<std::size_t>(random.uniform(0, Real(bodies.size())));
    world.remove_body(bodies[i]);
    bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(i));
  }
  void move_one() {
    const std::uint32_t body = bodies[static_cast<std::size_t>(random.uniform(0, Real(bodies.size())))];
    world.set_pose(body, {random_rotation(random), random.in_cube(spread) + Vec3(0, spread, 0)});
  }
  /// Some are hidden by their filter, some see only questions of category 2.
  void filter_one() {
    Array<Filter>& filter = world.scene.colliders.filter;
    filter.resize(world.scene.colliders.slots());
    filter[world.scene.colliders
               .live[static_cast<std::size_t>(random.uniform(0, Real(world.scene.colliders.live.size())))]] = {2, 5, 0};
  }

  Random random;
  Real spread;  // m
  std::vector<const Shape*> pool;
  std::vector<std::uint32_t> bodies;
};

bool same_bits(const CastResult& a, const CastResult& b) {
  const auto same = [](const auto& x, const auto& y) { return std::memcmp(&x, &y, sizeof x) == 0; };
  return a.outcome == b.outcome && a.status == b.status && same(a.time, b.time) && same(a.lower, b.lower) &&
         same(a.upper, b.upper) && same(a.separation, b.separation) && same(a.normal, b.normal) &&
         same(a.point_a, b.point_a) && same(a.point_b, b.point_b);
}

template <class F>
void each_collider(const World& world, const QueryFilter& filter, F&& f) {
  for (const std::uint32_t slot : world.scene.colliders.live)
    if (takes_part(world, slot) && passes(world, filter, slot)) f(slot);
}

/// The index is where the colliders are: bodies move, tables don't.
void assert_in_place(const World& world) {
  world.queries->bring_up_to_date(world);
  std::size_t there = 0;
  each_collider(world, {}, [&](std::uint32_t slot) {
    const Frame now = collider_frame(world, slot), &kept = world.queries->frame(slot);
    assert_true(std::memcmp(&now, &kept, sizeof now) == 0);
  });
  world.queries->each([&](std::uint32_t slot) {
    ++there;
    assert_true(world.scene.collider_slots.alive(slot) && takes_part(world, slot));
  });
  std::size_t expected = 0;
  for (const std::uint32_t slot : world.scene.colliders.live) expected += takes_part(world, slot);
  assert_int_equal(there, expected);
}

struct Tally {
  int hits = 0, misses = 0, overlaps = 0;
  void count(CastOutcome outcome) {
    hits += outcome == CastOutcome::hit;
    misses += outcome == CastOutcome::miss;
    overlaps += outcome == CastOutcome::overlap;
  }
};

bool earlier(const WorldHit& a, const WorldHit& b) {
  return a.cast.time < b.cast.time || (a.cast.time == b.cast.time && a.collider < b.collider);
}

void assert_same(const WorldHit& found, const WorldHit& truth) {
  assert_int_equal(found.collider, truth.collider);
  assert_true(same_bits(found.cast, truth.cast));
}

void assert_same(const Array<WorldHit>& found, const Array<WorldHit>& truth) {
  assert_int_equal(found.size(), truth.size());
  for (std::size_t i = 0; i < found.size(); ++i) assert_same(found[i], truth[i]);
}

template <class One>
Array<WorldHit> ask_all(const World& world, const QueryOptions& options, One&& one) {
  Array<WorldHit> hits;
  world.queries->bring_up_to_date(world);
  each_collider(world, options.filter, [&](std::uint32_t slot) {
    const WorldHit hit = one(slot);
    if (hit.cast.outcome != CastOutcome::miss) hits.push_back(hit);
  });
  return hits;
}

CastOutcome whether(const Array<WorldHit>& hits) {
  bool unsure = false;
  for (const WorldHit& h : hits) {
    if (h.cast.outcome == CastOutcome::hit || h.cast.outcome == CastOutcome::overlap) return CastOutcome::hit;
    unsure |= h.cast.status != QueryStatus::fault;
  }
  return unsure ? CastOutcome::undecided : CastOutcome::miss;
}

void ask_rays(Park& park, int count, Tally& tally) {
  const World& world = park.world;
  for (int i = 0; i < count; ++i) {
    QueryOptions options;
    options.cast.routines = i % 4 != 0;
    if (i % 5 == 0) options.cast.target = park.random.uniform(0, 0.5);
    if (i % 6 == 0 && !park.bodies.empty()) options.filter.ignore = park.bodies[park.bodies.size() / 2];
    if (i % 7 == 0) options.filter.mask = 1;
    if (i % 9 == 0) options.filter.category = 4;
    const Vec3 from = park.random.in_cube(1.5 * park.spread) + Vec3(0, park.spread, 0);
    Ray ray{from, park.random.in_cube(park.spread) + Vec3(0, park.spread, 0) - from, park.random.uniform(0, 3)};
    if (i % 10 == 0) ray.direction = Vec3(0, -1, 0), ray.max = kInfinity;
    if (i % 33 == 0) ray.direction.set_zero();
    if (i % 17 == 0) ray.origin -= 1e5 * ray.direction, ray.max = 2e5;
    const auto one = [&](std::uint32_t slot) { return ray_against(world, slot, ray, options.cast); };
    Array<WorldHit> truth = ask_all(world, options, one);
    std::sort(truth.begin(), truth.end(), earlier);
    const WorldHit first = cast_ray(world, ray, options);
    if (truth.empty()) {
      assert_int_equal(first.collider, kInvalid);
      assert_true(first.cast.outcome == CastOutcome::miss && first.cast.time == ray.max);
    } else {
      assert_same(first, truth[0]);
    }
    tally.count(first.cast.outcome);
    Array<WorldHit> all;
    cast_ray_all(world, ray, options, all);
    assert_same(all, truth);
    assert_int_equal(static_cast<int>(any_on_ray(world, ray, options).outcome), static_cast<int>(whether(truth)));
  }
}

void ask_shapes(Park& park, int count, Tally& tally) {
  const World& world = park.world;
  for (int i = 0; i < count; ++i) {
    QueryOptions options;
    options.cast.routines = i % 2 != 0;
    if (i % 5 == 0) options.cast.target = park.random.uniform(0, 0.5);
    if (i % 7 == 0) options.filter.mask = 1;
    const QueryShape query_shape{
        park.any_shape(),
        Frame(random_rotation(park.random).matrix(), park.random.in_cube(1.5 * park.spread) + Vec3(0, park.spread, 0))};
    Vec3 motion = park.random.in_cube(1.5 * park.spread);
    if (i % 13 == 0) motion.set_zero();
    Array<WorldHit> truth = ask_all(world, options, [&](std::uint32_t slot) {
      return shape_against(world, slot, query_shape, motion, options.cast);
    });
    std::sort(truth.begin(), truth.end(), earlier);
    const WorldHit first = cast_shape(world, query_shape, motion, options);
    if (truth.empty())
      assert_int_equal(first.collider, kInvalid);
    else
      assert_same(first, truth[0]);
    tally.count(first.cast.outcome);
    Array<WorldHit> all;
    cast_shape_all(world, query_shape, motion, options, all);
    assert_same(all, truth);
    assert_int_equal(static_cast<int>(any_on_way(world, query_shape, motion, options).outcome),
                     static_cast<int>(whether(truth)));

    Array<WorldHit> overlaps;
    find_overlaps(world, query_shape, options, overlaps);
    assert_same(overlaps, ask_all(world, options, [&](std::uint32_t slot) {
                  return overlap_against(world, slot, query_shape, options.cast);
                }));

    const Real reach = i % 3 ? park.random.uniform(0, 3) : kInfinity;
    const Shape dot = sphere(0);
    const QueryShape nearby{i % 2 ? query_shape.shape : &dot, query_shape.frame};
    const Array<WorldHit> near = ask_all(
        world, options, [&](std::uint32_t slot) { return nearest_against(world, slot, nearby, reach, options.cast); });
    const auto nearest = std::min_element(near.begin(), near.end(), [](const WorldHit& a, const WorldHit& b) {
      return a.cast.separation < b.cast.separation;
    });
    const WorldHit found = find_nearest(world, nearby, reach, options);
    if (near.empty())
      assert_int_equal(found.collider, kInvalid);
    else
      assert_same(found, *nearest);
  }
}

}  // namespace

static void answers_are_those_of_asking_everybody(void**) {
  Tally rays, ways;
  for (int broad = 0; broad < 4; ++broad) {
    Park park(100 + static_cast<std::uint64_t>(broad));
    park.world.set_dial(Dial::broad_phase, broad);
    park.world.set_dial(Dial::sleep, 1);
    park.world.set_dial(Dial::sleep_time, 0.1);
    ask_rays(park, 20, rays);  // a plane and nothing else
    for (int i = 0; i < 60; ++i) park.add_body();
    for (int round = 0; round < 12; ++round) {
      assert_in_place(park.world);
      ask_rays(park, 60, rays);
      ask_shapes(park, 20, ways);
      switch (round % 4) {
        case 0:
          park.run(3, 1.0 / 60);
          break;
        case 1:
          for (int i = 0; i < 4; ++i) park.move_one();
          park.filter_one();
          break;
        case 2:
          for (int i = 0; i < 5; ++i) park.remove_one();
          park.add_body();
          park.run(1, 1.0 / 60);
          break;
        default:
          for (int i = 0; i < 8; ++i) park.add_body();
          park.move_one();
      }
    }
    for (int i = 0; i < 400 && park.world.report.asleep_bodies < 5; ++i) park.world.step(1.0 / 60);
    assert_true(park.world.report.asleep_bodies >= 5);
    assert_in_place(park.world);
    ask_rays(park, 100, rays);
    ask_shapes(park, 30, ways);
  }
  assert_true(rays.hits > 1000 && rays.misses > 200 && rays.overlaps > 50);
  assert_true(ways.hits > 200 && ways.misses > 20 && ways.overlaps > 100);
}

static void the_same_under_every_broad_phase(void**) {
  // Poses do not depend on the broad phase; nor may answers, whose index has seen the same history.
  Array<WorldHit> first;
  for (int broad = 0; broad < 4; ++broad) {
    Park park(7);
    park.world.set_dial(Dial::broad_phase, broad);
    for (int i = 0; i < 40; ++i) park.add_body();
    Array<WorldHit> all;
    for (int round = 0; round < 10; ++round) {
      park.run(5, 1.0 / 60);
      for (int i = 0; i < 30; ++i) {
        const Vec3 from = park.random.in_cube(9) + Vec3(0, 9, 0);
        all.push_back(cast_ray(park.world, {from, Vec3(0, 3, 0) - from, 2}, {}));
      }
    }
    if (broad == 0)
      first = all;
    else
      assert_same(all, first);
  }
}

static void far_out_and_beyond(void**) {
  // A crowd 1e7 m from the origin with one that left it for 1e12 m, and questions from where no short number reaches.
  Park park(8, 4);
  const Vec3 far(1e7, 0, -3e7);
  park.world.set_gravity(Vec3::zero());
  for (int i = 0; i < 50; ++i) {
    const std::uint32_t body = park.add_body();
    Pose pose = park.world.pose(body);
    pose.p += i == 17 ? Vec3(1e12, 0, 0) : far;
    park.world.set_pose(body, pose);
  }
  const World& world = park.world;
  int hits = 0;
  for (int i = 0; i < 300; ++i) {
    Vec3 from = far + park.random.in_cube(8);
    if (i % 3 == 0) from += 1e6 * park.random.direction();
    if (i % 10 == 0) from += 1e13 * park.random.direction();
    if (i % 50 == 0) from += 1e20 * park.random.direction();
    const Ray ray{from, far + park.random.in_cube(4) + Vec3(0, 5, 0) - from, 2};
    QueryOptions options;
    Array<WorldHit> truth =
        ask_all(world, options, [&](std::uint32_t slot) { return ray_against(world, slot, ray, options.cast); });
    std::sort(truth.begin(), truth.end(), earlier);
    Array<WorldHit> all;
    cast_ray_all(world, ray, options, all);
    assert_same(all, truth);
    const WorldHit found = cast_ray(world, ray, options);
    if (!truth.empty()) assert_same(found, truth[0]);
    hits += found.cast.outcome == CastOutcome::hit;
  }
  assert_true(hits > 50);
}

static void what_stands_on_a_lattice_is_met_along_its_faces(void**) {
  // Boxes whose faces lie in common planes, asked along those planes, edges and diagonals, from near and from far off.
  TestWorld t;
  const Shape* cube = t.keep(box(Vec3::constant(0.5)));
  Random random(11);
  for (int i = 0; i < 60; ++i) {
    const Vec3 at = random.in_cube(4);
    t.add(cube, Vec3(std::round(at.x()), std::round(at.y()), std::round(at.z())), BodyType::fixed);
  }
  const World& world = t.world;
  const auto step = [&] { return std::round(random.uniform(-1.49, 1.49)); };
  int hits = 0, grazes = 0;
  for (Real far = 1; far < 1e15; far *= 10)
    for (int i = 0; i < 150; ++i) {
      const Vec3 direction = i % 3 ? Vec3(Vec3::unit(i % 5 % 3) * (i % 2 ? 1 : -1)) : Vec3(step(), step(), step());
      if (direction.is_zero()) continue;
      const Vec3 in = random.in_cube(9);
      const Vec3 through(std::round(in.x()) / 2, std::round(in.y()) / 2, std::round(in.z()) / 2);
      const Ray ray{through - far * direction, direction, i % 4 ? 2 * far : kInfinity};
      Array<WorldHit> truth = ask_all(world, {}, [&](std::uint32_t slot) { return ray_against(world, slot, ray, {}); });
      std::sort(truth.begin(), truth.end(), earlier);
      Array<WorldHit> all;
      cast_ray_all(world, ray, {}, all);
      assert_same(all, truth);
      if (!truth.empty()) assert_same(cast_ray(world, ray, {}), truth[0]);
      hits += !truth.empty(), grazes += truth.size() > 1 && truth[0].cast.time == truth[1].cast.time;
      const QueryShape query_shape{cube, Frame(Mat3::identity(), ray.origin)};
      const Vec3 motion = 2 * far * direction;
      truth =
          ask_all(world, {}, [&](std::uint32_t slot) { return shape_against(world, slot, query_shape, motion, {}); });
      std::sort(truth.begin(), truth.end(), earlier);
      all.clear();
      cast_shape_all(world, query_shape, motion, {}, all);
      assert_same(all, truth);
      truth = ask_all(world, {}, [&](std::uint32_t slot) { return overlap_against(world, slot, query_shape, {}); });
      all.clear();
      find_overlaps(world, query_shape, {}, all);
      assert_same(all, truth);
    }
  assert_true(hits > 700 && grazes > 50);
}

static void rays_see_what_lies_where_it_should(void**) {
  // No twin: a row of balls of radius 0.5 at x = 0, 2, 4 ..., 1 m above the ground.
  TestWorld t;
  t.ground();
  const Shape* ball = t.keep(sphere(0.5));
  std::vector<std::uint32_t> row;
  for (int i = 0; i < 50; ++i) row.push_back(t.add(ball, Vec3(2 * i, 1, 0), BodyType::fixed));
  const World& w = t.world;
  const Ray along{Vec3(-3, 1, 0), Vec3(1, 0, 0), kInfinity};
  WorldHit hit = cast_ray(w, along, {});
  assert_true(w.scene.colliders.body[hit.collider] == row[0] && std::fabs(hit.cast.time - 2.5) < 1e-12);
  QueryOptions options;
  options.filter.ignore = row[0];
  hit = cast_ray(w, along, options);
  assert_true(w.scene.colliders.body[hit.collider] == row[1] && std::fabs(hit.cast.time - 4.5) < 1e-12);
  Array<WorldHit> all;
  cast_ray_all(w, along, {}, all);
  assert_int_equal(all.size(), 50);
  for (std::size_t i = 0; i < all.size(); ++i) {
    assert_int_equal(w.scene.colliders.body[all[i].collider], row[i]);
    assert_true(std::fabs(all[i].cast.time - (2.5 + 2 * Real(i))) < 1e-12);
  }
  hit = cast_ray(w, {Vec3(1, 9, 0), Vec3(0, -1, 0), 100}, {});
  assert_true(hit.collider == 0 && std::fabs(hit.cast.time - 9) < 1e-12);  // the ground
  const Shape dot = sphere(0);
  hit = find_nearest(w, {&dot, Frame(Mat3::identity(), Vec3(6.1, 1.7, 0))}, 10, {});
  assert_true(w.scene.colliders.body[hit.collider] == row[3]);
  assert_true(std::fabs(hit.cast.separation - (std::hypot(0.1, 0.7) - 0.5)) < 1e-12);
  hit = find_nearest(w, {&dot, Frame(Mat3::identity(), Vec3(6.1, 1.7, 0))}, 0.2, {});
  assert_int_equal(hit.collider, kInvalid);
}

/// A pose that a world gives comes back with its own bits, however it came about: so a pair that a host asks about at
/// the poses of two bodies is the pair that a world sees.
static void a_pose_that_a_world_gives_is_one_that_it_takes(void**) {
  int scaled_anew = 0;
  for (int integrator = 0; integrator < 4; ++integrator) {
    Park park(40 + static_cast<std::uint64_t>(integrator));
    World& w = park.world;
    w.set_dial(Dial::integrator, integrator);
    for (int i = 0; i < 60; ++i) park.add_body();
    for (int round = 0; round < 30; ++round) {
      for (const std::uint32_t body : park.bodies) {
        const Quat q = w.pose(body).q, as_given = oriented(q), again = normalized(q);
        assert_true(std::memcmp(&as_given, &q, sizeof q) == 0);
        scaled_anew += std::memcmp(&again, &q, sizeof q) != 0;
      }
      park.run(1, 1.0 / 60);
      for (int i = 0; i < 4; ++i) park.move_one();
    }
  }
  assert_true(scaled_anew > 100);
}

static void equals_go_to_the_lowest_slot(void**) {
  TestWorld t;
  const Shape* crate = t.keep(box(Vec3(1, 1, 1)));
  for (int i = 0; i < 20; ++i) t.add(crate, Vec3(0, 0, 0), BodyType::fixed);  // one in the other
  Array<WorldHit> all;
  cast_ray_all(t.world, {Vec3(-5, 0.1, 0.2), Vec3(1, 0, 0), 10}, {}, all);
  assert_int_equal(all.size(), 20);
  for (std::uint32_t i = 0; i < 20; ++i) assert_int_equal(all[i].collider, i);
  assert_int_equal(cast_ray(t.world, {Vec3(-5, 0.1, 0.2), Vec3(1, 0, 0), 10}, {}).collider, 0);
  t.world.remove_collider(0);
  assert_int_equal(cast_ray(t.world, {Vec3(-5, 0.1, 0.2), Vec3(1, 0, 0), 10}, {}).collider, 1);
  const Shape dot = sphere(0);
  assert_int_equal(find_nearest(t.world, {&dot, Frame(Mat3::identity(), Vec3(0, 3, 0))}, 10, {}).collider, 1);
}

static void invalid_plugins_are_met_where_their_bounds_are(void**) {
  TestWorld t(Vec3::zero());
  const Shape* crate = t.keep(box(Vec3(1, 1, 1)));
  // Valid along the axes, where bounds are asked for, and an invalid plugin elsewhere.
  Shape invalid_plugin = box(Vec3(1, 1, 1));
  invalid_plugin.form = Form::none;
  invalid_plugin.support = [](void* user, const double* p, std::uint64_t n, const double* d,
                              double* out) -> std::int32_t {
    const int zeros = (d[0] == 0) + (d[1] == 0) + (d[2] == 0);
    return zeros == 2 ? box_support(user, p, n, d, out) : 9;
  };
  const Shape* bad = t.keep(std::move(invalid_plugin));
  const std::uint32_t behind = t.add(crate, Vec3(6, 0, 0), BodyType::fixed);
  BodyDef def;
  def.type = BodyType::fixed;
  const std::uint32_t body = handle_slot(t.world.add_body(def));
  t.world.add_collider(body, bad, Pose{}, 0, Colliders::kNoMaterial);
  (void)behind;
  const Ray ray{Vec3(-5, 0.25, 0.125), Vec3(2, 0.0625, 0.03125), 10};
  WorldHit hit = cast_ray(t.world, ray, {});
  assert_true(hit.collider == 1 && hit.cast.status == QueryStatus::fault && std::fabs(hit.cast.time - 2) < 1e-9);
  assert_true(any_on_ray(t.world, ray, {}).outcome == CastOutcome::hit);  // the crate behind it
  Array<WorldHit> all;
  cast_ray_all(t.world, ray, {}, all);
  assert_true(all.size() == 2 && all[1].collider == 0);
  t.world.plan->faulty.push_back(bad);  // as a step does that comes upon it
  ++t.world.scene.collider_revision;
  hit = cast_ray(t.world, ray, {});
  assert_true(hit.collider == 0 && hit.cast.outcome == CastOutcome::hit);
}

static void a_world_that_is_not_asked_keeps_no_index(void**) {
  Park park(9);
  for (int i = 0; i < 30; ++i) park.add_body();
  park.run(10, 1.0 / 60);
  assert_false(park.world.queries->in_use());
  const std::uint64_t hash = park.world.hash();
  cast_ray(park.world, {Vec3(0, 20, 0), Vec3(0, -1, 0), 30}, {});
  assert_true(park.world.queries->in_use());
  assert_true(park.world.hash() == hash);  // observing changes nothing
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(answers_are_those_of_asking_everybody),
      cmocka_unit_test(the_same_under_every_broad_phase),
      cmocka_unit_test(far_out_and_beyond),
      cmocka_unit_test(what_stands_on_a_lattice_is_met_along_its_faces),
      cmocka_unit_test(rays_see_what_lies_where_it_should),
      cmocka_unit_test(a_pose_that_a_world_gives_is_one_that_it_takes),
      cmocka_unit_test(equals_go_to_the_lowest_slot),
      cmocka_unit_test(invalid_plugins_are_met_where_their_bounds_are),
      cmocka_unit_test(a_world_that_is_not_asked_keeps_no_index),
  };
  return cmocka_run_group_tests_name("oracle/queries", tests, nullptr, nullptr);
}
