// What is remembered of pairs: records of the pair table, inactive or not, and the impulses that a step starts from.
#include <algorithm>

#include "collision/scenery/scenery.h"
#include "dynamics/contact/contact.h"
#include "dynamics/snapshot/impulse.h"

namespace carom::dynamics::snapshot {
namespace {

template <class Io, class P>
Pair pair(Io& io, const World& world, const P& now) {
  const Pair p{io.value(now.a), io.value(now.b)};
  if constexpr (Io::checks) {
    const Scene& s = world.scene;
    const bool there = p.a < p.b && s.collider_slots.alive(p.a) && s.collider_slots.alive(p.b);
    io.demand(there);
    if (there) io.demand(s.colliders.body[p.a] != s.colliders.body[p.b]);
  }
  return p;
}

bool is_unit(const Vec3& n) { return std::fabs(n.squared_norm() - 1) < 0.5; }

template <class Io, class P>
void point(Io& io, P& p) {
  const Vec3 on_a = io.vec(p.on_a), on_b = io.vec(p.on_b), normal = io.vec(p.normal);
  const Real separation = io.real(p.separation);
  const std::uint32_t feature = io.value(p.feature), age = io.value(p.age);
  io.demand(is_unit(normal));
  keep(io, p.on_a, on_a), keep(io, p.on_b, on_b), keep(io, p.normal, normal);
  keep(io, p.separation, separation), keep(io, p.feature, feature), keep(io, p.age, age);
}

template <class Io, class F>
void frame(Io& io, F& f) {
  const Mat3 r = io.mat(f.r);
  const Vec3 p = io.vec(f.p);
  keep(io, f.r, r), keep(io, f.p, p);
}

template <class Io, class C>
void certificate(Io& io, C& c) {
  const Real shell = io.real(c.shell), lower = io.value(c.lower), upper = io.value(c.upper);
  io.demand(!(lower != lower) && !(upper != upper));
  const Vec3 normal = io.vec(c.normal), a = io.vec(c.point_a), b = io.vec(c.point_b);
  keep(io, c.known, true), keep(io, c.shell, shell), keep(io, c.lower, lower), keep(io, c.upper, upper);
  keep(io, c.normal, normal), keep(io, c.point_a, a), keep(io, c.point_b, b);
  frame(io, c.b_in_a);
}

enum RecordBits : std::uint8_t { kPoints = 7, kWarm = 8, kCertain = 16, kFirm = 32, kOfB = 64, kMoreCorners = 128 };

/// All of a record but its pair.
/// @param certified  null: there is no certificate
template <class Io, class R, class C>
void record(Io& io, R& r, C* certified, int& points) {
  const bool warm = Io::saves && !zero_bits(r.memory.direction);
  const auto bits =
      io.value(Io::saves ? static_cast<std::uint8_t>(
                               r.manifold.count | (warm ? kWarm : 0) | (certified && certified->known ? kCertain : 0) |
                               (r.patch.firm ? kFirm : 0) | (r.patch.firm && r.patch.of_b ? kOfB : 0) |
                               (r.manifold.has_more_corners ? kMoreCorners : 0))
                         : std::uint8_t(0));
  points = bits & kPoints;
  io.demand(points <= Manifold::kMaxPoints);
  if (io.bad()) return;
  if constexpr (Io::loads) r.memory = QueryMemory{}, r.manifold = Manifold{}, r.patch = PatchMemory{};
  if (bits & kWarm) {
    const Vec3 direction = io.vec(r.memory.direction);
    keep(io, r.memory.direction, direction);
  }
  if constexpr (Io::loads)
    if (certified) *certified = Certificate{};
  if (bits & kCertain) {
    if constexpr (Io::checks) io.needs.certificates = true;
    certificate(io, *certified);
  }
  keep(io, r.manifold.count, points), keep(io, r.manifold.has_more_corners, (bits & kMoreCorners) != 0);
  for (int k = 0; k < points; ++k) point(io, r.manifold.point[k]);
  if (!(bits & kFirm)) return;
  const Vec3 normal = io.vec(r.patch.normal);
  io.demand(is_unit(normal));
  keep(io, r.patch.firm, true), keep(io, r.patch.of_b, (bits & kOfB) != 0), keep(io, r.patch.normal, normal);
  frame(io, r.patch.b_in_a);
}

}  // namespace

/// A friend of the table's: records are inactive and found again in an order that follows from where they stand, so
/// each keeps its place.
class PairTableImage {
  using Links = Array<PairTable::Inactive>;
  using Pairs = Array<Pair>;

 public:
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& t = world.pairs;
    const std::uint64_t places = io.count(t.order_.size(), 9);
    const std::uint64_t inactive = io.count(t.inactive_count_, 9), free = io.count(t.free_.size(), 4);
    const std::uint64_t records = places + inactive + free;
    if constexpr (Io::checks) {
      io.needs.places = places, io.needs.records = records, io.needs.free_records = free, io.needs.inactive = inactive;
      io.demand(records < kNew);
      if (io.bad()) return;
    }
    if constexpr (Io::loads) {
      t.clear();
      t.order_.resize(places), t.records_.resize(records), t.free_.resize(free);
      if (t.certificates_.capacity() >= records) t.certificates_.resize(records);  // as reserve() found
      if (inactive > 0) t.inactive_.resize(records), t.head_.assign(world.scene.colliders.slots(), kNew);
    }
    Array<std::uint8_t> seen(Io::checks ? records : 0, 0, world.memory);  // by record
    const auto once = [&](std::uint32_t r) {
      if constexpr (Io::checks) {
        io.demand(r < seen.size() && !seen[r]);
        if (!io.bad()) seen[r] = 1;
      }
    };
    Pair last{0, 0};
    for (std::uint64_t k = 0; k < places && !io.bad(); ++k) place(io, world, k, once, last);
    io.begin_item();
    io.name_item(Item::none);
    for (std::uint64_t k = 0; k < free && !io.bad(); ++k) {
      const std::uint32_t r = io.value(Io::saves ? t.free_[k] : 0u);
      once(r);
      if constexpr (Io::loads) t.free_[k] = r;
    }
    if (inactive > 0) deactivate(io, world, inactive, once);
  }

  static void reserve(World& world, const Needs& n) {
    PairTable& t = world.pairs;
    const std::size_t inactive = n.inactive > 0 ? n.records : 0;
    t.order_.reserve(n.places), t.records_.reserve(n.records), t.free_.reserve(n.free_records);
    t.certificates_.reserve(n.certificates ? n.records : 0);
    t.inactive_.reserve(inactive), t.head_.reserve(inactive ? world.scene.colliders.slots() : 0);
  }

 private:
  static constexpr std::uint32_t kNew = PairTable::kNew;

  template <class Io, class W, class Once>
  static void place(Io& io, W& world, std::uint64_t k, const Once& once, Pair& last) {
    auto& t = world.pairs;
    const PairTable::Place now = Io::checks ? PairTable::Place{} : t.order_[k];
    io.begin_item();
    const Pair p = pair(io, world, now.pair);
    io.name_item(Item::pair, p.a, p.b);
    const std::uint32_t at = io.value(now.record);
    Real horizon = io.value(now.horizon);
    once(at);
    if (io.bad()) return;
    int points = 0;
    if constexpr (Io::checks) {
      const auto& shape = world.scene.colliders.shape;
      const bool scenery = is_scenery(*shape[p.a]) || is_scenery(*shape[p.b]);
      io.demand(k == 0 || last < p || (last == p && scenery));
      PairRecord none;
      Certificate unknown;
      record(io, none, &unknown, points);
      io.demand(points == 0 || scenery || horizon == -kInfinity);  // what touches is asked again
      last = p;
    } else {
      record(io, t.records_[at], t.certificate_of(at), points);
    }
    if constexpr (Io::loads) {
      t.order_[k] = {p, at, static_cast<std::uint32_t>(points), horizon};
    }
  }

  /// Inactive records, in the order of their numbers, with the lists of colliders that they are linked in.
  template <class Io, class W, class Once>
  static void deactivate(Io& io, W& world, std::uint64_t inactive, const Once& once) {
    auto& t = world.pairs;
    Links links(Io::checks ? t_size(io) : 0, PairTable::Inactive{}, world.memory);
    Pairs pairs(links.size(), Pair{0, 0}, world.memory);
    std::uint32_t r = 0;
    for (std::uint64_t k = 0; k < inactive && !io.bad(); ++k, ++r) {
      if constexpr (Io::saves)
        while (t.inactive_[r].holders == PairTable::none) ++r;
      r = io.value(r);
      once(r);
      if (io.bad()) return;
      const Pair p = pair(io, world, Io::saves ? t.inactive_[r].pair : Pair{0, 0});
      PairTable::Inactive now = Io::saves ? t.inactive_[r] : PairTable::Inactive{};
      now.holders = io.value(now.holders), now.at = io.value(now.at);
      io.demand(now.holders >= 1 && now.holders <= 3);
      for (std::uint32_t& next : now.next) next = io.value(next);
      int points = 0;
      if constexpr (Io::checks) {
        PairRecord none;
        Certificate unknown;
        record(io, none, &unknown, points);
        links[r] = now, pairs[r] = p;
      } else {
        record(io, t.records_[r], t.certificate_of(r), points);
      }
      now.pair = p;
      if constexpr (Io::loads) t.inactive_[r] = now;
    }
    if constexpr (Io::loads) t.inactive_count_ = inactive;
    heads(io, world, links, pairs);
  }

  /// Where the lists begin.
  template <class Io, class W>
  static void heads(Io& io, W& world, const Links& links, const Pairs& pairs) {
    auto& t = world.pairs;
    const auto full = [](std::uint32_t head) { return head != kNew; };
    const std::uint64_t n =
        io.count(Io::saves ? static_cast<std::uint64_t>(std::ranges::count_if(t.head_, full)) : 0, 8);
    std::size_t linked = 0;  // ends of links that were met
    std::uint32_t collider = 0;
    for (std::uint64_t k = 0; k < n && !io.bad(); ++k, ++collider) {
      if constexpr (Io::saves)
        while (!full(t.head_[collider])) ++collider;
      const std::uint32_t least = collider;
      collider = io.value(collider);
      const std::uint32_t head = io.value(Io::saves ? t.head_[collider] : 0u);
      if constexpr (Io::loads) t.head_[collider] = head;
      if constexpr (Io::checks) {
        io.demand(collider >= least);
        for (std::uint32_t r = head; r != kNew && !io.bad(); ++linked) {
          io.demand(r < links.size() && linked < 2 * links.size());
          if (io.bad()) return;
          const bool is_b = pairs[r].b == collider;
          io.demand((is_b || pairs[r].a == collider) && (links[r].holders >> is_b & 1));
          r = links[r].next[is_b];
        }
      }
    }
    if constexpr (Io::checks) {
      std::size_t wanted = 0;
      for (const PairTable::Inactive& link : links) wanted += (link.holders & 1u) + (link.holders >> 1);
      io.demand(linked == wanted);  // so no list runs in a circle, and none is left out
    }
  }

  template <class Io>
  static std::size_t t_size(const Io& io) {
    if constexpr (Io::checks)
      return io.needs.records;
    else
      return 0;
  }
};

namespace {

struct Remembered {
  template <class Io, class W>
  static void go(Io& io, W& world) {
    auto& c = world.impulses;
    const Real h = io.real(c.old_h);
    io.demand(h >= 0);
    keep(io, c.old_h, h);
    const std::uint64_t n = io.count(c.old.size(), 57);
    if constexpr (Io::checks) io.needs.old = n;
    if constexpr (Io::loads) c.old.resize(n);
    Pair last{0, 0};
    for (std::uint64_t k = 0; k < n && !io.bad(); ++k) {
      io.begin_item();
      if constexpr (Io::checks) {
        const OldImpulse o = impulse(io, OldImpulse{});
        io.name_item(Item::pair, o.pair.a, o.pair.b);
        io.demand(!(o.pair < last) && o.pair.a < o.pair.b && o.pair.b < world.scene.colliders.slots() && h > 0);
        last = o.pair;
      } else {
        const OldImpulse o = impulse(io, Io::saves ? c.old[k] : OldImpulse{});
        keep(io, c.old[k], o);
      }
    }
  }
};

}  // namespace

void reserve_pairs(World& world, const Needs& needs) { PairTableImage::reserve(world, needs); }

constinit const Section kPairs = section<PairTableImage>("PAIR", "pairs");
constinit const Section kImpulses = section<Remembered>("IMPU", "impulses");

}  // namespace carom::dynamics::snapshot
