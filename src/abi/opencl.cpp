// The functions of OpenCL 1.2 that are used here, found at run time; numbers and types as its specification has them.
#include "abi/opencl.h"

#include <cstdio>
#include <cstring>
#include <mutex>
#include <string>

#include "abi/loader.h"

#if defined(_WIN32) && !defined(_WIN64)
#define CAROM_CL_CALL __stdcall
#else
#define CAROM_CL_CALL
#endif

namespace carom::abi {
namespace {

using ClInt = std::int32_t;
using ClUint = std::uint32_t;
using ClBits = std::uint64_t;

constexpr ClBits kAnyType = 0xFFFFFFFF;
constexpr ClUint kDeviceName = 0x102B, kDeviceVersion = 0x102F, kDoubleConfig = 0x1032, kAvailable = 0x1027,
                 kHasCompiler = 0x1028, kLittleEndian = 0x1026, kBuildLog = 0x1183;
constexpr ClBits kDenormals = 1, kRoundsToNearest = 4, kReadWrite = 1;
constexpr ClInt kOutOfMemory[] = {-4, -5, -6};

/// Loaded once, for good.
struct OpenCl {
  ClInt(CAROM_CL_CALL* get_platforms)(ClUint, void**, ClUint*);
  ClInt(CAROM_CL_CALL* get_devices)(void*, ClBits, ClUint, void**, ClUint*);
  ClInt(CAROM_CL_CALL* get_device_info)(void*, ClUint, std::size_t, void*, std::size_t*);
  void*(CAROM_CL_CALL* create_context)(const std::intptr_t*, ClUint, void* const*, void*, void*, ClInt*);
  ClInt(CAROM_CL_CALL* release_context)(void*);
  void*(CAROM_CL_CALL* create_queue)(void*, void*, ClBits, ClInt*);
  ClInt(CAROM_CL_CALL* release_queue)(void*);
  void*(CAROM_CL_CALL* create_buffer)(void*, ClBits, std::size_t, void*, ClInt*);
  ClInt(CAROM_CL_CALL* release_buffer)(void*);
  ClInt(CAROM_CL_CALL* write_buffer)(void*, void*, ClUint, std::size_t, std::size_t, const void*, ClUint, void*, void*);
  ClInt(CAROM_CL_CALL* read_buffer)(void*, void*, ClUint, std::size_t, std::size_t, void*, ClUint, void*, void*);
  void*(CAROM_CL_CALL* create_program)(void*, ClUint, const char**, const std::size_t*, ClInt*);
  ClInt(CAROM_CL_CALL* release_program)(void*);
  ClInt(CAROM_CL_CALL* build_program)(void*, ClUint, void* const*, const char*, void*, void*);
  ClInt(CAROM_CL_CALL* get_build_info)(void*, void*, ClUint, std::size_t, void*, std::size_t*);
  void*(CAROM_CL_CALL* create_kernel)(void*, const char*, ClInt*);
  ClInt(CAROM_CL_CALL* release_kernel)(void*);
  ClInt(CAROM_CL_CALL* set_kernel_arg)(void*, ClUint, std::size_t, const void*);
  ClInt(CAROM_CL_CALL* enqueue)(void*, void*, ClUint, const std::size_t*, const std::size_t*, const std::size_t*,
                                ClUint, void*, void*);
  ClInt(CAROM_CL_CALL* finish)(void*);
  bool loaded = false;
  char why[160] = {0};
} cl;

template <class F>
bool find(const char* symbol, F& function) {
  if (cl.why[0]) return false;
  const system::Symbol found =
      system::kOpenCl ? system::load(system::kOpenCl, symbol, cl.why, sizeof cl.why) : system::Symbol{};
  if (!found.at && !cl.why[0]) std::snprintf(cl.why, sizeof cl.why, "this library loads no shared objects");
  function = reinterpret_cast<F>(const_cast<void*>(found.at));
  return found.at;
}

/// Asked again where it was not there: it may have been installed since.
bool load_all(Call& call) {
  static std::mutex mutex;
  const std::lock_guard lock(mutex);
  if (cl.loaded) return true;
  cl.why[0] = 0;
  cl.loaded = find("clGetPlatformIDs", cl.get_platforms) && find("clGetDeviceIDs", cl.get_devices) &&
              find("clGetDeviceInfo", cl.get_device_info) && find("clCreateContext", cl.create_context) &&
              find("clReleaseContext", cl.release_context) && find("clCreateCommandQueue", cl.create_queue) &&
              find("clReleaseCommandQueue", cl.release_queue) && find("clCreateBuffer", cl.create_buffer) &&
              find("clReleaseMemObject", cl.release_buffer) && find("clEnqueueWriteBuffer", cl.write_buffer) &&
              find("clEnqueueReadBuffer", cl.read_buffer) && find("clCreateProgramWithSource", cl.create_program) &&
              find("clReleaseProgram", cl.release_program) && find("clBuildProgram", cl.build_program) &&
              find("clGetProgramBuildInfo", cl.get_build_info) && find("clCreateKernel", cl.create_kernel) &&
              find("clReleaseKernel", cl.release_kernel) && find("clSetKernelArg", cl.set_kernel_arg) &&
              find("clEnqueueNDRangeKernel", cl.enqueue) && find("clFinish", cl.finish);
  return cl.loaded || call.fail(CAROM_E_NOT_FOUND, 0, "there is no OpenCL to load: %s", cl.why) ||
         call.advise(
             "install an OpenCL loader and a driver (Debian: ocl-icd-libopencl1, pocl-opencl-icd), or ask on "
             "the host: carom_pairs_distance()");
}

bool refused(Call& call, const char* what, ClInt code) {
  for (const ClInt memory : kOutOfMemory)
    if (code == memory) return call.fail(CAROM_E_OUT_OF_MEMORY, 0, "the device has no memory for %s", what);
  call.fail(CAROM_E_UNSUPPORTED, 0, "the device refused %s: OpenCL says %d", what, code);
  return call.advise("ask on the host, carom_pairs_distance(), or update the device's driver");
}

template <class T>
T info(void* device, ClUint which) {
  T value{};
  cl.get_device_info(device, which, sizeof value, &value, nullptr);
  return value;
}

/// Call visit(device) for all devices of all platforms until it says that it has seen enough.
template <class Visit>
void each_device(const Visit& visit) {
  constexpr ClUint kMost = 64;
  void *platforms[kMost], *devices[kMost];
  ClUint platform_count = 0;
  if (cl.get_platforms(kMost, platforms, &platform_count) != 0) return;
  for (ClUint p = 0; p < platform_count && p < kMost; ++p) {
    ClUint count = 0;
    if (cl.get_devices(platforms[p], kAnyType, kMost, devices, &count) != 0) continue;
    for (ClUint d = 0; d < count && d < kMost; ++d)
      if (visit(devices[d])) return;
  }
}

}  // namespace

bool ClDevice::open(Call& call, int argument, std::uint32_t index) {
  if (!load_all(call)) return false;
  std::uint32_t count = 0;
  each_device([&](void* device) {
    if (count++ == index) device_ = device;
    return device_ != nullptr;
  });
  if (!device_) {
    call.fail(CAROM_E_NOT_FOUND, argument, "index is %u, OpenCL has %u devices here", index, count);
    return call.advise(
        "install the driver of a device (Debian: pocl-opencl-icd for the processor itself), or ask on the host");
  }
  cl.get_device_info(device_, kDeviceName, sizeof name_ - 1, name_, nullptr);
  cl.get_device_info(device_, kDeviceVersion, sizeof version_ - 1, version_, nullptr);
  const ClBits doubles = info<ClBits>(device_, kDoubleConfig);
  if (!(doubles & kRoundsToNearest) || !(doubles & kDenormals)) {
    call.fail(CAROM_E_UNSUPPORTED, argument, "%.80s has no double precision (fp64)", name_);
    return call.advise("name a device that has it, or ask on the host: carom_pairs_distance()");
  }
  if (!info<ClUint>(device_, kAvailable) || !info<ClUint>(device_, kHasCompiler) ||
      !info<ClUint>(device_, kLittleEndian)) {
    call.fail(CAROM_E_UNSUPPORTED, argument, "%.80s is not available, has no compiler, or another order of bytes",
              name_);
    return call.advise("name another device, or ask on the host: carom_pairs_distance()");
  }
  ClInt code = 0;
  context_ = cl.create_context(nullptr, 1, &device_, nullptr, nullptr, &code);
  if (!context_) return refused(call, "a context", code);
  queue_ = cl.create_queue(context_, device_, 0, &code);
  return queue_ || refused(call, "a queue", code);
}

ClDevice::~ClDevice() {
  if (queue_) cl.release_queue(queue_);
  if (context_) cl.release_context(context_);
}

ClDevice::Buffer::~Buffer() {
  if (handle) cl.release_buffer(handle);
}

ClDevice::Program::~Program() {
  if (handle) cl.release_program(handle);
}

bool ClDevice::reserve(Call& call, Buffer& buffer, std::size_t bytes) {
  if (buffer.handle && buffer.size >= bytes) return true;
  if (buffer.handle) cl.release_buffer(buffer.handle);
  buffer.size = bytes + bytes / 4 + 64;
  ClInt code = 0;
  buffer.handle = cl.create_buffer(context_, kReadWrite, buffer.size, nullptr, &code);
  return buffer.handle || refused(call, "its pairs", code);
}

bool ClDevice::write(Call& call, Buffer& buffer, const void* data, std::size_t bytes) {
  if (!reserve(call, buffer, bytes)) return false;
  if (bytes == 0) return true;
  const ClInt code = cl.write_buffer(queue_, buffer.handle, 1, 0, bytes, data, 0, nullptr, nullptr);
  return code == 0 || refused(call, "bytes", code);
}

bool ClDevice::read(Call& call, const Buffer& buffer, void* data, std::size_t bytes) {
  const ClInt code = cl.read_buffer(queue_, buffer.handle, 1, 0, bytes, data, 0, nullptr, nullptr);
  return code == 0 || refused(call, "to give bytes back", code);
}

bool ClDevice::build(Call& call, const char* text, Program& program, char* log, std::size_t size) {
  ClInt code = 0;
  Program made;
  made.handle = cl.create_program(context_, 1, &text, nullptr, &code);
  if (!made.handle) return refused(call, "a program", code);
  log[0] = 0;
  code = cl.build_program(made.handle, 1, &device_, "-cl-std=CL1.2", nullptr, nullptr);
  if (code == 0) return program.swap(made), true;
  std::size_t length = 0;
  cl.get_build_info(made.handle, device_, kBuildLog, 0, nullptr, &length);
  std::string all(length + 1, 0);
  if (length) cl.get_build_info(made.handle, device_, kBuildLog, length, all.data(), nullptr);
  const char* const first = std::strstr(all.c_str(), "error");
  std::snprintf(log, size, "%s", first ? first : all.c_str());
  log[std::strcspn(log, "\r\n")] = 0;
  return false;
}

void* ClDevice::make_kernel(Call& call, const Program& program, const char* kernel) {
  ClInt code = 0;
  void* const made = cl.create_kernel(program.handle, kernel, &code);
  if (!made) refused(call, kernel, code);
  return made;
}

void ClDevice::free_kernel(void* kernel) { cl.release_kernel(kernel); }

bool ClDevice::set_bytes(Call& call, void* kernel, std::uint32_t i, std::size_t size, const void* value) {
  const ClInt code = cl.set_kernel_arg(kernel, i, size, value);
  return code == 0 || refused(call, "an argument", code);
}

bool ClDevice::launch(Call& call, void* kernel, std::size_t count) {
  ClInt code = cl.enqueue(queue_, kernel, 1, nullptr, &count, nullptr, 0, nullptr, nullptr);
  if (code == 0) code = cl.finish(queue_);
  return code == 0 || refused(call, "a kernel", code);
}

}  // namespace carom::abi
