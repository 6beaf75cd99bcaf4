// Bytes of a snapshot, written and read by one description of what is in them: a module says value(now) for each thing
// in turn, and what comes back is that thing when saving, or what the bytes say of it when checking or loading.
//
// Saving writes, and only counts once the buffer is full. Checking reads and says whether a world could have written
// that: it is the only one that meets bytes which nothing vouches for. Loading reads the same bytes once more, into the
// world; it neither fails nor allocates. A section that is absent reads as zeros, which mean what a new world has.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "core/memory.h"
#include "core/pose.h"

namespace carom::dynamics::snapshot {

static_assert(std::endian::native == std::endian::little, "snapshots are little-endian");
static_assert(sizeof(Real) == 8, "and hold doubles");

/// What of a world stands at a place of the bytes.
enum class Item : std::uint8_t { none, body, collider, pair, joint, set, field, spring, material };

/// Capacity that loading wants to find in the arrays of a world, found out by checking.
struct Needs {
  std::size_t places = 0, records = 0, free_records = 0, inactive = 0;  // of the pair table
  std::size_t old = 0, kept = 0;                                        // impulses
  std::size_t driven = 0;                                               // bodies that a host moves
  std::size_t sleepers = 0;                                             // slots of the arrays of sleep
  std::size_t fallen = 0, woken = 0, touched_by_host = 0, rejoined = 0;
  std::size_t touching = 0, within = 0, slept = 0, faulty = 0, apart = 0, unbroken = 0, axes = 0;
  std::size_t material_pairs = 0;
  std::uint32_t attributes = 0;  // of bodies: a bit for each that some body has
  bool modes = false, certificates = false;
  bool filter = false, sensor = false, surface = false;

  struct Set {
    std::uint32_t slot;
    std::uint64_t particles;
    bool weighed;
  };
  explicit Needs(Memory* m) : sets(m) {}
  Array<Set> sets;  // of particles
};

class Saver {
 public:
  static constexpr bool saves = true, checks = false, loads = false;
  Saver(std::byte* to, std::uint64_t capacity) : to_(to), capacity_(capacity) {}

  std::uint64_t size() const { return size_; }
  /// Whether anything but zeros was written since: what is all zeros need not be.
  void begin_part() { marked_ = false; }
  bool marked() const { return marked_; }
  void shrink(std::uint64_t size) { size_ = size; }

  void put(const void* from, std::uint64_t n) {
    marked_ |= n > 0;
    put_unmarked(from, n);
  }
  void put_unmarked(const void* from, std::uint64_t n) {
    if (size_ + n <= capacity_ && n > 0) std::memcpy(to_ + size_, from, n);
    size_ += n;
  }
  void align() {
    static constexpr std::byte kZeros[8]{};
    put_unmarked(kZeros, -size_ % 8);
  }
  /// Over what stands there already.
  void put_at(std::uint64_t at, const void* from, std::uint64_t n) {
    if (at + n <= capacity_) std::memcpy(to_ + at, from, n);
  }

  template <class T>
  T value(const T& now) {
    static_assert(std::is_arithmetic_v<T>);
    static constexpr T kZero{};
    marked_ |= std::memcmp(&now, &kZero, sizeof now) != 0;
    put_unmarked(&now, sizeof now);
    return now;
  }
  Real real(Real now) { return value(now); }
  Vec3 vec(const Vec3& now) { return put(now.data(), sizeof(Real) * 3), now; }
  Quat quat(const Quat& now) { return put(now.data(), sizeof(Real) * 4), now; }
  Mat3 mat(const Mat3& now) { return put(now.data(), sizeof(Real) * 9), now; }
  std::uint64_t count(std::uint64_t now, std::size_t) { return value(now); }
  template <class T>
  void column(const T* from, std::uint64_t n) {
    put(from, sizeof(T) * n);
  }
  void demand(bool) {}
  bool bad() const { return false; }
  void begin_item() {}
  void name_item(Item, std::uint32_t = 0, std::uint32_t = 0) {}

 private:
  std::byte* to_;
  std::uint64_t capacity_, size_ = 0;
  bool marked_ = false;
};

/// What checking and loading share.
class Reader {
 public:
  static constexpr bool saves = false;
  template <class T>
  T value(const T&) {
    static_assert(std::is_arithmetic_v<T>);
    T out{};
    get(&out, sizeof out);
    return out;
  }
  bool bad() const { return bad_; }

 protected:
  Reader(const std::byte* from, const std::byte* end, bool absent) : at_(from), end_(end), absent_(absent) {}
  void get(void* to, std::uint64_t n) {
    if (n <= left()) {
      if (n > 0) std::memcpy(to, at_, n);
      at_ += n;
    } else {
      std::memset(to, 0, n);
      bad_ |= !absent_;
      at_ = end_;
    }
  }
  std::uint64_t left() const { return static_cast<std::uint64_t>(end_ - at_); }

  const std::byte *at_, *end_;
  bool absent_, bad_ = false;
};

class Checker : public Reader {
 public:
  static constexpr bool checks = true, loads = false;
  Checker(const std::byte* from, const std::byte* end, bool absent, Needs& wanted)
      : Reader(from, end, absent), needs(wanted) {}

  void demand(bool holds) { bad_ |= !holds; }
  Real real(Real now) {
    const Real x = value(now);
    demand(finite(x));
    return x;
  }
  Vec3 vec(const Vec3&) { return finite_of<Vec3>(); }
  Quat quat(const Quat&) { return finite_of<Quat>(); }
  Mat3 mat(const Mat3&) { return finite_of<Mat3>(); }
  /// How many follow, of at least so many bytes each.
  std::uint64_t count(std::uint64_t now, std::size_t least) {
    const std::uint64_t n = value(now);
    if (n <= left() / least) return n;
    bad_ = true;
    return 0;
  }
  template <class T>
  void column(const T*, std::uint64_t n) {
    if (n > left() / sizeof(T)) {
      bad_ = true;
      return;
    }
    if constexpr (std::is_floating_point_v<T>)
      for (std::uint64_t i = 0; i < n; ++i) {
        T x;
        std::memcpy(&x, at_ + sizeof(T) * i, sizeof x);
        demand(finite(x));
      }
    at_ += sizeof(T) * n;
  }
  bool at_end() const { return at_ == end_; }

  /// To be told what stands at a place: the last that begins at it or before it.
  void watch(const std::byte* place) { watched_ = place; }
  void begin_item() { item_begin_ = at_; }
  void name_item(Item item, std::uint32_t a = 0, std::uint32_t b = 0) {
    if (item_begin_ <= watched_) item_ = item, item_a_ = a, item_b_ = b;
  }
  Item item(std::uint32_t& a, std::uint32_t& b) const {
    a = item_a_, b = item_b_;
    return item_;
  }

  Needs& needs;

 private:
  template <class V>
  V finite_of() {
    V v;
    get(v.at, sizeof v.at);
    for (const Real x : v.at) demand(finite(x));
    return v;
  }

  const std::byte *watched_ = nullptr, *item_begin_ = nullptr;
  Item item_ = Item::none;
  std::uint32_t item_a_ = 0, item_b_ = 0;
};

class Loader : public Reader {
 public:
  static constexpr bool checks = false, loads = true;
  Loader(const std::byte* from, const std::byte* end, bool absent) : Reader(from, end, absent) {}

  void demand(bool) {}
  void begin_item() {}
  void name_item(Item, std::uint32_t = 0, std::uint32_t = 0) {}
  Real real(Real now) { return value(now); }
  Vec3 vec(const Vec3&) {
    Vec3 v;
    return get(v.data(), sizeof(Real) * 3), v;
  }
  Quat quat(const Quat&) {
    Quat q;
    get(q.data(), sizeof(Real) * 4);
    return q;
  }
  Mat3 mat(const Mat3&) {
    Mat3 m;
    return get(m.data(), sizeof(Real) * 9), m;
  }
  std::uint64_t count(std::uint64_t now, std::size_t) { return value(now); }
  template <class T>
  void column(T* to, std::uint64_t n) {
    get(to, sizeof(T) * n);
  }
};

/// Into the world, when loading.
template <class Io, class To, class T>
void keep(const Io&, To& to, const T& value) {
  if constexpr (Io::loads) to = value;
}

/// -0 is not 0 here, and NaN is itself.
template <class V>
bool same_bits(const V& a, const V& b) {
  return std::memcmp(a.at, b.at, sizeof a.at) == 0;
}
inline bool same_bits(Real a, Real b) { return std::memcmp(&a, &b, sizeof a) == 0; }
inline bool zero_bits(const Vec3& v) { return same_bits(v, Vec3(Vec3::zero())); }

/// A number of a few bits of yes and no.
template <class Io>
bool yes_or_no(Io& io, bool now) {
  const auto v = io.value(static_cast<std::uint8_t>(now));
  io.demand(v <= 1);
  return v != 0;
}

}  // namespace carom::dynamics::snapshot
