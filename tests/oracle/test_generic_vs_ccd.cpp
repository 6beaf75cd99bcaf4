// The generic path against libccd, where libccd can be trusted: its yes or no, on shapes of about 1 m, when the answer
// is not within a millionth of touching. Its depths are off by metres on such bodies and are not asked.
#include <ccd/ccd.h>

#include <cstdio>

#include "carom_test.h"
#include "random_pairs.h"

using namespace carom;
using namespace carom::test;

namespace {

struct CcdBody {
  const Shape* shape;
  Frame frame;
};

void ccd_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  const CcdBody& body = *static_cast<const CcdBody*>(object);
  Vec3 d = body.frame.rotate_inverse(Vec3(direction->v[0], direction->v[1], direction->v[2]));
  // libccd asks along zero now and then (its issue 25), and crashes on what is not finite: any point will do then.
  const Real length = d.norm();
  d = length > 0 && carom::finite(d) ? Vec3(d / length) : Vec3(Vec3::unit_x());
  const Vec3 p = body.frame.apply(support_point(*body.shape, d));
  for (int i = 0; i < 3; ++i) out->v[i] = p[i];
}

bool ccd_says_overlap(const ShapePair& p) {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = ccd_support;
  ccd.max_iterations = 1000;
  const CcdBody a{&p.a, Frame()}, b{&p.b, p.b_in_a};
  return ccdGJKIntersect(&a, &b, &ccd) != 0;
}

}  // namespace

static void the_verdicts_agree(void**) {
  Random random(211);
  int overlapping = 0, apart = 0;
  for (int i = 0; i < 16 * kFamilyCount * kFamilyCount; ++i) {
    const int fa = i % kFamilyCount, fb = (i / kFamilyCount) % kFamilyCount;
    // Half of the pairs within a hundredth of touching, where verdicts are hard.
    const Real reach = i % 2 ? 0.01 : 0.5;
    const ShapePair p = random_pair(random, fa, fb, random.uniform(-reach, reach));
    QuerySettings settings;
    settings.simplex = static_cast<Simplex>(i % 3);
    QueryResult r;
    SupportFault fault;
    generic_distance(p.a, p.b, p.b_in_a, settings, nullptr, r, fault);
    if (std::fabs(r.separation) <= 1e-5) continue;  // our own bracket is 1e-6 wide
    (r.separation < 0 ? overlapping : apart)++;
    if (ccd_says_overlap(p) != (r.separation < 0))
      std::printf("%s-%s pair %d: separation %g\n", kFamilies[fa], kFamilies[fb], i, r.separation);
    assert_true(ccd_says_overlap(p) == (r.separation < 0));
  }
  assert_true(overlapping > 300 && apart > 300);
}

int main() {
  const CMUnitTest tests[] = {
      cmocka_unit_test(the_verdicts_agree),
  };
  return cmocka_run_group_tests_name("oracle/generic_vs_ccd", tests, nullptr, nullptr);
}
