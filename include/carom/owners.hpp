/** @file owners.hpp
 *  What carom.hpp keeps alive: an engine with the support functions that it calls, a world with its engine.
 */
#ifndef CAROM_OWNERS_HPP
#define CAROM_OWNERS_HPP

#include <carom/carom.h>

#include <algorithm>
#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace carom {

using Vec3 = std::array<double, 3>;
using Quat = std::array<double, 4>;  ///< x, y, z, w

/// The farthest point of a shape along a direction: carom_support_fn says what it must keep to. It is called from several
/// threads at once. An exception in it is a fault of the shape.
using Support = std::function<Vec3(std::span<const double> params, const Vec3 &direction)>;

namespace detail {

struct Plugin {
  std::string id;
  std::vector<carom_param> params;
  Support support;
  static std::int32_t call(void *user, const double *params, std::uint64_t n, const double *d, double *out) noexcept {
    const auto ask = [&] {
      const Vec3 point = static_cast<Plugin *>(user)->support({params, std::size_t(n)}, {d[0], d[1], d[2]});
      std::copy(point.begin(), point.end(), out);
      return 0;
    };
#if defined(__cpp_exceptions)
    try {
      return ask();
    } catch (...) {
      return 1;
    }
#else
    return ask();
#endif
  }
};

/// Lives as long as an engine or a world of it: an engine may be forgotten before its worlds.
struct EngineOwner {
  carom_engine *pointer = nullptr;
  std::mutex lock;  // of plugins
  std::deque<Plugin> plugins;
  ~EngineOwner() {
    if (pointer) carom_engine_destroy(pointer, nullptr);
  }
};

struct WorldCloser {
  std::shared_ptr<EngineOwner> engine;
  void operator()(carom_world *world) const noexcept { carom_world_destroy(world, nullptr); }
};

}  // namespace detail

}  // namespace carom
#endif
