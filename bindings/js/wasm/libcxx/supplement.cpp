// What libc++ 16's headers declare, we use, and emscripten 3.1.6's compiled libc++ has not: see flags.cmake.
#include <cstdlib>
#include <memory_resource>
#include <new>

namespace std {
inline namespace __2 {
namespace pmr {

memory_resource::~memory_resource() = default;

namespace {
class NewDelete final : public memory_resource {
  void* do_allocate(size_t bytes, size_t align) override { return ::operator new(bytes, align_val_t(align)); }
  void do_deallocate(void* p, size_t, size_t align) override { ::operator delete(p, align_val_t(align)); }
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};
class Null final : public memory_resource {
  void* do_allocate(size_t, size_t) override { throw bad_alloc(); }
  void do_deallocate(void*, size_t, size_t) override {}
  bool do_is_equal(const memory_resource& other) const noexcept override { return this == &other; }
};
}  // namespace

memory_resource* get_default_resource() noexcept {
  static NewDelete resource;
  return &resource;
}
memory_resource* null_memory_resource() noexcept {
  static Null resource;
  return &resource;
}

}  // namespace pmr

[[noreturn]] void __libcpp_verbose_abort(const char*, ...) { std::abort(); }

}  // namespace __2
}  // namespace std
