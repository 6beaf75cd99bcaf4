// Every pair routine's verdict, overlapping or not, against libccd's, which knows the shapes by a support function
// alone.
//
// Yes or no is all that is asked of it: its depths are not the least ones. And only on shapes of about unit size, 1e-6
// or more from touch, where its own tolerance does not decide.
#include <ccd/ccd.h>

#include <cstdio>

#include "carom_test.h"
#include "collision/narrow/query.h"
#include "pair_cases.h"

using namespace carom;
using namespace carom::test;

namespace {

/// A shape in place, as libccd sees it. What is not finite would make it crash: count it, and hand on zeros.
struct Placed {
  const Shape* shape;
  Frame frame;
  int not_finite = 0;
};

void ccd_support(const void* object, const ccd_vec3_t* dir, ccd_vec3_t* out) {
  auto* placed = static_cast<Placed*>(const_cast<void*>(object));
  Vec3 d = placed->frame.rotate_inverse(Vec3(dir->v[0], dir->v[1], dir->v[2]));
  const Real length = d.norm();
  d = length > 0 ? Vec3(d / length) : Vec3(Vec3::unit_x());
  Vec3 x = placed->frame.apply(support_point(*placed->shape, d));
  if (!finite(x)) ++placed->not_finite, x.set_zero();
  ccdVec3Set(out, static_cast<ccd_real_t>(x.x()), static_cast<ccd_real_t>(x.y()), static_cast<ccd_real_t>(x.z()));
}

void ccd_centre(const void* object, ccd_vec3_t* out) {
  const auto* placed = static_cast<const Placed*>(object);
  ccdVec3Set(out, static_cast<ccd_real_t>(placed->frame.p.x()), static_cast<ccd_real_t>(placed->frame.p.y()),
             static_cast<ccd_real_t>(placed->frame.p.z()));
}

bool ccd_overlap(Placed& a, Placed& b) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = ccd_support;
  ccd.center1 = ccd.center2 = ccd_centre;
  ccd.max_iterations = 1000;
  return ccdGJKIntersect(&a, &b, &ccd) != 0;
}

}  // namespace

static void routines_and_libccd_agree_on_who_overlaps(void**) {
  Random random(41);
  int apart = 0, overlapping = 0;
  for (const auto& [form_a, form_b] : kRoutinePairs) {
    if (form_a == Form::half_space) continue;  // unbounded: no support function
    for (int i = 0; i < 1500; ++i) {
      const Shape a = random_shape(form_a, 1, random), b = random_shape(form_b, 1, random);
      const Frame pose = random_pose(a, b, random);
      QueryResult result;
      SupportFault fault;
      distance(a, b, pose, QuerySettings{}, nullptr, result, fault);
      if (std::fabs(result.separation) <= 1e-6) continue;
      Placed placed_a{&a, Frame()}, placed_b{&b, pose};
      const bool overlap = ccd_overlap(placed_a, placed_b);
      assert_int_equal(placed_a.not_finite + placed_b.not_finite, 0);
      if (overlap != (result.separation < 0))
        std::printf("forms %u-%u pose %d: separation %g, libccd says %s\n", static_cast<unsigned>(form_a),
                    static_cast<unsigned>(form_b), i, result.separation, overlap ? "overlap" : "apart");
      assert_int_equal(overlap, result.separation < 0);
      ++(overlap ? overlapping : apart);
    }
  }
  assert_true(apart > 1000 && overlapping > 1000);  // both verdicts were put to the test
}

int main() {
  const CMUnitTest tests[] = {cmocka_unit_test(routines_and_libccd_agree_on_who_overlaps)};
  return cmocka_run_group_tests_name("oracle/pairs_vs_ccd", tests, nullptr, nullptr);
}
