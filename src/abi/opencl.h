// OpenCL, which is loaded when the first device is asked for: a device, programs for it, memory on it.
#pragma once

#include <cstddef>
#include <cstdint>

#include "abi/guard.h"

namespace carom::abi {

/// A device that a call may use. Everything on it goes with it.
class ClDevice {
 public:
  ClDevice() = default;
  ~ClDevice();
  ClDevice(const ClDevice&) = delete;
  ClDevice& operator=(const ClDevice&) = delete;

  /// @param index  among all devices of all platforms that compute in double precision, in the order of the system
  /// @errors NOT_FOUND, UNSUPPORTED
  bool open(Call& call, int argument, std::uint32_t index);
  const char* name() const { return name_; }
  const char* version() const { return version_; }

  /// Bytes on the device; none: nothing is kept.
  class Buffer {
   public:
    Buffer() = default;
    ~Buffer();
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    void* handle = nullptr;
    std::size_t size = 0;
  };
  /// At least so many bytes; what was in it is lost.
  bool reserve(Call& call, Buffer& buffer, std::size_t bytes);
  bool write(Call& call, Buffer& buffer, const void* data, std::size_t bytes);  // reserves
  bool read(Call& call, const Buffer& buffer, void* data, std::size_t bytes);

  class Program {
   public:
    Program() = default;
    ~Program();
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;
    void swap(Program& other) {
      void* const mine = handle;
      handle = other.handle, other.handle = mine;
    }
    void* handle = nullptr;
  };
  /// @param log  [size] what the device's compiler says of a text that it refuses
  /// @return     false: it refuses, or (noted in the call) there is no memory
  bool build(Call& call, const char* text, Program& program, char* log, std::size_t size);

  /// Run a kernel over [0, count), and wait. Arguments: numbers and buffers.
  template <class... Args>
  bool run(Call& call, const Program& program, const char* kernel, std::size_t count, const Args&... args) {
    void* const made = make_kernel(call, program, kernel);
    if (!made) return false;
    std::uint32_t i = 0;
    const bool ready = (set(call, made, i++, args) && ...);
    const bool done = ready && launch(call, made, count);
    free_kernel(made);
    return done;
  }

 private:
  bool set(Call& call, void* kernel, std::uint32_t i, const Buffer& buffer) {
    return set_bytes(call, kernel, i, sizeof buffer.handle, &buffer.handle);
  }
  template <class T>
  bool set(Call& call, void* kernel, std::uint32_t i, const T& number) {
    return set_bytes(call, kernel, i, sizeof number, &number);
  }
  void* make_kernel(Call& call, const Program& program, const char* kernel);
  void free_kernel(void* kernel);
  bool set_bytes(Call& call, void* kernel, std::uint32_t i, std::size_t size, const void* value);
  bool launch(Call& call, void* kernel, std::size_t count);

  void *device_ = nullptr, *context_ = nullptr, *queue_ = nullptr;
  char name_[128] = {0}, version_[128] = {0};
};

}  // namespace carom::abi
