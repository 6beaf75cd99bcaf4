// The distance of pairs whose cores are apart, as a device computes it: C99 that OpenCL C 1.2, CUDA and a host's compiler
// take alike. It is the text of collision/narrow once more (generic.cpp, gjk.cpp, difference.h, secant.h, simplex_voronoi.cpp,
// simplex_geometry.h, core.h, farthest_vertex.cpp, core/multiply_add.h), operation by operation: names are theirs, and why
// something is done stands there. Only + - * / and sqrt are used, none of them contracted, so that the bits are the host's
// (tests/abi/test_device). What it does not finish (cores that overlap, a walk without progress, a support function that
// misbehaves) it leaves to the host, which asks anew.
#if defined(__OPENCL_VERSION__) || defined(__OPENCL_C_VERSION__)
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#pragma OPENCL FP_CONTRACT OFF
typedef int int32_t;
typedef uint uint32_t;
typedef long int64_t;
typedef ulong uint64_t;
#define CAROM_GLOBAL __global
#define CAROM_KERNEL __kernel void
#define CAROM_ITEM() get_global_id(0)
#define CAROM_BITS(x) as_ulong(x)
#define CAROM_DOUBLE(u) as_double(u)
#define CAROM_MUL_HIGH(a, b) mul_hi((long)(a), (long)(b))
#elif defined(__CUDACC_RTC__)  // --fmad=false --device-as-default-execution-space
typedef int int32_t;
typedef unsigned int uint32_t;
typedef long long int64_t;
typedef unsigned long long uint64_t;
#define CAROM_GLOBAL
#define CAROM_KERNEL extern "C" __global__ void
#define CAROM_ITEM() (blockIdx.x * (uint64_t)blockDim.x + threadIdx.x)
#define CAROM_BITS(x) (uint64_t) __double_as_longlong(x)
#define CAROM_DOUBLE(u) __longlong_as_double((int64_t)(u))
#define CAROM_MUL_HIGH(a, b) __mul64hi(a, b)
#define INFINITY CAROM_DOUBLE(0x7FF0000000000000ull)
#else  // a host's C compiler, with -ffp-contract=off
#include <math.h>
#include <stdint.h>
#include <string.h>
#define CAROM_GLOBAL
#define CAROM_KERNEL void
static uint64_t carom_item;  // whoever calls a kernel sets it
#define CAROM_ITEM() carom_item
static uint64_t CAROM_BITS(double x) {
  uint64_t u;
  memcpy(&u, &x, sizeof u);
  return u;
}
static double CAROM_DOUBLE(uint64_t u) {
  double x;
  memcpy(&x, &u, sizeof x);
  return x;
}
__extension__ typedef __int128 carom_int128;
#define CAROM_MUL_HIGH(a, b) (int64_t)((carom_int128)(a) * (b) >> 64)
#endif
typedef CAROM_GLOBAL const double* carom_params;

// A plugin's support function; carom_ask() is written for the plugins at hand, and stands behind this text.
static int32_t carom_ask(uint32_t plugin, carom_params params, uint64_t count, const double* dir, double* out);

#define K_U 0x1p-53       // unit roundoff
#define K_BRACKET 48.0    // rounding.h
#define K_POSE 72.0       // rounding.h
#define K_SQUARE 1e-280   // core.h
#define K_PARALLEL2 1e-6  // simplex_geometry.h
#define K_WIDE2 0x1p-10   // simplex_geometry.h
#define K_INFINITY ((double)INFINITY)

enum { SPHERE = 1, CAPSULE, BOX, POLYTOPE, CYLINDER, CONE, ELLIPSOID };  // forms; 0: a plugin is asked
enum { EXACT_ENOUGH, CAPPED, ROUNDING, LEFT = 4 };                       // status; LEFT: to the host
enum { NARROW, OVERLAP, STUCK, CAP, FAULT };                             // GjkEnd

// A shape. The host writes the same struct (device/records.h).
typedef struct {
  double core_radius, bounding_radius, radius, half_height, extents[3], middle[3], limit2;
  uint64_t numbers;         // where its params or, of a polytope, coordinates begin
  uint64_t number_count;    // of params; of coordinates on one axis, padded
  uint64_t corners, links;  // of a polytope that climbs: where its corners begin, and guesses and neighbours
  uint32_t form, plugin, smooth, faceted;
  uint32_t points, cells;  // of a polytope: how many; cells of a side of its guesses, 0: it does not climb
} carom_shape_data;

// A result: carom_distance.
typedef struct {
  uint32_t struct_size, status;
  double separation, lower, upper, normal[3], point_a[3], point_b[3];
  uint32_t gjk_iterations, epa_iterations, support_calls, reserved;
} carom_distance_data;

typedef struct {
  double x, y, z;
} Vec;

typedef struct {
  Vec c[3];  // columns
} Mat;

static Vec vec(double x, double y, double z) {
  Vec v;
  v.x = x, v.y = y, v.z = z;
  return v;
}
static Vec add(Vec a, Vec b) { return vec(a.x + b.x, a.y + b.y, a.z + b.z); }
static Vec sub(Vec a, Vec b) { return vec(a.x - b.x, a.y - b.y, a.z - b.z); }
static Vec neg(Vec a) { return vec(-a.x, -a.y, -a.z); }
static Vec mul(double s, Vec a) { return vec(s * a.x, s * a.y, s * a.z); }
static Vec over(Vec a, double s) { return vec(a.x / s, a.y / s, a.z / s); }
static Vec times(Vec a, Vec b) { return vec(a.x * b.x, a.y * b.y, a.z * b.z); }
static double sum(Vec a) { return a.x + (a.y + a.z); }
static double dot3(Vec a, Vec b) { return sum(times(a, b)); }
static Vec cross3(Vec a, Vec b) { return vec(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }
static double norm2(Vec a) { return dot3(a, a); }
static double size3(Vec a) { return sqrt(norm2(a)); }
static double abs_sum(Vec a) { return fabs(a.x) + (fabs(a.y) + fabs(a.z)); }
static Vec turned(const Mat* m, Vec v) {
  const Vec *a = &m->c[0], *b = &m->c[1], *c = &m->c[2];
  return vec(a->x * v.x + (b->x * v.y + c->x * v.z), a->y * v.x + (b->y * v.y + c->y * v.z),
             a->z * v.x + (b->z * v.y + c->z * v.z));
}
static Vec turned_back(const Mat* m, Vec v) { return vec(dot3(m->c[0], v), dot3(m->c[1], v), dot3(m->c[2], v)); }
static double least(double a, double b) { return b < a ? b : a; }  // std::min
static double most(double a, double b) { return a < b ? b : a; }   // std::max

// ---- core/multiply_add.h ----
typedef struct {
  double value, lost;
} Exact;

static Exact exact_sum(double a, double b) {
  Exact e;
  const double s = a + b, of_b = s - a;
  e.value = s, e.lost = (a - (s - of_b)) + (b - of_b);
  return e;
}
static Exact exact_product(double a, double b) {
  Exact e;
  const double split = 0x1p27 + 1;
  const double big_a = split * a, high_a = big_a - (big_a - a), low_a = a - high_a;
  const double big_b = split * b, high_b = big_b - (big_b - b), low_b = b - high_b;
  const double product = a * b;
  e.value = product, e.lost = ((high_a * high_b - product) + high_a * low_b + low_a * high_b) + low_a * low_b;
  return e;
}
static double odd_sum(double a, double b) {
  const Exact s = exact_sum(a, b);
  const uint64_t bits = CAROM_BITS(s.value);
  if (s.lost == 0 || (bits & 1)) return s.value;
  return CAROM_DOUBLE((s.lost > 0) == (s.value > 0) ? bits + 1 : bits - 1);
}
static int splits(double a, double b, double c) {
  const double fewest = 0x1p-915, largest = 0x1p995, product = fabs(a * b);
  return product >= fewest && product < largest && fabs(a) < largest && fabs(b) < largest && fabs(c) < largest;
}
static double multiply_add(double a, double b, double c) {
  Exact product, low, high;
  if (!splits(a, b, c)) return a * b + c;
  product = exact_product(a, b);
  low = exact_sum(c, product.lost);
  high = exact_sum(product.value, low.value);
  return high.value + odd_sum(low.lost, high.lost);
}

// ---- simplex_geometry.h ----
static double difference_of_products(double a, double b, double c, double d) {
  Exact cd;
  if (splits(c, d, 0))
    cd = exact_product(c, d);
  else
    cd.value = c * d, cd.lost = 0;
  return multiply_add(a, b, -cd.value) - cd.lost;
}
static Vec accurate_cross(Vec a, Vec b) {
  return vec(difference_of_products(a.y, b.z, a.z, b.y), difference_of_products(a.z, b.x, a.x, b.z),
             difference_of_products(a.x, b.y, a.y, b.x));
}
static Vec careful_cross(Vec a, Vec b) {
  const Vec n = cross3(a, b);
  if (norm2(n) > K_PARALLEL2 * (norm2(a) * norm2(b))) return n;
  return accurate_cross(a, b);
}
static Vec triangle_normal(Vec a, Vec b, Vec c) {
  const Vec ab = sub(b, a), bc = sub(c, b), ca = sub(a, c);
  const double lab = norm2(ab), lbc = norm2(bc), lca = norm2(ca);
  const int at_a = lbc >= lab && lbc >= lca, at_b = !at_a && lca >= lab;
  const Vec in = at_a ? ca : (at_b ? ab : bc), out = at_a ? ab : (at_b ? bc : ca);
  const double shorter2 = at_a ? lca * lab : (at_b ? lab * lbc : lbc * lca);
  const Vec n = cross3(in, out);
  if (norm2(n) > K_PARALLEL2 * shorter2) return n;
  return accurate_cross(in, out);
}

typedef struct {
  int inside, count, index[4];
  double weight[4];
  Vec direction;
  double distance2;
} Nearest;

static void clear_nearest(Nearest* n) { n->inside = 0, n->count = 0, n->distance2 = K_INFINITY; }

static void offer_vertex(const Vec* w, int i, Nearest* nearest) {
  const double distance2 = norm2(w[i]);
  if (!(distance2 < nearest->distance2)) return;
  nearest->count = 1;
  nearest->index[0] = i;
  nearest->weight[0] = 1;
  nearest->direction = w[i];
  nearest->distance2 = distance2;
}
static void offer_inner_edge(const Vec* w, int i, int j, Vec edge, double along, double length2, Nearest* nearest) {
  const Vec offset = careful_cross(along + along < length2 ? w[i] : w[j], edge);
  const double distance2 = norm2(offset) / length2, t = along / length2;
  if (!(distance2 < nearest->distance2)) return;
  nearest->count = 2;
  nearest->index[0] = i, nearest->index[1] = j;
  nearest->weight[0] = 1 - t, nearest->weight[1] = t;
  nearest->direction = cross3(edge, offset);
  nearest->distance2 = distance2;
}
static void offer_edge(const Vec* w, int i, int j, Nearest* nearest) {
  const Vec edge = sub(w[j], w[i]);
  const double from_i = -dot3(w[i], edge), from_j = dot3(w[j], edge);
  if (from_i <= 0)
    offer_vertex(w, i, nearest);
  else if (from_j <= 0)
    offer_vertex(w, j, nearest);
  else
    offer_inner_edge(w, i, j, edge, from_i, norm2(edge), nearest);
}
static double projected_area(Vec p, Vec q, Vec normal) { return dot3(normal, cross3(p, sub(q, p))); }
static void offer_inner_face(const Vec* w, int i, int j, int k, Vec normal, double of_i, double of_j, double of_k,
                             Nearest* nearest) {
  const double li = norm2(w[i]), lj = norm2(w[j]), lk = norm2(w[k]);
  const Vec p = li <= lj ? (li <= lk ? w[i] : w[k]) : (lj <= lk ? w[j] : w[k]);
  const double offset = dot3(normal, p), distance2 = offset * offset / norm2(normal);
  double scale;
  if (!(distance2 < nearest->distance2)) return;
  of_i = of_i > 0 ? of_i : 0;
  of_j = of_j > 0 ? of_j : 0;
  of_k = of_k > 0 ? of_k : 0;
  scale = 1 / (of_i + of_j + of_k);
  nearest->count = 3;
  nearest->index[0] = i, nearest->index[1] = j, nearest->index[2] = k;
  nearest->weight[0] = of_i * scale, nearest->weight[1] = of_j * scale, nearest->weight[2] = of_k * scale;
  nearest->direction = offset < 0 ? neg(normal) : normal;
  nearest->distance2 = distance2;
}
static void offer_face(const Vec* w, int i, int j, int k, Nearest* nearest) {
  const Vec normal = triangle_normal(w[i], w[j], w[k]);
  const double of_i = projected_area(w[j], w[k], normal), of_j = projected_area(w[k], w[i], normal),
               of_k = projected_area(w[i], w[j], normal);
  const int out_jk = !(of_i > 0), out_ki = !(of_j > 0), out_ij = !(of_k > 0);
  if (!(out_jk | out_ki | out_ij)) {
    offer_inner_face(w, i, j, k, normal, of_i, of_j, of_k, nearest);
    return;
  }
  if (out_jk) offer_edge(w, j, k, nearest);
  if (out_ki) offer_edge(w, k, i, nearest);
  if (out_ij) offer_edge(w, i, j, nearest);
}
static void set_inside(double of_a, double of_b, double of_c, double of_d, Nearest* nearest) {
  double volume[4];
  double scale;
  int i;
  volume[0] = of_a, volume[1] = of_b, volume[2] = of_c, volume[3] = of_d > 0 ? of_d : 0;
  scale = 1 / (volume[0] + volume[1] + volume[2] + volume[3]);
  nearest->inside = 1;
  nearest->count = 4;
  for (i = 0; i < 4; ++i) {
    nearest->index[i] = i;
    nearest->weight[i] = volume[i] * scale;
  }
  nearest->direction = vec(0, 0, 0);
  nearest->distance2 = 0;
}

// ---- simplex_voronoi.cpp ----
static int is_flat(double volume, double da2, double db2, double dc2) {
  const double flat = 16 * K_U;
  return !(volume * volume > flat * flat * (da2 * db2 * dc2));
}

typedef struct {
  Vec edge, moment;
  double length2;
} Spoke;

static Spoke spoke(Vec newest, Vec end) {
  Spoke s;
  s.edge = sub(end, newest), s.moment = cross3(newest, s.edge), s.length2 = norm2(s.edge);
  return s;
}
static void offer_wedge(const Vec* w, int i, int j, int k, const Spoke* to_i, const Spoke* to_j, Vec cross,
                        uint32_t* beyond, Nearest* nearest) {
  const int wide = norm2(cross) > K_WIDE2 * (to_i->length2 * to_j->length2);
  const Vec normal = wide ? cross : triangle_normal(w[i], w[j], w[k]);
  const double of_i = -dot3(normal, to_j->moment), of_j = dot3(normal, to_i->moment);
  const int beyond_j = !(of_i > 0), beyond_i = !(of_j > 0);
  if (!(beyond_i | beyond_j)) {
    offer_inner_face(w, i, j, k, normal, of_i, of_j, projected_area(w[i], w[j], normal), nearest);
    return;
  }
  *beyond |= (uint32_t)beyond_i << i | (uint32_t)beyond_j << j;
}
static void offer_spokes(const Vec* w, int newest, uint32_t beyond, Nearest* nearest) {
  int i;
  for (i = 0; i < newest; ++i)
    if (beyond >> i & 1) offer_edge(w, i, newest, nearest);
}
static void nearest_voronoi(const Vec* w, int count, Nearest* nearest) {
  Vec a, b, c, d, da, db, dc;
  double bcd, cad, abd, abc, volume, sign;
  int flat, out_bcd, out_cad, out_abd, out_abc;
  clear_nearest(nearest);
  if (count == 1) {
    offer_vertex(w, 0, nearest);
    return;
  }
  if (count == 2) {
    offer_edge(w, 0, 1, nearest);
    return;
  }
  if (count == 3) {
    offer_face(w, 0, 1, 2, nearest);
    return;
  }
  a = w[0], b = w[1], c = w[2], d = w[3];
  da = sub(a, d), db = sub(b, d), dc = sub(c, d);
  bcd = dot3(cross3(db, dc), d), cad = dot3(cross3(dc, da), d), abd = dot3(cross3(da, db), d);
  abc = dot3(cross3(sub(b, a), sub(c, a)), a), volume = dot3(cross3(da, db), dc);
  flat = is_flat(volume, norm2(da), norm2(db), norm2(dc));
  sign = volume > 0 ? 1 : -1;
  out_bcd = flat || sign * bcd > 0, out_cad = flat || sign * cad > 0, out_abd = flat || sign * abd > 0;
  out_abc = flat || sign * abc < 0;
  if (!(out_bcd | out_cad | out_abd | out_abc)) {
    set_inside(-sign * bcd, -sign * cad, -sign * abd, sign * abc, nearest);
    return;
  }
  if (out_bcd) offer_face(w, 1, 2, 3, nearest);
  if (out_cad) offer_face(w, 2, 0, 3, nearest);
  if (out_abd) offer_face(w, 0, 1, 3, nearest);
  if (out_abc) offer_face(w, 0, 1, 2, nearest);
}
static void nearest_voronoi_last(const Vec* w, int count, Nearest* nearest) {
  uint32_t beyond = 0;
  Spoke to_a, to_b, to_c;
  Vec dab, dbc, dca, d;
  double volume, sign, bcd, cad, abd;
  int flat, out_bcd, out_cad, out_abd;
  if (count < 3) {
    nearest_voronoi(w, count, nearest);
    return;
  }
  clear_nearest(nearest);
  if (count == 3) {
    to_a = spoke(w[2], w[0]), to_b = spoke(w[2], w[1]);
    offer_wedge(w, 0, 1, 2, &to_a, &to_b, cross3(to_a.edge, to_b.edge), &beyond, nearest);
    offer_spokes(w, 2, beyond, nearest);
    return;
  }
  d = w[3];
  to_a = spoke(d, w[0]), to_b = spoke(d, w[1]), to_c = spoke(d, w[2]);
  dab = cross3(to_a.edge, to_b.edge), dbc = cross3(to_b.edge, to_c.edge), dca = cross3(to_c.edge, to_a.edge);
  volume = dot3(dab, to_c.edge);
  flat = is_flat(volume, to_a.length2, to_b.length2, to_c.length2);
  sign = volume > 0 ? 1 : -1, bcd = sign * dot3(dbc, d), cad = sign * dot3(dca, d), abd = sign * dot3(dab, d);
  out_bcd = flat || bcd > 0, out_cad = flat || cad > 0, out_abd = flat || abd > 0;
  if (!(out_bcd | out_cad | out_abd)) {
    set_inside(-bcd, -cad, -abd, sign * dot3(cross3(sub(w[1], w[0]), sub(w[2], w[0])), w[0]), nearest);
    return;
  }
  if (out_bcd) offer_wedge(w, 1, 2, 3, &to_b, &to_c, dbc, &beyond, nearest);
  if (out_cad) offer_wedge(w, 2, 0, 3, &to_c, &to_a, dca, &beyond, nearest);
  if (out_abd) offer_wedge(w, 0, 1, 3, &to_a, &to_b, dab, &beyond, nearest);
  offer_spokes(w, 3, beyond, nearest);
}

// ---- farthest_vertex.cpp ----
// All shapes of a call, and what they point into.
typedef struct {
  CAROM_GLOBAL const carom_shape_data* shapes;
  CAROM_GLOBAL const double* numbers;
  CAROM_GLOBAL const int64_t* corners;  // 5 each: x, y, z, its first neighbour, its point
  CAROM_GLOBAL const uint32_t* links;   // of a shape: guesses, then neighbours
} Stage;

static uint32_t scan(const Stage* stage, CAROM_GLOBAL const carom_shape_data* s, Vec n) {
  CAROM_GLOBAL const double *x = stage->numbers + s->numbers, *y = x + s->number_count, *z = y + s->number_count;
  double best[4];
  uint32_t which[4], i, lane;
  for (lane = 0; lane < 4; ++lane) best[lane] = -K_INFINITY, which[lane] = lane;
  for (i = 0; i < s->number_count; i += 4)
    for (lane = 0; lane < 4; ++lane) {
      const double h = x[i + lane] * n.x + y[i + lane] * n.y + z[i + lane] * n.z;
      if (h > best[lane]) best[lane] = h, which[lane] = i + lane;
    }
  for (lane = 0; lane < 2; ++lane)
    if (best[lane + 2] > best[lane]) best[lane] = best[lane + 2], which[lane] = which[lane + 2];
  i = best[1] > best[0] ? which[1] : which[0];
  return i < s->points - 1 ? i : s->points - 1;
}

static uint32_t place_of(double t, double scale, double middle, uint32_t cells) {
  const double at = t * scale + middle;
  return at < cells ? (uint32_t)at : cells - 1;
}
static uint32_t cell_of(Vec n, uint32_t cells) {
  const double ax = fabs(n.x), ay = fabs(n.y), az = fabs(n.z);
  const int wider = ay > ax, axis = wider + (az > most(ax, ay)) * (2 - wider);
  const double middle = 0.5 * cells, widest = axis == 0 ? n.x : (axis == 1 ? n.y : n.z), scale = middle / fabs(widest);
  const uint32_t face = (uint32_t)(2 * axis) + (widest < 0);
  return (face * cells + place_of(axis == 0 ? n.y : n.x, scale, middle, cells)) * cells +
         place_of(axis == 2 ? n.y : n.z, scale, middle, cells);
}

typedef struct {
  int64_t high;
  uint64_t low;
} Wide;

static void add_product(Wide* w, int64_t a, int64_t b) {
  const uint64_t low = (uint64_t)a * (uint64_t)b;
  w->low += low;
  w->high += CAROM_MUL_HIGH(a, b) + (w->low < low);
}
static Wide along(const int64_t* d, CAROM_GLOBAL const int64_t* corner) {
  Wide w;
  w.high = 0, w.low = 0;
  add_product(&w, d[0], corner[0]), add_product(&w, d[1], corner[1]), add_product(&w, d[2], corner[2]);
  return w;
}
static int above(Wide a, Wide b) { return a.high > b.high || (a.high == b.high && a.low > b.low); }

static uint32_t climb(const Stage* stage, CAROM_GLOBAL const carom_shape_data* s, Vec n) {
  CAROM_GLOBAL const int64_t* const corners = stage->corners + 5 * s->corners;
  CAROM_GLOBAL const uint32_t *const guesses = stage->links + s->links, *const neighbours =
                                                                            guesses + 6 * s->cells * s->cells;
  uint32_t at = guesses[cell_of(n, s->cells)];
  int64_t d[3];
  Wide farthest;
  if (!(abs_sum(n) < 8)) return (uint32_t)corners[4];
  d[0] = (int64_t)(n.x * 0x1p60), d[1] = (int64_t)(n.y * 0x1p60), d[2] = (int64_t)(n.z * 0x1p60);
  farthest = along(d, corners + 5 * at);
  for (;;) {
    uint32_t best = at;
    int64_t k;
    for (k = corners[5 * at + 3]; k < corners[5 * at + 8]; ++k) {
      const uint32_t neighbour = neighbours[k];
      const Wide h = along(d, corners + 5 * neighbour);
      if (above(h, farthest)) farthest = h, best = neighbour;
    }
    if (best == at) return (uint32_t)corners[5 * at + 4];
    at = best;
  }
}

// ---- core.h ----
static double toward(double d, double h) { return d < 0 ? -h : h; }

static Vec on_rim(Vec n, double radius, double y) {
  const double side2 = n.x * n.x + n.z * n.z;
  const double scale = side2 > K_SQUARE ? radius / sqrt(side2) : 0;
  return vec(n.x * scale, y, n.z * scale);
}

static int core_support(const Stage* stage, CAROM_GLOBAL const carom_shape_data* s, Vec n, Vec* out) {
  double dir[3], found[3];
  Vec stretched, extents;
  uint64_t vertex;
  switch (s->form) {
    case SPHERE:
      *out = vec(0, 0, 0);
      return 1;
    case CAPSULE:
      *out = vec(0, toward(n.y, s->half_height), 0);
      return 1;
    case BOX:
      *out = vec(toward(n.x, s->extents[0]), toward(n.y, s->extents[1]), toward(n.z, s->extents[2]));
      return 1;
    case POLYTOPE:
      vertex = s->numbers + (s->cells ? climb(stage, s, n) * (uint64_t)3 : scan(stage, s, n));
      if (s->cells)
        *out = vec(stage->numbers[vertex], stage->numbers[vertex + 1], stage->numbers[vertex + 2]);
      else
        *out = vec(stage->numbers[vertex], stage->numbers[vertex + s->number_count],
                   stage->numbers[vertex + 2 * s->number_count]);
      return 1;
    case CYLINDER:
      *out = on_rim(n, s->radius, toward(n.y, s->half_height));
      return 1;
    case CONE:
      *out = 2 * s->half_height * n.y > s->radius * sqrt(n.x * n.x + n.z * n.z) ? vec(0, s->half_height, 0)
                                                                                : on_rim(n, s->radius, -s->half_height);
      return 1;
    case ELLIPSOID:
      extents = vec(s->extents[0], s->extents[1], s->extents[2]);
      stretched = times(extents, n);
      if (!(norm2(stretched) > K_SQUARE)) return 0;
      *out = times(extents, mul(1 / sqrt(norm2(stretched)), stretched));
      return 1;
    default:
      dir[0] = n.x, dir[1] = n.y, dir[2] = n.z;
      found[0] = found[1] = found[2] = 0;
      if (carom_ask(s->plugin, stage->numbers + s->numbers, s->number_count, dir, found) != 0) return 0;
      *out = vec(found[0], found[1], found[2]);
      return norm2(*out) <= s->limit2;
  }
}

// ---- difference.h ----
typedef struct {
  Vec w, a, b;
} Point;

typedef struct {
  int count;
  Point point[4];
  double weight[4];
} Simplex;

typedef struct {
  const Stage* stage;
  CAROM_GLOBAL const carom_shape_data *a, *b;
  Mat rotation;
  Vec offset, normal;
  double lower, upper, scale, rounding, slack;
  uint32_t calls;
} Difference;

static int look(Difference* d, Vec way, Vec n, Point* out, double* value) {
  const Vec n_b = neg(turned_back(&d->rotation, way));
  ++d->calls;
  if (!core_support(d->stage, d->a, way, &out->a)) return 0;
  if (!core_support(d->stage, d->b, n_b, &out->b)) return 0;
  out->w = mul(d->scale, sub(add(turned(&d->rotation, out->b), d->offset), out->a));
  *value = dot3(n, out->w);
  if (*value > d->lower) d->normal = n, d->lower = *value;
  return 1;
}

// ---- secant.h ----
typedef struct {
  int known, newest;
  Vec n[3], r[3];
} Secant;

static void remember(Secant* s, Vec n, Vec w, double value) {
  s->newest = s->newest == 2 ? 0 : s->newest + 1;
  s->n[s->newest] = n;
  s->r[s->newest] = sub(w, mul(value, n));
  if (s->known < 3) ++s->known;
}
static int guess(const Secant* q, int watch, Vec* n) {
  const int before = q->newest == 0 ? 2 : q->newest - 1, oldest = 3 - q->newest - before;
  Vec n0, r0, u, v, stride, step;
  double uu, uv, vv, ur, vr, det, s, t = 0, step2;
  if (q->known < 3) return 0;
  n0 = q->n[q->newest], r0 = q->r[q->newest];
  if (watch && !(norm2(r0) < 0.25 * norm2(q->r[before]))) return 0;
  u = sub(q->r[before], r0), v = sub(q->r[oldest], r0);
  uu = norm2(u), uv = dot3(u, v), vv = norm2(v), ur = dot3(u, r0), vr = dot3(v, r0);
  det = uu * vv - uv * uv;
  if (det > 1e-6 * uu * vv) {
    s = (vr * uv - ur * vv) / det;
    t = (ur * uv - vr * uu) / det;
  } else if (uu > 0) {
    s = -ur / uu;
  } else {
    return 0;
  }
  stride = sub(q->n[before], n0);
  step = add(mul(s, stride), mul(t, sub(q->n[oldest], n0)));
  step2 = norm2(step);
  if (!(step2 > 0 && step2 < (watch ? norm2(stride) : 0.25))) return 0;
  *n = add(n0, step);
  *n = mul(1 / size3(*n), *n);
  return 1;
}

// ---- gjk.cpp ----
static void keep(Simplex* simplex, Vec* w, const Nearest* nearest, Difference* d, Simplex* spare) {
  double weight[4], length;
  const int known = simplex->count + 1;
  Vec v = vec(0, 0, 0);
  int i, to;
  for (i = 0; i < 4; ++i) weight[i] = -1;
  for (i = 0; i < nearest->count; ++i) {
    weight[nearest->index[i]] = nearest->weight[i];
    v = add(v, mul(nearest->weight[i], w[nearest->index[i]]));
  }
  length = size3(v);
  if (length <= d->upper)
    d->upper = length, spare->count = 0;
  else if (spare->count == 0)
    *spare = *simplex;
  simplex->count = 0;
  for (i = 0; i < known; ++i) {
    if (weight[i] < 0) continue;
    to = simplex->count++;
    if (to != i) simplex->point[to] = simplex->point[i], w[to] = w[i];
    simplex->weight[to] = weight[i];
  }
}

static int repeated(const Vec* w, int count) {
  int i;
  for (i = 0; i < count; ++i)
    if (w[i].x == w[count].x && w[i].y == w[count].y && w[i].z == w[count].z) return 1;
  return 0;
}

static int is_good(const Nearest* nearest, const Difference* d, double before) {
  return nearest->inside ? d->lower <= d->rounding : nearest->distance2 < before;
}
static int descend(int last_only, const Difference* d, const Vec* w, int count, double before, Nearest* nearest) {
  if (last_only)
    nearest_voronoi_last(w, count, nearest);
  else
    nearest_voronoi(w, count, nearest);
  if (is_good(nearest, d, before)) return 1;
  nearest_voronoi(w, count, nearest);
  return is_good(nearest, d, before);
}

static Vec about_unit(Vec v, double length2) {
  const uint64_t half_field = ((CAROM_BITS(length2) >> 52) + 1) / 2;
  return mul(CAROM_DOUBLE((1023 + (uint64_t)512 - half_field) << 52), v);
}

// A bracket that is narrow enough; one that is none means that a support function lies, which the host looks into.
static int closed(const Difference* d) { return d->lower > d->upper + d->slack ? FAULT : NARROW; }

static int walk(Difference* d, int last_only, double gap, uint32_t cap, int patience, int watch, Vec first,
                Simplex* simplex, Simplex* spare, uint32_t* iterations) {
  Vec n = vec(1, 0, 0), way = n, w[4], towards;
  const double length2 = norm2(first);
  double value = 0, distance2, d2, best;
  Nearest nearest;
  Secant secant;
  int plain = patience, guessed, known, i;
  simplex->count = spare->count = 0;
  for (i = 0; i < 4; ++i) simplex->weight[i] = i == 0;
  secant.known = 0, secant.newest = 2;
  if (length2 > 1e-200) {
    way = about_unit(first, length2);
    n = over(first, sqrt(length2));
  }
  ++*iterations;
  if (!look(d, way, n, &simplex->point[0], &value)) return FAULT;
  w[0] = simplex->point[0].w;
  nearest_voronoi(w, 1, &nearest);
  keep(simplex, w, &nearest, d, spare);
  if (patience >= 0) remember(&secant, n, w[0], value);
  towards = nearest.direction;
  distance2 = nearest.distance2;
  for (;;) {
    Point* fresh;
    if (d->upper - d->lower <= gap) return closed(d);
    if (d->upper <= d->rounding) return OVERLAP;
    if (*iterations >= cap) return CAP;
    d2 = norm2(towards);
    if (!(d2 > 0)) return OVERLAP;
    best = d->lower;
    guessed = patience >= 0 && --plain < 0 && best > d->rounding && guess(&secant, watch, &n);
    way = guessed ? n : about_unit(towards, d2);
    if (!guessed) n = mul(1 / sqrt(d2), towards);
    fresh = &simplex->point[simplex->count];
    ++*iterations;
    if (!look(d, way, n, fresh, &value)) return FAULT;
    if (patience >= 0) remember(&secant, n, fresh->w, value);
    if (guessed && !(d->lower > best)) plain = patience;
    if (d->upper - d->lower <= gap) return closed(d);
    w[simplex->count] = fresh->w;
    known = repeated(w, simplex->count);
    if (known && !guessed) return STUCK;
    if (known) clear_nearest(&nearest);
    if (known || !descend(last_only, d, w, simplex->count + 1, distance2, &nearest)) {
      if (guessed && !(nearest.inside && d->lower > d->slack)) {
        plain = patience;
        continue;
      }
      return !nearest.inside || d->lower <= d->slack ? STUCK : FAULT;
    }
    towards = nearest.direction;
    distance2 = nearest.distance2;
    keep(simplex, w, &nearest, d, spare);
    if (nearest.inside && d->upper - d->lower > gap) return OVERLAP;
  }
}

// ---- poses: core/quat.h, core/pose.h, abi/check.h ----
static Mat matrix_of(CAROM_GLOBAL const double* given) {
  const double n2 = (given[0] * given[0] + given[1] * given[1]) + (given[2] * given[2] + given[3] * given[3]);
  const double s = fabs(n2 - 1) <= 12 * K_U ? 1 : 1 / sqrt(n2);
  const double x = given[0] * s, y = given[1] * s, z = given[2] * s, w = given[3] * s;
  const double tx = 2 * x, ty = 2 * y, tz = 2 * z;
  const double twx = tx * w, twy = ty * w, twz = tz * w;
  const double txx = tx * x, txy = ty * x, txz = tz * x;
  const double tyy = ty * y, tyz = tz * y, tzz = tz * z;
  Mat m;
  m.c[0] = vec(1 - (tyy + tzz), txy + twz, txz - twy);
  m.c[1] = vec(txy - twz, 1 - (txx + tzz), tyz + twx);
  m.c[2] = vec(txz + twy, tyz - twx, 1 - (txx + tyy));
  return m;
}
static int usable(const Mat* r, Vec p) {
  const Vec a = r->c[0], b = r->c[1], c = r->c[2];
  const double turn = ((fabs(a.x) + fabs(a.y)) + (fabs(a.z) + fabs(b.x))) +
                      ((fabs(b.y) + fabs(b.z)) + (fabs(c.x) + (fabs(c.y) + fabs(c.z))));
  return abs_sum(p) < 1e100 && turn < 6;
}
static int is_finite(double x) { return x - x == 0; }

static void put(CAROM_GLOBAL double* to, Vec v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }

// ---- generic.cpp, abi/query.cpp ----
// Pair i of a call. Shapes that a device does not ask are marked by an index beyond all.
// poses: 14 each: position, orientation (x, y, z, w) of A, then of B
static void measure(const Stage* stage, uint32_t shape_a, uint32_t shape_b, CAROM_GLOBAL const double* pose,
                    double tolerance, double shell, uint32_t last_only, uint32_t cap,
                    CAROM_GLOBAL carom_distance_data* out) {
  CAROM_GLOBAL const carom_shape_data *a, *b;
  const Vec pa = vec(pose[0], pose[1], pose[2]), pb = vec(pose[7], pose[8], pose[9]);
  Mat ra, rb;
  Difference d;
  Simplex simplex, spare;
  const Simplex* nearest;
  Vec to, first, on_a = vec(0, 0, 0), on_b = vec(0, 0, 0), point_a, point_b;
  double size, pair_size, width, metre, radii, gap, low, high, lower, upper, pose_slack, small, large;
  uint32_t iterations = 0, status;
  int end, i, patience, watch;
  out->status = LEFT;
  if (shape_a == 0xFFFFFFFFu || shape_b == 0xFFFFFFFFu) return;
  a = stage->shapes + shape_a, b = stage->shapes + shape_b;
  ra = matrix_of(pose + 3), rb = matrix_of(pose + 10);
  d.stage = stage, d.a = a, d.b = b, d.calls = 0;
  for (i = 0; i < 3; ++i) d.rotation.c[i] = turned_back(&ra, rb.c[i]);
  d.offset = turned_back(&ra, sub(pb, pa));
  if (!usable(&d.rotation, d.offset)) return;
  size = abs_sum(d.offset) + a->bounding_radius + b->bounding_radius + shell;
  if (!is_finite(size)) return;
  {
    uint64_t field = CAROM_BITS(size) >> 52;
    field = field < 22 ? 22 : (field > 2022 ? 2022 : field);
    d.scale = CAROM_DOUBLE((2045 - field) << 52);
  }
  metre = 1 / d.scale;
  d.rounding = K_BRACKET * K_U * (d.scale * size);
  radii = d.scale * (a->core_radius + b->core_radius + shell);
  d.slack = 1e-6 * (d.scale * size);
  d.lower = -K_INFINITY, d.upper = K_INFINITY, d.normal = vec(1, 0, 0);
  small = least(a->bounding_radius, b->bounding_radius), large = most(a->bounding_radius, b->bounding_radius);
  pair_size = small > 0 ? small : (large > 0 ? large : size3(d.offset));
  width = tolerance * pair_size;
  gap = most(width * d.scale - 2 * d.rounding, d.rounding);
  patience = a->faceted && b->faceted ? -1 : (a->smooth && b->smooth ? 2 : 4);
  watch = !(a->smooth && b->smooth) || patience < 0;
  to = vec(b->middle[0], b->middle[1], b->middle[2]);
  first = mul(d.scale, sub(add(turned(&d.rotation, to), d.offset), vec(a->middle[0], a->middle[1], a->middle[2])));
  if (!is_finite(first.x) || !is_finite(first.y) || !is_finite(first.z)) first = mul(d.scale, d.offset);
  end = walk(&d, (int)last_only, gap, cap, patience, watch, first, &simplex, &spare, &iterations);
  if (end == FAULT || end == OVERLAP || !(d.upper < K_INFINITY)) return;
  if (end != NARROW && d.lower <= d.rounding) return;
  if (end == STUCK && d.upper - d.lower > gap) return;
  low = least(d.lower, d.upper), high = most(d.lower, d.upper);
  nearest = spare.count > 0 ? &spare : &simplex;
  for (i = 0; i < nearest->count; ++i) {
    on_a = add(on_a, mul(nearest->weight[i], nearest->point[i].a));
    on_b = add(on_b, mul(nearest->weight[i], nearest->point[i].b));
  }
  point_a = add(on_a, mul(a->core_radius + 0.5 * shell, d.normal));
  point_b = sub(on_b, mul(b->core_radius + 0.5 * shell, turned_back(&d.rotation, d.normal)));
  lower = (low - radii - d.rounding) * metre;
  upper = (high - radii + d.rounding) * metre;
  status = upper - lower <= width ? EXACT_ENOUGH : (end == CAP ? CAPPED : ROUNDING);
  pose_slack = K_POSE * K_U * (size3(d.offset) + a->bounding_radius + b->bounding_radius);
  lower -= pose_slack;
  upper += pose_slack;
  if (!(upper - lower <= width) && status == EXACT_ENOUGH) status = ROUNDING;
  out->separation = (d.lower - radii) * metre;
  out->lower = lower;
  out->upper = upper;
  put(out->normal, turned(&ra, d.normal));
  put(out->point_a, add(turned(&ra, point_a), pa));
  put(out->point_b, add(turned(&rb, point_b), pb));
  out->gjk_iterations = iterations;
  out->epa_iterations = 0;
  out->support_calls = d.calls;
  out->reserved = 0;
  out->status = status;
}

CAROM_KERNEL carom_measure_pairs(CAROM_GLOBAL const carom_shape_data* shapes, CAROM_GLOBAL const double* numbers,
                                 CAROM_GLOBAL const int64_t* corners, CAROM_GLOBAL const uint32_t* links,
                                 CAROM_GLOBAL const uint32_t* which, CAROM_GLOBAL const double* poses, double tolerance,
                                 double shell, uint32_t last_only, uint32_t cap, uint32_t count,
                                 CAROM_GLOBAL carom_distance_data* out) {
  const uint64_t i = CAROM_ITEM();
  Stage stage;
  stage.shapes = shapes, stage.numbers = numbers, stage.corners = corners, stage.links = links;
  if (i < count)
    measure(&stage, which[2 * i], which[2 * i + 1], poses + 14 * i, tolerance, shell, last_only, cap, out + i);
}

// Support points of a shape along given directions, for the check of a plugin's text: 3 numbers each, and what was returned.
CAROM_KERNEL carom_ask_directions(uint32_t plugin, CAROM_GLOBAL const double* numbers, uint64_t first,
                                  uint64_t number_count, CAROM_GLOBAL const double* directions, uint32_t count,
                                  CAROM_GLOBAL double* out) {
  const uint64_t i = CAROM_ITEM();
  double dir[3], found[3];
  if (i >= count) return;
  dir[0] = directions[3 * i], dir[1] = directions[3 * i + 1], dir[2] = directions[3 * i + 2];
  found[0] = found[1] = found[2] = 0;
  out[4 * i + 3] = carom_ask(plugin, numbers + first, number_count, dir, found);
  out[4 * i] = found[0], out[4 * i + 1] = found[1], out[4 * i + 2] = found[2];
}

// What a device must round as the host does: a sum of products (contracted or not), a quotient, a root, a number below the
// smallest normal one.
CAROM_KERNEL carom_try_arithmetic(CAROM_GLOBAL const double* numbers, uint32_t count, CAROM_GLOBAL double* out) {
  const uint64_t i = CAROM_ITEM();
  double x, y, z;
  if (i >= count) return;
  x = numbers[3 * i], y = numbers[3 * i + 1], z = numbers[3 * i + 2];
  out[4 * i] = x * y + z;
  out[4 * i + 1] = x / y;
  out[4 * i + 2] = sqrt(x * x);
  out[4 * i + 3] = x * 0x1p-1040 * 0x1p-20;
}
