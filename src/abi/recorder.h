// A world's calls as bytes for a host: carom/record.h says what is written, record_calls.h how each call is. Whole records
// go to the host at once; when it says that it failed, or memory is short, recording is over and the world goes on. So it
// is when the host's function ends the thread.
#pragma once

#include <carom/body_bulk.h>
#include <carom/record.h>

#include <iterator>
#include <string_view>

#include "abi/guard.h"
#include "core/memory.h"

struct carom_engine;

namespace carom::dynamics {
class World;
}

namespace carom::abi {

class Recorder;

/// Numbers in a record of CAROM_FIELD_*, of bodies and of particles.
constexpr std::uint32_t field_width(std::uint32_t field) {
  constexpr std::uint32_t kWidth[] = {3, 4, 7, 3, 3, 6, 6, 3, 1};
  static_assert(std::size(kWidth) == CAROM_FIELD_COUNT);
  return kWidth[field];
}

/// Writes the arguments of one call. What is given was checked by the call itself, which went well.
class Serializer {
 public:
  explicit Serializer(Recorder& recorder) : recorder_(recorder) {}

  void call(std::string_view name);
  template <class T>
  void number(T value) {
    put(&value, sizeof value);
  }
  /// `n` of them, or nothing at all.
  template <class T>
  void list(const T* values, std::uint64_t n) {
    number(std::uint64_t(values ? 1 : 0));
    if (!values) return;
    number(n);
    put(values, n * sizeof(T));
  }
  void bytes(const void* from, std::uint64_t n) { list(static_cast<const std::byte*>(from), n); }
  /// Records of `scalars` numbers, as carom_world_write() takes them; written without gaps.
  void records(const void* from, std::uint64_t n, std::uint32_t scalars, std::uint32_t scalar, std::uint64_t stride);
  /// As large as the host has it.
  template <class T>
  void structure(const T* given) {
    list(reinterpret_cast<const std::byte*>(given), given ? given->struct_size : 0);
  }
  void shape(std::uint64_t handle);  // which is known to the reader from here on

 private:
  void put(const void* from, std::uint64_t n);
  Recorder& recorder_;
};

class Recorder {
 public:
  Recorder(carom_engine& engine, std::uint32_t flags, carom_write_fn write, void* user);

  void begin(const World& world);
  /// @param write_call  f(Serializer&)
  template <class Write>
  [[gnu::cold, gnu::noinline]] void call(const Write& write_call) {  // of few worlds: for size
    guard([&] {
      content_.clear();
      Serializer to(*this);
      write_call(to);
      write(kCall, content_);
    });
  }
  void stepped(const World& world);
  void broke_off(const World& world);  // a step was not finished: what it leaves is told as it is
  void end();

  std::int32_t code() const { return code_; }  // CAROM_OK as long as all was written
  std::uint64_t written() const { return written_; }

 private:
  friend class Serializer;
  enum Kind : std::uint32_t { kBegin = 1, kShape, kName, kCall, kHash, kState, kEnd };

  template <class F>
  void guard(const F& f) {
    if (code_ != CAROM_OK) return;
    try {
      f();
    } catch (const core::ThreadExit&) {
      code_ = CAROM_E_WRITE_FAILED;
      throw;
    } catch (...) {
      code_ = CAROM_E_OUT_OF_MEMORY;  // nothing else is thrown in here
    }
  }
  void write(Kind kind, const Array<std::byte>& content);
  void send(const void* bytes, std::uint64_t size);
  std::uint32_t number_of(std::string_view name);  // of a function, told when it is first used
  void tell(std::uint64_t shape);
  Array<std::byte> state_of(const World& world) const;

  carom_engine& engine_;
  std::uint32_t flags_;
  carom_write_fn write_;
  void* user_;
  std::int32_t code_ = CAROM_OK;
  std::uint64_t written_ = 0;
  Array<std::string_view> names_;      // literals
  Array<std::uint64_t> shapes_;        // told so far, ascending
  Array<std::byte> content_, record_;  // of the call in hand; as it is sent
};

}  // namespace carom::abi
