// A case as one line of text and back: what a violation prints, and what regressions.txt keeps.
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <sstream>

#include "pair_case.h"

namespace carom::fuzz {
namespace {

constexpr const char* kKindNames[] = {"sphere",    "capsule", "box", "cylinder",  "cone",
                                      "ellipsoid", "hull",    "top", "half_space"};
static_assert(std::size(kKindNames) == static_cast<std::size_t>(Kind::count));

void put(std::string& to, Real x) {
  char text[40];
  std::snprintf(text, sizeof text, "%a ", x);
  to += text;
}
void put_whole(std::string& to, long x) { to += std::to_string(x) + ' '; }

void put_shape(std::string& to, const ShapeSpec& s) {
  to += kKindNames[static_cast<int>(s.kind)];
  to += ' ';
  put(to, s.swell);
  put_whole(to, s.declared);
  put_whole(to, static_cast<long>(s.lie));
  put_whole(to, static_cast<long>(s.params.size()));
  for (const double x : s.params) put(to, x);
}

void put_frame(std::string& to, const Frame& f) {
  for (int i = 0; i < 9; ++i) put(to, f.r(i / 3, i % 3));
  for (int i = 0; i < 3; ++i) put(to, f.p[i]);
}

/// Words one after another; after the last, or after one that is no number, `good` is false.
struct Words {
  std::istringstream in;
  bool good = true;

  std::string word() {
    std::string w;
    good = good && (in >> w);
    return w;
  }
  Real real() {
    const std::string w = word();
    char* end = nullptr;
    const Real x = std::strtod(w.c_str(), &end);
    good = good && end != w.c_str() && *end == 0;
    return x;
  }
  long whole(long below) {
    const Real x = real();
    good = good && x >= 0 && x < static_cast<Real>(below);
    return good ? static_cast<long>(x) : 0;
  }
  void shape(ShapeSpec& s) {
    const std::string name = word();
    int kind = 0;
    while (kind < static_cast<int>(Kind::count) && name != kKindNames[kind]) ++kind;
    good = good && kind < static_cast<int>(Kind::count);
    s.kind = static_cast<Kind>(kind);
    s.swell = real();
    s.declared = whole(2) != 0;
    s.lie = static_cast<Lie>(whole(static_cast<long>(Lie::count)));
    s.params.resize(static_cast<std::size_t>(whole(10000)));
    for (double& x : s.params) x = real();
    static constexpr std::size_t kLeast[] = {1, 2, 3, 2, 2, 3, 3, 2, 4};
    good = good && s.params.size() >= kLeast[kind];
  }
  void frame(Frame& f) {
    for (int i = 0; i < 9; ++i) f.r(i / 3, i % 3) = real();
    for (int i = 0; i < 3; ++i) f.p[i] = real();
  }
};

}  // namespace

std::string to_text(const PairCase& c) {
  std::string t;
  put_shape(t, c.a);
  put_shape(t, c.b);
  put_frame(t, c.b_in_a);
  put_frame(t, c.next);
  const QuerySettings& s = c.settings;
  put_whole(t, static_cast<long>(s.simplex));
  put_whole(t, static_cast<long>(s.method));
  put_whole(t, s.routines);
  put(t, s.tolerance);
  put(t, s.margin);
  put(t, s.max_distance);
  put_whole(t, s.gjk_cap);
  put_whole(t, s.epa_cap);
  put_whole(t, static_cast<long>(c.twist));
  put_whole(t, static_cast<long>(c.sweep));
  t.pop_back();
  return t;
}

bool from_text(const std::string& text, PairCase& out) {
  Words w{std::istringstream(text)};
  w.shape(out.a);
  w.shape(out.b);
  w.frame(out.b_in_a);
  w.frame(out.next);
  QuerySettings& s = out.settings;
  s.simplex = static_cast<Simplex>(w.whole(3));
  s.method = static_cast<Method>(w.whole(2));
  s.routines = w.whole(2) != 0;
  s.tolerance = w.real();
  s.margin = w.real();
  s.max_distance = w.real();
  s.gjk_cap = static_cast<int>(w.whole(1000000));
  s.epa_cap = static_cast<int>(w.whole(1000000));
  out.twist = static_cast<Twist>(w.whole(static_cast<long>(Twist::count)));
  out.sweep = static_cast<std::uint32_t>(w.whole(1 << 16));
  return w.good;
}

}  // namespace carom::fuzz
