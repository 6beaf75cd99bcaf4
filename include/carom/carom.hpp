/** @file carom.hpp
 *  The interface for C++20, header only: engines and worlds that are given back by themselves, spans for arrays of bodies,
 *  and failures as exceptions (carom::World) or as values (carom::results::World). call() makes any other call of carom.h.
 *  bindings/cpp/README.md has a program.
 */
#ifndef CAROM_HPP
#define CAROM_HPP

#include <carom/outcome.hpp>
#include <carom/owners.hpp>

#include <algorithm>
#include <initializer_list>
#include <memory>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace carom {

/// A record of CAROM_FIELD_POSE.
struct Pose {
  using value_type = double;
  Vec3 position{};
  Quat orientation{0, 0, 0, 1};
};
static_assert(sizeof(Pose) == 7 * sizeof(double));

/// A body of a world, by its handle; forgetting it destroys nothing.
template <class P>
class BasicBody {
 public:
  template <class T>
  using Out = typename P::template Out<T>;
  BasicBody() = default;
  BasicBody(carom_world *world, carom_body handle) : world_(world), handle_(handle) {}
  carom_body handle() const noexcept { return handle_; }

  /// Any call of carom.h on a body: body.call(carom_body_set_drag, 0.1, 0.02).
  template <class F, class... A>
  Out<void> call(F function, A... arguments) const {
    return detail::run<P, void>([&](carom_error *e) { return function(world_, handle_, arguments..., e); });
  }
  Out<Vec3> position() const {
    return detail::run<P, Vec3>(
        [this](Vec3 &v, carom_error *e) { return carom_body_get_pose(world_, handle_, v.data(), nullptr, e); });
  }
  Out<Pose> pose() const {
    return detail::run<P, Pose>([this](Pose &p, carom_error *e) {
      return carom_body_get_pose(world_, handle_, p.position.data(), p.orientation.data(), e);
    });
  }
  Out<Vec3> linear_velocity() const {
    return detail::run<P, Vec3>(
        [this](Vec3 &v, carom_error *e) { return carom_body_get_velocity(world_, handle_, v.data(), nullptr, e); });
  }
  Out<void> set_pose(const Pose &p) const { return call(carom_body_set_pose, p.position.data(), p.orientation.data()); }
  Out<void> set_velocity(const Vec3 &v, const Vec3 &spin) const {
    return call(carom_body_set_velocity, v.data(), spin.data());
  }
  Out<void> add_force(const Vec3 &force, const Vec3 &torque = {}) const {
    return call(carom_body_add_force, force.data(), torque.data());
  }
  Out<void> destroy() const { return call(carom_body_destroy); }

 private:
  carom_world *world_ = nullptr;
  carom_body handle_ = CAROM_NULL_HANDLE;
};

/// What World::body() takes beside a shape; carom_body_desc has more.
struct BodyOptions {
  std::uint32_t type = CAROM_BODY_DYNAMIC;
  Vec3 position{};
  Quat orientation{0, 0, 0, 1};
  Vec3 linear_velocity{}, angular_velocity{};
  double density = 1000;
  carom_material material = CAROM_NULL_HANDLE;
};

template <class P>
class BasicWorld {
 public:
  template <class T>
  using Out = typename P::template Out<T>;
  using Body = BasicBody<P>;
  BasicWorld() = default;
  carom_world *get() const noexcept { return pointer_.get(); }

  /// Any call of carom.h on a world: world.call(carom_world_set_dial, CAROM_DIAL_SUBSTEPS, 5).
  template <class F, class... A>
  Out<void> call(F function, A... arguments) const {
    return detail::run<P, void>([&](carom_error *e) { return function(get(), arguments..., e); });
  }
  /// One whose last argument is a value that comes back: world.make<carom_joint>(carom_joint_create, &hinge).
  template <class T, class F, class... A>
  Out<T> make(F function, A... arguments) const {
    return detail::run<P, T>([&](T &value, carom_error *e) { return function(get(), arguments..., &value, e); });
  }
  Out<void> step(double dt) { return call(carom_world_step, dt); }
  Out<std::uint64_t> hash() const { return make<std::uint64_t>(carom_world_hash); }

  Out<Body> body(carom_shape shape, const BodyOptions &options = {}) {
    auto desc = carom::make<carom_body_desc>();
    auto part = carom::make<carom_collider_desc>();
    desc.type = options.type, part.shape = shape, part.density = options.density, part.material = options.material;
    std::ranges::copy(options.position, desc.position), std::ranges::copy(options.orientation, desc.orientation);
    std::ranges::copy(options.linear_velocity, desc.linear_velocity),
        std::ranges::copy(options.angular_velocity, desc.angular_velocity);
    return body(desc, {&part, 1});
  }
  Out<Body> body(const carom_body_desc &desc, std::span<const carom_collider_desc> parts) {
    return detail::run<P, Body>([&](Body &made, carom_error *e) {
      carom_body handle = CAROM_NULL_HANDLE;
      carom_collider collider;
      auto result = carom_body_create(get(), &desc, &handle, e);
      for (std::size_t i = 0; i < parts.size() && result == CAROM_OK; i++)
        if ((result = carom_collider_create(get(), handle, &parts[i], &collider, e)) != CAROM_OK)
          carom_body_destroy(get(), handle, nullptr);
      made = Body(get(), handle);
      return result;
    });
  }
  /// A static half-space below `height`.
  Out<Body> ground(double height = 0) {
    return detail::run<P, Body>([&](Body &made, carom_error *e) {
      const double plane[4] = {0, 1, 0, height}, origin[3] = {0, 0, 0};
      carom_body handle = CAROM_NULL_HANDLE;
      const auto result = carom_body_create_named(get(), CAROM_BODY_STATIC, "half_space", plane, 4, origin, &handle, e);
      made = Body(get(), handle);
      return result;
    });
  }

  Out<std::vector<carom_body>> bodies() const {
    return list<carom_body>([this](auto... to) { return carom_world_get_bodies(get(), to...); });
  }
  Out<std::vector<carom_contact>> contacts() const {
    return list<carom_contact>(
        [this](auto *dst, auto... to) { return carom_world_get_contacts(get(), dst, sizeof *dst, to...); });
  }
  /// One field of the bodies `of`, or of all bodies in the order of bodies(): CAROM_FIELD_POSITION into a vector or span
  /// of Vec3, CAROM_FIELD_POSE of Pose. A record is a number, an array of them, or a struct with its value_type as Pose.
  template <std::ranges::contiguous_range Records>
  Out<void> read(std::uint32_t field, Records &&dst, std::span<const carom_body> of = {}) const {
    return transfer(carom_world_read, field, std::span(dst), of);
  }
  template <std::ranges::contiguous_range Records>
  Out<void> write(std::uint32_t field, const Records &src, std::span<const carom_body> of = {}) {
    return transfer(carom_world_write, field, std::span(src), of);
  }
  Out<void> positions(std::span<Vec3> dst) const { return read(CAROM_FIELD_POSITION, dst); }
  Out<void> poses(std::span<Pose> dst) const { return read(CAROM_FIELD_POSE, dst); }

  Out<std::vector<std::byte>> save(std::uint32_t flags = CAROM_SNAPSHOT_STATE) const {
    return list<std::byte>([=, this](auto... to) {
      const auto result = carom_world_save(get(), flags, to...);
      return result == CAROM_E_BUFFER_TOO_SMALL ? CAROM_OK : result;  // list() asks again
    });
  }
  Out<void> restore(std::span<const std::byte> bytes) {
    return call(carom_world_restore, bytes.data(), std::uint64_t(bytes.size()));
  }
  Out<BasicWorld> fork() const {
    return adopt(pointer_.get_deleter().engine, [this](auto... to) { return carom_world_fork(get(), to...); });
  }

 private:
  template <class>
  friend class BasicEngine;
  template <class F>
  static Out<BasicWorld> adopt(const std::shared_ptr<detail::EngineOwner> &engine, F make) {
    return detail::run<P, BasicWorld>([&](BasicWorld &made, carom_error *e) {
      carom_world *pointer = nullptr;
      const auto result = make(&pointer, e);
      made.pointer_ = {pointer, {engine}};
      return result;
    });
  }
  template <class Record>
  static constexpr std::uint32_t scalar() {
    if constexpr (std::is_floating_point_v<Record>)
      return sizeof(Record) == 4 ? CAROM_SCALAR_F32 : CAROM_SCALAR_F64;
    else
      return scalar<typename Record::value_type>();
  }
  template <class F, class Record, std::size_t N>
  Out<void> transfer(F function, std::uint32_t field, std::span<Record, N> records,
                     std::span<const carom_body> of) const {
    return detail::run<P, void>([&](carom_error *e) {
      if (of.data() && of.size() != records.size())
        return detail::refuse(e, CAROM_E_OUT_OF_RANGE,
                              std::to_string(records.size()) + " records for " + std::to_string(of.size()) + " bodies",
                              "pass as many records as bodies");
      return function(get(), field, scalar<std::remove_const_t<Record>>(), of.data(), records.size(), records.data(),
                      sizeof(Record), e);
    });
  }
  /// All elements of a list that says how many there are: asked for none first, then for all.
  template <class T, class Ask>
  static Out<std::vector<T>> list(Ask ask) {
    return detail::run<P, std::vector<T>>([&](std::vector<T> &all, carom_error *e) {
      std::uint64_t count = 0;
      auto result = ask(static_cast<T *>(nullptr), std::uint64_t(0), &count, e);
      while (result == CAROM_OK && count > all.size()) {
        all.resize(count);
        result = ask(all.data(), std::uint64_t(all.size()), &count, e);
      }
      all.resize(std::min<std::size_t>(all.size(), count));
      return result;
    });
  }
  std::unique_ptr<carom_world, detail::WorldCloser> pointer_;
};

template <class P>
class BasicEngine {
 public:
  template <class T>
  using Out = typename P::template Out<T>;
  using World = BasicWorld<P>;

  /// @param desc  an allocator, a log; null: defaults
  static Out<BasicEngine> create(const carom_engine_desc *desc = nullptr) {
    return detail::run<P, BasicEngine>([&](BasicEngine &made, carom_error *e) {
      const auto result = detail::check_library(e);
      return result == CAROM_OK ? carom_engine_create(desc, &made.owner_->pointer, e) : result;
    });
  }
  BasicEngine() = default;  ///< none, until create() is assigned to it
  carom_engine *get() const noexcept { return owner_->pointer; }

  /// Any call of carom.h on an engine: engine.call(carom_engine_set_jobs, &jobs); make() as of a world.
  template <class F, class... A>
  Out<void> call(F function, A... arguments) const {
    return detail::run<P, void>([&](carom_error *e) { return function(get(), arguments..., e); });
  }
  template <class T, class F, class... A>
  Out<T> make(F function, A... arguments) const {
    return detail::run<P, T>([&](T &value, carom_error *e) { return function(get(), arguments..., &value, e); });
  }
  Out<World> world(const carom_world_desc *desc = nullptr) {
    return World::adopt(owner_, [&](auto... to) { return carom_world_create(get(), desc, to...); });
  }
  /// By the name of its plugin, as carom_shape_create_named() takes it.
  Out<carom_shape> shape(const char *name, std::initializer_list<double> params) {
    return make<carom_shape>(carom_shape_create_named, name, first_of(params), params.size());
  }
  Out<carom_shape> shape(carom_plugin plugin, std::initializer_list<double> params) {
    return make<carom_shape>(carom_shape_create, plugin, first_of(params), params.size());
  }
  /// A kind of shape whose support function is C++, as long as the engine lives; so long must the texts of `params`.
  Out<carom_plugin> plugin(std::string id, std::initializer_list<carom_param> params, Support support) {
    const std::lock_guard hold(owner_->lock);
    auto &kept = owner_->plugins.emplace_back(detail::Plugin{std::move(id), params, std::move(support)});
    auto description = carom::make<carom_shape_plugin>();
    description.abi_major = CAROM_PLUGIN_ABI_MAJOR, description.abi_minor = CAROM_PLUGIN_ABI_MINOR;
    description.id = kept.id.c_str(), description.version = 1;
    description.params = kept.params.data(), description.param_count = std::uint32_t(kept.params.size());
    description.support = detail::Plugin::call, description.user = &kept;
    return make<carom_plugin>(carom_plugin_register, &description);
  }

 private:
  /// Never null: a shape may have no parameters.
  static const double *first_of(std::initializer_list<double> params) {
    static constexpr double none = 0;
    return params.size() ? params.begin() : &none;
  }
  std::shared_ptr<detail::EngineOwner> owner_ = std::make_shared<detail::EngineOwner>();
};

#if defined(__cpp_exceptions)
using Engine = BasicEngine<Throws>;
using World = BasicWorld<Throws>;
using Body = BasicBody<Throws>;
#endif
namespace results {
using Engine = BasicEngine<Returns>;
using World = BasicWorld<Returns>;
using Body = BasicBody<Returns>;
}  // namespace results

}  // namespace carom
#endif
