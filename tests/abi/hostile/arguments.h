// Arguments of a call, each with what is good for it and all that is wrong: what the caller passes, and which results it may
// get for it. Out of them a call, which can then be made with any choice among them.
#pragma once

#include <array>
#include <cfloat>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <utility>

#include "stage.h"

namespace hostile {

/// A set of results: bit 0 is OK, bit k is the code -k.
using Codes = uint64_t;
constexpr Codes code(int32_t result) { return Codes(1) << -result; }
constexpr Codes kNull = code(CAROM_E_NULL_ARGUMENT), kNotFinite = code(CAROM_E_NOT_FINITE),
                kRange = code(CAROM_E_OUT_OF_RANGE), kNotUnit = code(CAROM_E_NOT_UNIT),
                kEnum = code(CAROM_E_UNKNOWN_ENUM), kSize = code(CAROM_E_STRUCT_SIZE),
                kUnsupported = code(CAROM_E_UNSUPPORTED), kInvalid = code(CAROM_E_INVALID_HANDLE),
                kStale = code(CAROM_E_STALE_HANDLE), kWrongKind = code(CAROM_E_WRONG_KIND),
                kWrongWorld = code(CAROM_E_WRONG_WORLD), kSmall = code(CAROM_E_BUFFER_TOO_SMALL),
                kFine = code(CAROM_OK), kInUse = code(CAROM_E_IN_USE), kNoVolume = code(CAROM_E_NO_VOLUME),
                kLimit = code(CAROM_E_LIMIT), kMemory = code(CAROM_E_OUT_OF_MEMORY), kCorrupt = code(CAROM_E_CORRUPT),
                kMismatch = code(CAROM_E_MISMATCH), kNotFound = code(CAROM_E_NOT_FOUND);
/// Codes go from here to CAROM_OK.
constexpr int32_t kLastCode = CAROM_E_READ_ONLY;
/// Refused as a number, or taken: nobody says which, but the world stays as it was or stays finite.
constexpr Codes kPerhaps = kFine | kRange | kNotFinite | kNotUnit | kUnsupported | kNoVolume | kEnum;

union Value {
  const void* p;
  uint64_t u;
  double d;
};
inline Value of(const void* p) {
  Value v;
  v.p = p;
  return v;
}
inline Value of(uint64_t u) {
  Value v;
  v.u = u;
  return v;
}
inline Value of(double d) {
  Value v;
  v.d = d;
  return v;
}

struct Wrong {
  std::string what;
  Value value;
  Codes codes;
  int32_t argument = -1;  // which the error names; -1: the one this stands for
};

struct Argument {
  Value good{};
  std::vector<Wrong> wrong;
  void* out = nullptr;  // where the call writes, and how much
  std::size_t out_size = 0;
  bool impossible = false;  // there is nothing good to pass (no such object lives)
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();

/// What calls are made on, by whom, with memory for their arguments.
struct Context {
  Stage &own, &other;  // other: another engine and a world of it
  Stage& second;       // another world of `own`'s engine
  Source& source;
  std::vector<std::unique_ptr<char[]>> blocks;
  std::vector<std::shared_ptr<carom_batch>> batches;
  carom_error error;
  bool wants_wrong = true;   // else only what is good is made up, which is quick
  bool to_the_edge = false;  // one good number in four is anything that its bounds allow
  bool is_edged = false;     // one was: so what is made of them may be refused

  Context(Stage& s, Stage& o, Stage& w, Source& c) : own(s), other(o), second(w), source(c) {}
  /// Exactly so many bytes, so that an address sanitizer sees one too many.
  void* take(std::size_t size, int fill = 0) {
    blocks.emplace_back(new char[size]);
    std::memset(blocks.back().get(), fill, size);
    return blocks.back().get();
  }
  template <class T>
  T* keep(const T& value) {
    return static_cast<T*>(std::memcpy(take(sizeof(T)), &value, sizeof(T)));
  }
  double between(double low, double high) { return low + (high - low) * source.unit(); }
};

// ---- single values ----
inline Argument fixed(const void* p) { return {of(p), {}}; }
inline Argument fixed_number(uint64_t u) { return {of(u), {}}; }
inline Argument world(Context& c) {
  return {of(static_cast<const void*>(c.own.world)), {{"null", of(nullptr), kNull}}};
}
inline Argument engine(Context& c) {
  return {of(static_cast<const void*>(c.own.engine)), {{"null", of(nullptr), kNull}}};
}

inline std::vector<Wrong> wrong_handles(Context& c, Kind kind, bool may_be_null) {
  std::vector<Wrong> wrong;
  if (!c.wants_wrong) return wrong;
  if (!may_be_null) wrong.push_back({"null handle", of(uint64_t(0)), kInvalid});
  wrong.push_back({"never issued", of(uint64_t(0x0123456789abcdef)), kInvalid});
  wrong.push_back({"all bits", of(~uint64_t(0)), kInvalid});
  if (!c.own.live[kind].empty())
    wrong.push_back({"slot beyond all", of(c.own.live[kind][0].handle | 0xFFFFFF), kInvalid});
  if (!c.own.stale[kind].empty()) {
    const std::vector<uint64_t>& stale = c.own.stale[kind];
    wrong.push_back({"destroyed", of(stale[c.source.below(static_cast<unsigned>(stale.size()))]), kStale});
  }
  for (int k = 0; k < kKinds; ++k)
    if (k != kind && !c.own.live[k].empty()) wrong.push_back({"another kind", of(c.own.live[k][0].handle), kWrongKind});
  if (!c.other.live[kind].empty()) wrong.push_back({"another engine's", of(c.other.live[kind][0].handle), kWrongWorld});
  if (kind != kPlugin && kind != kShape && !c.second.live[kind].empty())
    wrong.push_back({"another world's", of(c.second.live[kind][0].handle), kWrongWorld});
  return wrong;
}

inline uint64_t living(Context& c, Kind kind, bool& none) {
  const std::vector<Owned>& live = c.own.live[kind];
  none = live.empty();
  return none ? 0 : live[c.source.below(static_cast<unsigned>(live.size()))].handle;
}
inline Argument handle(Context& c, Kind kind) {
  Argument a;
  a.good = of(living(c, kind, a.impossible));
  a.wrong = wrong_handles(c, kind, false);
  return a;
}

/// One of the kind, or none.
inline Argument perhaps_handle(Context& c, Kind kind) {
  Argument a = handle(c, kind);
  if (!a.wrong.empty()) a.wrong.erase(a.wrong.begin());  // the null handle
  if (a.impossible || c.source.below(4) == 0) a.good = of(uint64_t(0)), a.impossible = false;
  return a;
}

/// Another one of the kind than `first`, if there is.
inline uint64_t another(Context& c, Kind kind, uint64_t first) {
  const std::vector<Owned>& live = c.own.live[kind];
  if (live.empty()) return 0;
  std::size_t i = c.source.below(static_cast<unsigned>(live.size()));
  if (live[i].handle == first) i = (i + 1) % live.size();
  return live[i].handle;
}
inline Argument another_handle(Context& c, Kind kind, const Argument& first) {
  Argument a = first;
  a.good = of(another(c, kind, first.good.u));
  return a;
}

struct Bounds {
  double low, high;  // what is legal
  bool may_be_infinite = false;
  double usual_low = -2, usual_high = 2;  // what is passed when it is good
};
/// A good number, or one at the edge of what is legal.
inline double perhaps_edged(Context& c, double usual, const Bounds& b) {
  if (!c.to_the_edge || c.source.below(4) != 0) return usual;
  const double edges[] = {b.low, b.high, 1.7e308, -1.7e308, 1e160,  -1e160, 1e100,
                          1e15,  -1e15,  1e9,     1e-9,     1e-170, 4e-310, 0.0};
  const double x = edges[c.source.below(static_cast<unsigned>(std::size(edges)))];
  if (!std::isfinite(x) || x < b.low || x > b.high) return usual;
  c.is_edged = true;
  return x;
}
inline Bounds any() { return {-DBL_MAX, DBL_MAX}; }
constexpr double kLeast = 1e-320, kMost = DBL_MAX;  // of what must be above 0
inline Bounds within(double low, double high) { return {low, high, false, std::fmax(low, -2), std::fmin(high, 2)}; }

inline std::vector<std::pair<double, Codes>> wrong_numbers(const Bounds& b) {
  const auto judge = [&](double x) { return x < b.low || x > b.high ? kRange : kPerhaps; };
  return {{kNan, kNotFinite},
          {kInf, b.may_be_infinite ? kPerhaps : kNotFinite},
          {-kInf, b.may_be_infinite ? kNotFinite | kRange : kNotFinite},
          {1.7e308, judge(1.7e308)},
          {-1.7e308, judge(-1.7e308)},
          {1e160, judge(1e160)},    // its square is infinite
          {1e-170, judge(1e-170)},  // its square is 0
          {4e-310, judge(4e-310)},
          {-4e-310, judge(-4e-310)}};
}
inline std::string shown(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", x);
  return text;
}

inline Argument number(Context& c, Bounds b) {
  Argument a;
  a.good = of(perhaps_edged(c, c.between(b.usual_low, b.usual_high), b));
  for (const auto& [x, codes] : wrong_numbers(b)) a.wrong.push_back({shown(x), of(x), codes});
  return a;
}
inline Argument vector(Context& c, int n, Bounds b) {
  Argument a;
  auto* good = static_cast<double*>(c.take(sizeof(double) * static_cast<std::size_t>(n)));
  for (int i = 0; i < n; ++i) good[i] = perhaps_edged(c, c.between(b.usual_low, b.usual_high), b);
  a.good = of(good);
  if (!c.wants_wrong) return a;
  a.wrong.push_back({"null", of(nullptr), kNull});
  for (int i = 0; i < n; ++i)
    for (const auto& [x, codes] : wrong_numbers(b)) {
      auto* bad = static_cast<double*>(c.take(sizeof(double) * static_cast<std::size_t>(n)));
      std::memcpy(bad, good, sizeof(double) * static_cast<std::size_t>(n));
      bad[i] = x;
      a.wrong.push_back({"[" + std::to_string(i) + "] " + shown(x), of(bad), codes});
    }
  return a;
}
/// Of unit length: n is 3 or 4.
inline void turn(Context& c, int n, double* q) {
  double length2 = 0;
  for (int i = 0; i < n; ++i) q[i] = c.between(-1, 1), length2 += q[i] * q[i];
  if (length2 < 1e-3) q[n - 1] = 1, length2 = 0;
  if (length2 == 0)
    for (int i = 0; i + 1 < n; ++i) q[i] = 0;
  else
    for (int i = 0; i < n; ++i) q[i] /= std::sqrt(length2);
}
inline std::vector<std::pair<std::array<double, 4>, Codes>> wrong_turns(const double* q, int n) {
  std::vector<std::pair<std::array<double, 4>, Codes>> wrong;
  for (int i = 0; i < n; ++i)
    for (const double x : {kNan, kInf, 1e200, -1e200, 1.5}) {
      std::array<double, 4> bad{};
      std::memcpy(bad.data(), q, sizeof(double) * static_cast<std::size_t>(n));
      bad[static_cast<std::size_t>(i)] = x;
      wrong.push_back({bad, x == 1.5 || x == 1e200 || x == -1e200 ? kNotUnit : kNotFinite});
    }
  wrong.push_back({std::array<double, 4>{}, kNotUnit});
  wrong.push_back({std::array<double, 4>{4e-310, 0, 0, 0}, kNotUnit});
  wrong.push_back({std::array<double, 4>{1.00001, 0, 0, 0}, kNotUnit});
  return wrong;
}
inline Argument unit(Context& c, int n) {
  Argument a;
  auto* good = static_cast<double*>(c.take(sizeof(double) * static_cast<std::size_t>(n)));
  turn(c, n, good);
  a.good = of(good);
  if (!c.wants_wrong) return a;
  a.wrong.push_back({"null", of(nullptr), kNull});
  for (const auto& [bad, codes] : wrong_turns(good, n))
    a.wrong.push_back({"not of unit length",
                       of(std::memcpy(c.take(sizeof(double) * static_cast<std::size_t>(n)), bad.data(),
                                      sizeof(double) * static_cast<std::size_t>(n))),
                       codes});
  return a;
}
/// Values 0 to count - 1.
inline Argument choice(Context& c, uint32_t count) {
  return {of(uint64_t(c.source.below(count))),
          {{"unknown value", of(uint64_t(count)), kEnum | kRange | kUnsupported},
           {"all bits", of(uint64_t(0xFFFFFFFF)), kEnum | kRange | kUnsupported}}};
}
inline Argument bits(Context& c, uint32_t known) {
  Argument a{of(uint64_t(c.source.below(known + 1) & known)), {{"unknown bit", of(uint64_t(~known)), kUnsupported}}};
  if (known == 0xFFFFFFFF) a.wrong.clear();
  return a;
}
inline Argument whole(Context& c, uint64_t usual) {
  return {of(uint64_t(c.source.below(static_cast<unsigned>(usual)))), {}};
}

// ---- where answers go ----
inline Argument out(Context& c, std::size_t size) {
  void* p = c.take(size, 0x5a);
  return {of(p), {{"null", of(nullptr), kNull}}, p, size};
}
/// Which a host that does not want it may leave NULL.
inline Argument wanted_out(Context& c, std::size_t size) {
  Argument a = out(c, size);
  a.wrong.clear();
  if (c.source.below(4) == 0) return fixed(nullptr);
  return a;
}
template <class T>
Argument out_struct(Context& c) {
  auto* p = static_cast<T*>(c.take(sizeof(T), 0x5a));
  p->struct_size = sizeof(T);
  Argument a{of(p), {{"null", of(nullptr), kNull}}, p, sizeof(T)};
  if (!c.wants_wrong) return a;
  for (const uint32_t size : {0u, 4u, uint32_t(sizeof(T)) - 1, uint32_t(sizeof(T)) + 1, 4104u, 0xFFFFFFF8u}) {
    auto* bad = static_cast<T*>(c.take(sizeof(T), 0x5a));
    bad->struct_size = size;
    a.wrong.push_back({"struct_size " + std::to_string(size), of(bad), kSize});
  }
  return a;
}
inline Argument error(Context& c) {
  c.error = CAROM_ERROR_INIT;
  auto* small = static_cast<carom_error*>(c.take(sizeof(carom_error)));
  small->struct_size = 4;
  return {of(&c.error), {{"error of 4 bytes", of(small), kSize, 0}}};
}

/// dst, stride, capacity, count: four arguments of a list. `packed`: a stride of 0 is legal.
struct List {
  Argument dst, stride, capacity, count;
};
inline List list(Context& c, std::size_t element, bool packed = false) {
  constexpr uint64_t kRoom = 16;
  List l;
  l.dst = out(c, element * kRoom);
  l.stride = {of(uint64_t(element)), {}};
  std::vector<uint64_t> small = {4};
  if (!packed) small.push_back(0);
  for (const uint64_t s : small) l.stride.wrong.push_back({"stride " + std::to_string(s), of(s), kSmall});
  l.capacity = fixed_number(kRoom);
  l.count = out(c, sizeof(uint64_t));
  return l;
}

// ---- structs that are passed in ----
struct Field {
  enum Type { kNumber, kUnit, kChoice, kBits, kHandle, kPointer, kReserved, kWhole } type;
  std::size_t offset;
  int count = 1;
  Bounds bounds = any();
  uint32_t known = 0;  // choice: how many; bits: which
  Kind kind = kPlugin;
  bool may_be_null = false;
};
#define HOSTILE_NUMBERS(T, name, n, ...) \
  hostile::Field { hostile::Field::kNumber, offsetof(T, name), n, __VA_ARGS__ }
#define HOSTILE_UNIT(T, name, n) \
  hostile::Field { hostile::Field::kUnit, offsetof(T, name), n }
#define HOSTILE_CHOICE(T, name, values) \
  hostile::Field { hostile::Field::kChoice, offsetof(T, name), 1, hostile::any(), values }
#define HOSTILE_BITS(T, name, mask) \
  hostile::Field { hostile::Field::kBits, offsetof(T, name), 1, hostile::any(), mask }
#define HOSTILE_WHOLE(T, name, low, high)                       \
  hostile::Field {                                              \
    hostile::Field::kWhole, offsetof(T, name), 1, { low, high } \
  }
#define HOSTILE_RESERVED(T, name) \
  hostile::Field { hostile::Field::kReserved, offsetof(T, name) }
#define HOSTILE_HANDLE(T, name, kind, may_be_null) \
  hostile::Field { hostile::Field::kHandle, offsetof(T, name), 1, hostile::any(), 0, kind, may_be_null }
#define HOSTILE_POINTER(T, name) \
  hostile::Field { hostile::Field::kPointer, offsetof(T, name) }

/// A struct whose fields may each be wrong. `good` is as it is to be passed.
template <class T>
Argument in_struct(Context& c, const T& good, std::initializer_list<Field> fields, bool may_be_null = false) {
  Argument a;
  T* const passed = c.keep(good);
  a.good = of(passed);
  for (const Field& f : fields)
    for (int i = 0; c.to_the_edge && f.type == Field::kNumber && i < f.count; ++i) {
      char* const at = reinterpret_cast<char*>(passed) + f.offset + 8 * static_cast<std::size_t>(i);
      double x;
      std::memcpy(&x, at, 8);
      x = perhaps_edged(c, x, f.bounds);
      std::memcpy(at, &x, 8);
    }
  if (!c.wants_wrong) return a;
  if (!may_be_null) a.wrong.push_back({"null", of(nullptr), kNull});
  const auto put = [&](std::string what, std::size_t offset, const void* value, std::size_t size, Codes codes) {
    T* bad = c.keep(good);
    std::memcpy(reinterpret_cast<char*>(bad) + offset, value, size);
    a.wrong.push_back({std::move(what), of(bad), codes});
  };
  for (const uint32_t size : {0u, 4u, uint32_t(sizeof(T)) - 1, uint32_t(sizeof(T)) + 1, 4104u, 0xFFFFFFF8u})
    put("struct_size " + std::to_string(size), 0, &size, sizeof size, kSize);
  {  // a newer header's struct that asks for what this library does not know
    auto* longer = static_cast<char*>(c.take(sizeof(T) + 8));
    std::memcpy(longer, &good, sizeof good);
    const uint32_t size = sizeof(T) + 8;
    std::memcpy(longer, &size, sizeof size);
    longer[sizeof(T) + 7] = 1;
    a.wrong.push_back({"a field from the future", of(longer), kUnsupported});
  }
  for (const Field& f : fields) {
    const std::string at = "at byte " + std::to_string(f.offset) + ": ";
    const auto* from = reinterpret_cast<const char*>(&good) + f.offset;
    switch (f.type) {
      case Field::kNumber:
        for (int i = 0; i < f.count; ++i)
          for (const auto& [x, codes] : wrong_numbers(f.bounds))
            put(at + "[" + std::to_string(i) + "] " + shown(x), f.offset + 8 * static_cast<std::size_t>(i), &x, 8,
                codes);
        break;
      case Field::kUnit: {
        double q[4];
        std::memcpy(q, from, sizeof(double) * static_cast<std::size_t>(f.count));
        for (const auto& [bad, codes] : wrong_turns(q, f.count))
          put(at + "not of unit length", f.offset, bad.data(), sizeof(double) * static_cast<std::size_t>(f.count),
              codes);
        break;
      }
      case Field::kChoice:
        for (const uint32_t x : {f.known, 0xFFFFFFFFu})
          put(at + "unknown value " + std::to_string(x), f.offset, &x, sizeof x, kEnum | kRange | kUnsupported);
        break;
      case Field::kBits:
        for (uint32_t bit = 0; bit < 32; ++bit)
          if (const uint32_t x = 1u << bit; !(f.known & x))
            put(at + "unknown bit " + std::to_string(bit), f.offset, &x, sizeof x, kUnsupported | kEnum | kRange);
        break;
      case Field::kWhole:
        for (const double x : {f.bounds.low - 1, f.bounds.high + 1, double(INT32_MIN), double(INT32_MAX)}) {
          const auto bad = static_cast<int32_t>(x);
          put(at + shown(x), f.offset, &bad, sizeof bad, kRange);
        }
        break;
      case Field::kReserved: {
        const uint32_t one = 1;
        put(at + "reserved", f.offset, &one, sizeof one, kUnsupported);
        break;
      }
      case Field::kHandle:
        for (const Wrong& w : wrong_handles(c, f.kind, f.may_be_null))
          put(at + w.what, f.offset, &w.value.u, 8, w.codes);
        break;
      case Field::kPointer: {
        const void* nothing = nullptr;
        put(at + "null", f.offset, &nothing, sizeof nothing, kNull | kRange);
        break;
      }
    }
  }
  return a;
}

// ---- calls ----
struct Call {
  const char* name = nullptr;
  std::vector<Argument> arguments;
  std::function<int32_t(const Value*)> invoke;
  Codes good_codes = kFine;  // what a call without a wrong argument may give
  int made = -1;             // kind of object that comes into being, its handle in argument made_at
  std::size_t made_at = 0;
  int owner_at = -1;                       // argument that is the handle of the body it hangs on
  int gone = -1;                           // kind of object that goes, its handle in argument 1
  bool alone = false;                      // its good call ends the stage: only wrong ones are made
  std::function<void(const Value*)> undo;  // after an OK: what has to be given back

  Call& may(Codes codes) { return good_codes |= codes, *this; }
  Call& makes(int kind, std::size_t at, int owner = -1) { return made = kind, made_at = at, owner_at = owner, *this; }
  Call& ends(int kind) { return gone = kind, *this; }
  Call& only_wrong() { return alone = true, *this; }
  Call& after(std::function<void(const Value*)> f) { return undo = std::move(f), *this; }
};

template <class A>
A as(const Value& v) {
  if constexpr (std::is_function_v<std::remove_pointer_t<A>>)
    return reinterpret_cast<A>(const_cast<void*>(v.p));
  else if constexpr (std::is_pointer_v<A>)
    return static_cast<A>(const_cast<void*>(v.p));
  else if constexpr (std::is_floating_point_v<A>)
    return static_cast<A>(v.d);
  else
    return static_cast<A>(v.u);
}
template <class R, class... A, std::size_t... I>
std::function<int32_t(const Value*)> through(R (*f)(A...), std::index_sequence<I...>) {
  return [f](const Value* v) -> int32_t {
    (void)v;
    if constexpr (std::is_same_v<R, int32_t>)
      return f(as<A>(v[I])...);
    else
      return f(as<A>(v[I])...) ? CAROM_OK : CAROM_E_INTERNAL;  // a static string, always
  };
}
template <class R, class... A>
Call call(const char* name, R (*f)(A...), std::array<Argument, sizeof...(A)> arguments) {
  Call c;
  c.name = name;
  c.arguments.assign(std::make_move_iterator(arguments.begin()), std::make_move_iterator(arguments.end()));
  c.invoke = through(f, std::index_sequence_for<A...>());
  return c;
}

}  // namespace hostile
