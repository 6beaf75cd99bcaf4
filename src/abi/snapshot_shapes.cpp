#include "abi/snapshot_shapes.h"

#include <algorithm>
#include <cstdio>

#include "abi/shape_draft.h"
#include "collision/hull_of.h"
#include "collision/scenery/scenery.h"
#include "dynamics/world.h"

namespace carom::abi {
namespace {

/// Bit for bit: -0 is not 0, and what is no number is itself.
template <class T>
bool same(std::span<const T> a, std::span<const T> b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}
bool same(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

bool is_like(const ShapeRecord& record, const ShapeImage& image) {
  if (!record.shape) return false;
  const Shape& s = *record.shape;
  switch (image.kind) {
    case ShapeImage::of_plugin:
      return record.plugin && record.plugin->description.version == image.version &&
             record.plugin->id == image.plugin && same<double>(s.params, image.numbers);
    case ShapeImage::half_space: {
      const double plane[4] = {s.normal.x(), s.normal.y(), s.normal.z(), s.offset};
      return s.form == Form::half_space && same<double>(plane, image.numbers);
    }
    case ShapeImage::mesh:
      return is_scenery(s) && !s.scenery->is_field() && s.scenery->two_sided == image.two_sided &&
             s.scenery->dropped == image.dropped && same<std::uint32_t>(s.scenery->corner, image.corners) &&
             same<double>({reinterpret_cast<const double*>(s.scenery->vertex.data()), 3 * s.scenery->vertex.size()},
                          image.numbers);
    case ShapeImage::height_field:
      return is_scenery(s) && s.scenery->columns == image.columns && s.scenery->rows == image.rows &&
             same(s.scenery->spacing_x, image.spacing_x) && same(s.scenery->spacing_z, image.spacing_z) &&
             same<double>(s.scenery->heights, image.numbers);
    case ShapeImage::hull_of:
      return s.hull_of && same<double>(s.hull_of->numbers, image.numbers) &&
             std::ranges::equal(s.hull_of->parts, image.parts, {}, &HullOf::Part::shape);
    default:
      return false;
  }
}

bool refuse(SnapshotFault& fault, SnapshotFault::Kind kind, const char* what, const char* why) {
  fault.kind = kind;
  std::snprintf(fault.text, sizeof fault.text, "%.150s: %.80s", what, why);
  return false;
}

/// By id, whatever its version. @return  its handle, or 0
carom_plugin find_plugin(carom_engine& engine, std::string_view id, std::uint32_t& version) {
  const std::lock_guard lock(engine.mutex);
  for (std::uint32_t slot = 0; slot < engine.plugins.size(); ++slot)
    if (engine.plugins[slot] && engine.plugins[slot]->id == id) {
      version = engine.plugins[slot]->description.version;
      return engine.plugin_slots.handle(slot);
    }
  return CAROM_NULL_HANDLE;
}

bool draft_half_space(Call& call, const ShapeImage& image, ShapeDraft& draft) {
  if (!unit(call, 2, "normal", image.numbers.data(), 3) || !finite(call, 2, "offset", &image.numbers[3], 1))
    return false;
  draft_half_space(to_vec3(image.numbers.data()), image.numbers[3], draft);
  return true;
}

/// A shape that no plugin's name stands for.
bool draft_built_in(Call& call, const ShapeImage& image, ShapeDraft& draft) {
  if (image.kind == ShapeImage::half_space) return draft_half_space(call, image, draft);
  if (image.kind == ShapeImage::hull_of)
    return check_hull_of(call, image.parts, image.numbers) && draft_hull_of(call, image.parts, image.numbers, draft);
  if (image.kind == ShapeImage::mesh) {
    carom_mesh_desc d;
    carom_mesh_desc_init(&d, sizeof d);
    d.flags = image.two_sided ? CAROM_SCENERY_TWO_SIDED : 0;
    d.vertices = image.numbers.data(), d.vertex_count = image.numbers.size() / 3;
    d.triangles = image.corners.data(), d.triangle_count = image.corners.size() / 3;
    return draft_mesh(call, d, draft, image.dropped);
  }
  carom_height_field_desc d;
  carom_height_field_desc_init(&d, sizeof d);
  d.columns = image.columns, d.rows = image.rows, d.heights = image.numbers.data();
  d.spacing[0] = image.spacing_x, d.spacing[1] = image.spacing_z;
  return draft_height_field(call, d, draft);
}

}  // namespace

bool EngineNames::name(const Shape& shape, std::string_view& plugin, std::uint32_t& version) const {
  const std::lock_guard lock(engine_.mutex);
  const PluginRecord* const record = engine_.shapes[handle_slot(shape.handle)].plugin;
  if (record) plugin = record->id, version = record->description.version;  // which stays as long as the shape
  return true;
}

EngineShapes::~EngineShapes() {
  const std::lock_guard lock(engine_.mutex);
  for (std::size_t k = held_.size(); k-- > 0;) {  // a hull of shapes before its parts
    ShapeRecord& record = engine_.shapes[held_[k].slot];
    if (--record.uses == 0 && held_[k].made) remove_shape(engine_, held_[k].slot);
  }
}

const Shape* EngineShapes::find(const ShapeImage& image) {
  const std::lock_guard lock(engine_.mutex);
  for (std::uint32_t slot = 0; slot < engine_.shapes.size(); ++slot) {
    ShapeRecord& record = engine_.shapes[slot];
    // Two that are alike stay two: one of them may be in quarantine, or be seen by its handle.
    if (!is_like(record, image) || std::ranges::find(held_, slot, &Held::slot) != held_.end()) continue;
    ++record.uses;
    held_.push_back({slot, false});
    return record.shape;
  }
  return nullptr;
}

bool EngineShapes::make_new(const ShapeImage& image, SnapshotFault& fault, std::uint64_t& handle) {
  Call call(nullptr);
  ShapeDraft draft(&engine_.memory);
  if (image.kind != ShapeImage::of_plugin) {
    return (draft_built_in(call, image, draft) && add_shape(call, engine_, draft, &handle)) ||
           refuse(fault, SnapshotFault::corrupt, "a shape of the snapshot is none", call.message());
  }
  char name[220];
  std::snprintf(name, sizeof name, "%.*s version %u", static_cast<int>(std::min<std::size_t>(image.plugin.size(), 120)),
                image.plugin.data(), image.version);
  std::uint32_t version = 0;
  const carom_plugin plugin = find_plugin(engine_, image.plugin, version);
  PluginPin pin(engine_);
  if (!plugin || !pin.take(call, 2, plugin))
    return refuse(fault, SnapshotFault::missing, name, "that shape plugin is not loaded");
  if (version != image.version) {
    char other[80];
    std::snprintf(other, sizeof other, "of that shape plugin version %u is loaded", version);
    return refuse(fault, SnapshotFault::missing, name, other);
  }
  if (!draft_of_plugin(call, *pin.get(), image.numbers.data(), image.numbers.size(), draft) ||
      !add_shape(call, engine_, draft, &handle, pin.get(), plugin))
    return refuse(fault, SnapshotFault::corrupt, name, call.message());
  pin.keep();
  return true;
}

const Shape* EngineShapes::make(std::size_t, const ShapeImage& image, SnapshotFault& fault) {
  if (image.kind == ShapeImage::known) return nullptr;  // a fork's
  held_.reserve(held_.size() + 1 + held_.size() / 2);
  if (const Shape* const found = find(image)) return found;
  std::uint64_t handle = 0;
  if (!make_new(image, fault, handle)) return nullptr;
  const std::lock_guard lock(engine_.mutex);
  ShapeRecord& record = engine_.shapes[handle_slot(handle)];
  ++record.uses;
  held_.push_back({handle_slot(handle), true});
  return record.shape;
}

const Shape* NumberedShapes::make(std::size_t number, const ShapeImage&, SnapshotFault&) {
  return number < shapes_.size() ? shapes_[number] : nullptr;
}

std::int32_t code_of(const SnapshotFault& fault) {
  switch (fault.kind) {
    case SnapshotFault::newer:
      return CAROM_E_UNSUPPORTED;
    case SnapshotFault::mismatch:
      return CAROM_E_MISMATCH;
    case SnapshotFault::missing:
      return CAROM_E_NOT_FOUND;
    default:
      return CAROM_E_CORRUPT;
  }
}

void wear_shapes(carom_engine& engine, const World& world) {
  const std::lock_guard lock(engine.mutex);
  for (const std::uint32_t slot : world.scene.colliders.live)
    engine.shapes[handle_slot(world.scene.colliders.shape[slot]->handle)].uses += 1;
}

}  // namespace carom::abi
