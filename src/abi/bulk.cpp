// One call for n bodies: read or write a field, in float or double, at any stride.
#include <carom/body_bulk.h>

#include <cstdio>

#include "abi/body_fields.h"
#include "abi/collider.h"
#include "abi/record_calls.h"
#include "abi/records.h"
#include "abi/selection.h"
#include "abi/world.h"

namespace carom::abi {
namespace {

void read_position(const World& w, std::uint32_t b, double* r) { from_vec3(w.pose(b).p, r); }
void read_orientation(const World& w, std::uint32_t b, double* r) { from_quat(w.state.q[b], r); }
void read_pose(const World& w, std::uint32_t b, double* r) {
  const Pose pose = w.pose(b);
  from_vec3(pose.p, r);
  from_quat(pose.q, r + 3);
}
void read_linear(const World& w, std::uint32_t b, double* r) { from_vec3(w.state.v[b], r); }
void read_angular(const World& w, std::uint32_t b, double* r) { from_vec3(w.state.omega[b], r); }
void read_velocity(const World& w, std::uint32_t b, double* r) { read_linear(w, b, r), read_angular(w, b, r + 3); }
void read_force(const World& w, std::uint32_t b, double* r) {
  from_vec3(w.state.force[b], r);
  from_vec3(w.state.torque[b], r + 3);
}
void read_center(const World& w, std::uint32_t b, double* r) { from_vec3(w.state.x[b], r); }
void read_mass(const World& w, std::uint32_t b, double* r) { *r = w.scene.mass[b]; }

void write_position(World& w, std::uint32_t b, const double* r) { w.set_pose(b, {w.pose(b).q, to_vec3(r)}); }
void write_orientation(World& w, std::uint32_t b, const double* r) { w.set_pose(b, {to_quat(r), w.pose(b).p}); }
void write_pose(World& w, std::uint32_t b, const double* r) { w.set_pose(b, {to_quat(r + 3), to_vec3(r)}); }
void write_linear(World& w, std::uint32_t b, const double* r) { w.set_velocity(b, to_vec3(r), w.state.omega[b]); }
void write_angular(World& w, std::uint32_t b, const double* r) { w.set_velocity(b, w.state.v[b], to_vec3(r)); }
void write_velocity(World& w, std::uint32_t b, const double* r) { w.set_velocity(b, to_vec3(r), to_vec3(r + 3)); }
void write_force(World& w, std::uint32_t b, const double* r) { w.set_force(b, to_vec3(r), to_vec3(r + 3)); }

constexpr Selection::Words kBodies = {"bodies", "a body of handles"};

constexpr BodyField kBulkFields[CAROM_FIELD_COUNT] = {
    // in the order of CAROM_FIELD_*
    {"position", 3, true, -1, false, read_position, write_position},
    {"orientation", 4, true, 0, false, read_orientation, write_orientation},
    {"pose", 7, true, 3, false, read_pose, write_pose},
    {"linear_velocity", 3, true, -1, true, read_linear, write_linear},
    {"angular_velocity", 3, true, -1, true, read_angular, write_angular},
    {"velocity", 6, true, -1, true, read_velocity, write_velocity},
    {"force", 6, true, -1, false, read_force, write_force},
    {"center", 3, false, -1, false, read_center, nullptr},
    {"mass", 1, false, -1, false, read_mass, nullptr},
};

/// Checks that reading and writing share; stride 0 becomes the record's size.
bool check_shape_of_data(Call& call, std::uint32_t field, std::uint32_t scalar, std::uint64_t n, const char* name,
                         const void* data, std::uint64_t& stride) {
  if (!known(call, 2, "field", field, CAROM_FIELD_COUNT) || !known(call, 3, "scalar", scalar, CAROM_SCALAR_F64 + 1) ||
      (n && !present(call, 6, name, data)))
    return false;
  return check_stride(call, 7, kBulkFields[field].name, kBulkFields[field].scalars, scalar, stride, n, 5);
}

template <class Scalar>
void read_all(const World& world, const BodyField& field, const Selection& selection, std::uint64_t n, void* dst,
              std::uint64_t stride) {
  selection.for_each(n, [&](std::uint32_t body, std::uint64_t i) {
    double record[kMostScalars];
    field.read(world, body, record);
    store<Scalar>(record, field.scalars, static_cast<char*>(dst) + i * stride);
    return true;
  });
}

template <class Scalar>
void write_all(Call& call, World& world, const BodyField& field, const Selection& selection, std::uint64_t n,
               const void* src, std::uint64_t stride) {
  const auto* bytes = static_cast<const char*>(src);
  selection.for_each(n, [&](std::uint32_t body, std::uint64_t i) {
    double record[kMostScalars];
    load<Scalar>(bytes + i * stride, field.scalars, record);
    return check_record(call, world, field, body, i, record);
  });
  if (!call.ok()) return;
  selection.for_each(n, [&](std::uint32_t body, std::uint64_t i) {
    double record[kMostScalars];
    load<Scalar>(bytes + i * stride, field.scalars, record);
    field.write(world, body, record);
    return true;
  });
}

}  // namespace

const BodyField& body_field(std::uint32_t field) { return kBulkFields[field]; }

bool check_record(Call& call, const World& world, const BodyField& field, std::uint32_t body, std::uint64_t i,
                  const double* record) {
  char name[48];
  std::snprintf(name, sizeof name, "%s of body %llu", field.name, static_cast<unsigned long long>(i));
  if (!finite(call, 6, name, record, field.scalars)) return false;
  if (field.orientation_at >= 0 && !unit(call, 6, name, record + field.orientation_at, 4)) return false;
  if (!field.velocity || world.scene.type[body] != BodyType::fixed) return true;
  for (int k = 0; k < field.scalars; k += 3)
    if (!at_rest(call, 6, name, record + k)) return false;
  return true;
}

bool check_stride(Call& call, int argument, const char* what, int scalars, std::uint32_t scalar, std::uint64_t& stride,
                  std::uint64_t n, int count_argument) {
  const std::uint64_t record = static_cast<std::uint64_t>(scalars) * (scalar == CAROM_SCALAR_F32 ? 4 : 8);
  if (stride == 0) stride = record;
  if (!spans(call, argument, count_argument, n, stride, record)) return false;
  return stride >= record ||
         call.fail(CAROM_E_BUFFER_TOO_SMALL, argument, "stride is %llu, a record of %s has %llu bytes",
                   static_cast<unsigned long long>(stride), what, static_cast<unsigned long long>(record));
}

}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_world_get_bodies(carom_world* world, carom_body* handles, uint64_t capacity, uint64_t* count,
                               carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !present(call, 4, "count", count)) return;
    const SlotPool& bodies = reading->scene.bodies;
    *count = bodies.alive_count();
    if (!handles) return;
    Selection(bodies, nullptr, kBodies).for_each(capacity, [&](std::uint32_t slot, std::uint64_t i) {
      if (i >= capacity) return false;
      handles[i] = bodies.handle(slot);
      return true;
    });
  });
}

int32_t carom_world_read(carom_world* world, uint32_t field, uint32_t scalar, const carom_body* handles, uint64_t n,
                         void* dst, uint64_t stride, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    if (!reading || !check_shape_of_data(call, field, scalar, n, "dst", dst, stride)) return;
    const Selection selection(reading->scene.bodies, handles, kBodies);
    if (!selection.check(call, n)) return;
    const auto read = scalar == CAROM_SCALAR_F32 ? read_all<float> : read_all<double>;
    read(*reading, kBulkFields[field], selection, n, dst, stride);
  });
}

int32_t carom_world_write(carom_world* world, uint32_t field, uint32_t scalar, const carom_body* handles, uint64_t n,
                          const void* src, uint64_t stride, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Recorded changing(call, world, record::world_write(field, scalar, handles, n, src, stride));
    if (!changing || !check_shape_of_data(call, field, scalar, n, "src", src, stride)) return;
    if (!kBulkFields[field].writable) {
      call.fail(CAROM_E_UNSUPPORTED, 2, "%s can be read, not written", kBulkFields[field].name);
      return;
    }
    const Selection selection(changing->scene.bodies, handles, kBodies);
    if (!selection.check(call, n)) return;
    const auto write = scalar == CAROM_SCALAR_F32 ? write_all<float> : write_all<double>;
    write(call, *changing, kBulkFields[field], selection, n, src, stride);
  });
}

}  // extern "C"
