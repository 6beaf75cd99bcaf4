#include "abi/batch_rows.h"

#include "abi/body_fields.h"
#include "abi/columns.h"
#include "abi/joint_fields.h"
#include "abi/record_calls.h"
#include "abi/records.h"
#include "dynamics/contact_views.h"
#include "dynamics/mass.h"
#include "dynamics/query/query.h"

namespace carom::abi {
namespace {

using batch::Rows;
using batch::Why;
using Slots = Array<std::uint32_t>;

constexpr double kLargestGravity = 1e6, kLargestFriction = 1e3, kHeaviest = 1e30, kLongestRay = 1e9;  // m/s^2, 1, kg, m

/// What a check of the boundary says, handed on.
bool pass_on(const Call& inner, Why& why) {
  if (inner.ok()) return true;
  why.remedy = inner.remedy();
  return why.refuse(inner.code(), "%s", inner.message());
}

class Listed : public Rows {
 public:
  Listed(Slots slots, std::size_t width) : slots_(std::move(slots)), width_(width) {}
  std::size_t width() const override { return slots_.size() * width_; }

 protected:
  /// f(slot, its record, its number)
  template <class Number, class F>
  void each(Number* row, const F& f) const {
    for (std::size_t i = 0; i < slots_.size(); ++i) f(slots_[i], row + width_ * i, i);
  }
  const Slots slots_;
  const std::size_t width_;
};

class BodyRows final : public Listed {
 public:
  BodyRows(Slots slots, std::uint32_t field)
      : Listed(std::move(slots), static_cast<std::size_t>(body_field(field).scalars)), field_(body_field(field)) {}
  void read(const World& world, Real, double* row) const override {
    each(row, [&](std::uint32_t body, double* record, std::size_t) { field_.read(world, body, record); });
  }
  bool check(const World& model, const double* row, Why& why) const override {
    Call inner(nullptr);
    each(row, [&](std::uint32_t body, const double* record, std::size_t i) {
      if (inner.ok()) check_record(inner, model, field_, body, i, record);
    });
    return pass_on(inner, why);
  }
  bool write(World& world, const double* row, Why&) const override {
    each(row, [&](std::uint32_t body, const double* record, std::size_t) { field_.write(world, body, record); });
    return true;
  }

 private:
  const BodyField& field_;
};

class JointRows final : public Listed {
 public:
  JointRows(Slots slots, std::uint32_t field, Memory* memory)
      : Listed(std::move(slots), joint_bulk_width(field)), field_(field), memory_(memory) {}
  void read(const World& world, Real, double* row) const override {
    each(row, [&](std::uint32_t joint, double* record, std::size_t) { read_joint(world, field_, joint, record); });
  }
  bool check(const World& model, const double* row, Why& why) const override {
    Call inner(nullptr);
    each(row, [&](std::uint32_t joint, const double* record, std::size_t i) {
      if (inner.ok()) check_joint(inner, model, field_, joint, i, record);
    });
    return pass_on(inner, why);
  }
  bool write(World& world, const double* row, Why& why) const override {
    Call inner(nullptr);
    write_joints(inner, world, field_, slots_, row, memory_);
    return pass_on(inner, why);
  }

 private:
  const std::uint32_t field_;
  Memory* const memory_;
};

/// Within bounds, with the thing's number.
bool number_within(Why& why, const char* what, std::size_t i, double value, double low, double high) {
  if (value >= low && value <= high) return true;
  return why.refuse(value != value ? CAROM_E_NOT_FINITE : CAROM_E_OUT_OF_RANGE, "%s %zu is %.17g, must be in [%g, %g]",
                    what, i, value, low, high);
}

class MassRows final : public Listed {
 public:
  MassRows(Slots slots, const World& model) : Listed(std::move(slots), 1), model_(model) {}
  std::span<const std::uint32_t> massed() const override { return slots_; }
  void read(const World& world, Real, double* row) const override {
    each(row, [&](std::uint32_t body, double* mass, std::size_t) { *mass = world.scene.mass[body]; });
  }
  bool check(const World&, const double* row, Why& why) const override {
    for (std::size_t i = 0; i < slots_.size(); ++i)
      if (!number_within(why, "mass", i, row[i], dynamics::kLeastMass, kHeaviest)) return false;
    return true;
  }
  bool write(World& world, const double* row, Why&) const override {
    each(row,
         [&](std::uint32_t body, const double* mass, std::size_t) { batch::set_mass(world, model_, body, *mass); });
    return true;
  }

 private:
  const World& model_;  // of the structure, which outlives its columns
};

class MaterialRows final : public Listed {
 public:
  explicit MaterialRows(Slots slots) : Listed(std::move(slots), 2) {}
  void read(const World& world, Real, double* row) const override {
    each(row, [&](std::uint32_t slot, double* record, std::size_t) {
      record[0] = world.scene.material[slot].friction, record[1] = world.scene.material[slot].restitution;
    });
  }
  bool check(const World&, const double* row, Why& why) const override {
    for (std::size_t i = 0; i < slots_.size(); ++i)
      if (!number_within(why, "friction", i, row[2 * i], 0, kLargestFriction) ||
          !number_within(why, "restitution", i, row[2 * i + 1], 0, 1))
        return false;
    return true;
  }
  bool write(World& world, const double* row, Why&) const override {
    each(row, [&](std::uint32_t slot, const double* record, std::size_t) {
      Material material = world.scene.material[slot];
      if (material.friction == record[0] && material.restitution == record[1]) return;
      material.friction = record[0], material.restitution = record[1];
      world.set_material(slot, material);
    });
    return true;
  }
};

class GravityRow final : public Rows {
 public:
  std::size_t width() const override { return 3; }
  void read(const World& world, Real, double* row) const override { from_vec3(world.scene.gravity, row); }
  bool check(const World&, const double* row, Why& why) const override {
    for (std::size_t k = 0; k < 3; ++k)
      if (!number_within(why, "gravity", k, row[k], -kLargestGravity, kLargestGravity)) return false;
    return true;
  }
  bool write(World& world, const double* row, Why&) const override {
    if (to_vec3(row) != world.scene.gravity) world.set_gravity(to_vec3(row));
    return true;
  }
};

/// What only a step writes.
class ReadOnly : public Listed {
 public:
  using Listed::Listed;
  bool check(const World&, const double*, Why& why) const override {
    return why.refuse(CAROM_E_UNSUPPORTED, "the column can be read, not written");
  }
  bool write(World&, const double*, Why& why) const override {
    return why.refuse(CAROM_E_UNSUPPORTED, "the column can be read, not written");
  }
};

class TimeRow final : public ReadOnly {
 public:
  explicit TimeRow(Memory* memory) : ReadOnly(Slots(1, 0, memory), 1) {}
  void read(const World& world, Real, double* row) const override { *row = world.report.time; }
};

class ContactRows final : public ReadOnly {
 public:
  explicit ContactRows(Slots slots) : ReadOnly(std::move(slots), 3) {}
  void read(const World& world, Real dt, double* row) const override {
    std::fill_n(row, width(), 0.0);
    if (dt == 0) return;
    for (const dynamics::ContactView& view : world.contact_views()) {
      const Vec3 force = view.normal * (view.normal_impulse / dt);  // on B
      add(world, view.collider_a, -force, row), add(world, view.collider_b, force, row);
    }
  }

 private:
  void add(const World& world, std::uint32_t collider, const Vec3& force, double* row) const {
    const std::uint32_t body = world.scene.colliders.body[collider];
    each(row, [&](std::uint32_t listed, double* record, std::size_t) {
      if (listed == body)
        for (std::size_t k = 0; k < 3; ++k) record[k] += force[k];
    });
  }
};

class RayRows final : public ReadOnly {
 public:
  RayRows(Slots slots, Array<Ray> rays) : ReadOnly(std::move(slots), 1), rays_(std::move(rays)) {}
  void read(const World& world, Real, double* row) const override {
    each(row, [&](std::uint32_t body, double* distance, std::size_t i) {
      Ray ray = rays_[i];
      QueryOptions options;
      if (body != kInvalid) {
        const Pose pose = world.pose(body);
        ray.origin = pose.apply(ray.origin), ray.direction = pose.q * ray.direction;
        options.filter.ignore = body;
      }
      const dynamics::WorldHit hit = cast_ray(world, ray, options);
      *distance = hit.collider == kInvalid ? ray.max : hit.cast.time;
    });
  }

 private:
  const Array<Ray> rays_;
};

/// What of a world a source lists: null, where it lists nothing.
const SlotPool* pool_of(std::uint32_t source, const World& model) {
  switch (source) {
    case CAROM_COLUMN_JOINTS:
      return &model.joints.slots;
    case CAROM_COLUMN_MATERIALS:
      return &model.scene.material_slots;
    case CAROM_COLUMN_GRAVITY:
    case CAROM_COLUMN_TIME:
      return nullptr;
    default:
      return &model.scene.bodies;
  }
}

bool read_rays(Call& call, const carom_batch_column& desc, Array<Ray>& rays) {
  for (std::uint64_t i = 0; i < desc.n; ++i) {
    const double* const r = desc.rays + 7 * i;
    if (!vector_in_range(call, 2, "origin of a ray", r, kLongestRay) ||
        !vector_in_range(call, 2, "direction of a ray", r + 3, kLongestRay) ||
        !in_range(call, 2, "max of a ray", r[6], 0, kLongestRay))
      return false;
    const Ray ray{to_vec3(r), to_vec3(r + 3), r[6]};
    if (!(ray.direction.norm() > 0))
      return call.fail(CAROM_E_OUT_OF_RANGE, 2, "ray %llu has no direction", static_cast<unsigned long long>(i));
    rays.push_back(ray);
  }
  return true;
}

}  // namespace

bool is_writable(const carom_batch_column& desc) {
  switch (desc.source) {
    case CAROM_COLUMN_BODIES:
      return body_field(desc.field).writable;
    case CAROM_COLUMN_JOINTS:
      return !is_read_only(desc.field);
    default:
      return desc.source < CAROM_COLUMN_TIME;
  }
}

bool may_be_refused(const carom_batch_column& desc) {
  return desc.source == CAROM_COLUMN_JOINTS && moves_joints(desc.field);
}

Owned<Rows> make_rows(Call& call, const carom_batch_column& desc, const World& model, Memory* memory) {
  Slots slots(memory);
  if (const SlotPool* const pool = pool_of(desc.source, model)) {
    slots.reserve(desc.n);
    for (std::uint64_t i = 0; i < desc.n; ++i) {
      const bool of_world = desc.source == CAROM_COLUMN_RAYS && desc.handles[i] == CAROM_NULL_HANDLE;
      if (!of_world && !resolve(call, 2, "one of desc->handles", *pool, desc.handles[i])) return nullptr;
      slots.push_back(of_world ? kInvalid : handle_slot(desc.handles[i]));
    }
  }
  switch (desc.source) {
    case CAROM_COLUMN_BODIES:
      return make_owned<Rows, BodyRows>(memory, std::move(slots), desc.field);
    case CAROM_COLUMN_JOINTS: {
      Call inner(nullptr);
      if (have_joint_field(inner, model, desc.field, desc.handles, desc.n, desc.when == CAROM_WHEN_BEFORE_STEP))
        return make_owned<Rows, JointRows>(memory, std::move(slots), desc.field, memory);
      call.fail(inner.code(), 2, "%s", inner.message());
      if (inner.remedy()) call.advise(inner.remedy());
      return nullptr;
    }
    case CAROM_COLUMN_MASSES:
      for (std::uint64_t i = 0; i < desc.n; ++i)
        if (model.scene.type[slots[i]] != BodyType::dynamic) {
          call.fail(CAROM_E_UNSUPPORTED, 2, "body %llu is not dynamic, so it has no mass",
                    static_cast<unsigned long long>(i));
          call.advise("list dynamic bodies alone");
          return nullptr;
        }
      return make_owned<Rows, MassRows>(memory, std::move(slots), model);
    case CAROM_COLUMN_MATERIALS:
      return make_owned<Rows, MaterialRows>(memory, std::move(slots));
    case CAROM_COLUMN_GRAVITY:
      return make_owned<Rows, GravityRow>(memory);
    case CAROM_COLUMN_TIME:
      return make_owned<Rows, TimeRow>(memory, memory);
    case CAROM_COLUMN_CONTACT_FORCES:
      return make_owned<Rows, ContactRows>(memory, std::move(slots));
    default: {
      Array<Ray> rays(memory);
      if (!read_rays(call, desc, rays)) return nullptr;
      return make_owned<Rows, RayRows>(memory, std::move(slots), std::move(rays));
    }
  }
}

}  // namespace carom::abi
