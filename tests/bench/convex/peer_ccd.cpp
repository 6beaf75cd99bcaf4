// libccd under test: GJK's yes or no, GJK with EPA, and MPR, over support callbacks.
#include <ccd/ccd.h>

#include "peer.h"

namespace carom::bench {

namespace {

struct Body {
  const Solid* solid;
  const Placement& at;
  std::uint32_t hint;
  bool* sane;
  int* calls;
};

/// libccd hands over directions of any length, zero and NaN among them, and crashes on what is not finite: a direction
/// that says nothing gets an answer all the same, and the query counts as failed.
void support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* out) {
  Body& body = *static_cast<Body*>(const_cast<void*>(object));
  ++*body.calls;
  const double* const v = direction->v;
  double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  double unit[3] = {v[0] / length, v[1] / length, v[2] / length};
  if (!(length > 0 && length < HUGE_VAL)) {
    unit[0] = 1, unit[1] = unit[2] = 0;
    *body.sane = false;
  }
  double d[3], p[3];
  body.at.rotate_inverse(unit, d);
  core_support(*body.solid, d, p, body.hint);
  for (int i = 0; i < 3; ++i) p[i] += body.solid->core_radius * d[i];
  body.at.apply(p, out->v);
}

void centre(const void* object, ccd_vec3_t* out) {
  const Body& body = *static_cast<const Body*>(object);
  body.at.apply(body.solid->middle, out->v);
}

enum class Way { yes_or_no, epa, mpr };

class Ccd final : public Peer {
 public:
  explicit Ccd(Way way) : way_(way) {
    CCD_INIT(&ccd_);
    ccd_.support1 = ccd_.support2 = support;
    ccd_.center1 = ccd_.center2 = centre;
    ccd_.max_iterations = 200;
    ccd_.epa_tolerance = ccd_.mpr_tolerance = 1e-6;
  }

  const char* name() const override {
    return way_ == Way::yes_or_no ? "libccd GJK yes/no" : way_ == Way::epa ? "libccd GJK + EPA" : "libccd MPR";
  }

  void prepare(const Query* queries, std::size_t) override { queries_ = queries; }

  void ask(std::size_t i, Answer& answer) override {
    const Query& q = queries_[i];
    bool sane = true;
    int calls = 0;
    const Body a{q.a, q.at_a, q.a->start, &sane, &calls}, b{q.b, q.at_b, q.b->start, &sane, &calls};
    ccd_real_t depth = 0;
    ccd_vec3_t direction, position;
    switch (way_) {
      case Way::yes_or_no:
        answer.overlap = ccdGJKIntersect(&a, &b, &ccd_) != 0;
        break;
      case Way::epa:
        answer.overlap = ccdGJKPenetration(&a, &b, &ccd_, &depth, &direction, &position) == 0;
        break;
      case Way::mpr:
        answer.overlap = ccdMPRPenetration(&a, &b, &ccd_, &depth, &direction, &position) == 0;
        break;
    }
    answer.calls = calls / 2;
    if (way_ != Way::yes_or_no && answer.overlap) {
      answer.separation = sane ? -depth : HUGE_VAL;
      for (int k = 0; k < 3; ++k) answer.normal[k] = direction.v[k];
    }
  }

 private:
  Way way_;
  ccd_t ccd_;
  const Query* queries_ = nullptr;
};

}  // namespace

void add_ccd(Peers& peers) {
  for (const Way way : {Way::yes_or_no, Way::epa, Way::mpr}) peers.push_back(std::make_unique<Ccd>(way));
}

}  // namespace carom::bench
