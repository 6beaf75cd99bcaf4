// Debug draw: the lines of a world into a host's array.
#include "dynamics/draw.h"

#include <carom/draw.h>

#include "abi/copy_out.h"
#include "core/float_scope.h"
#include "abi/world.h"

namespace carom::abi {
namespace {

static_assert(DrawLine::shapes == CAROM_DRAW_SHAPES && DrawLine::scenery == CAROM_DRAW_SCENERY &&
              DrawLine::bounds == CAROM_DRAW_BOUNDS && DrawLine::contacts == CAROM_DRAW_CONTACTS &&
              DrawLine::joints == CAROM_DRAW_JOINTS && DrawLine::bodies == CAROM_DRAW_BODIES);

constexpr std::uint32_t kAll = 2 * CAROM_DRAW_BODIES - 1;
constexpr double kLongestLine = 1e9;  // m

carom_draw_line element(const World& world, const DrawLine& line) {
  carom_draw_line out{};
  from_vec3(line.from, out.from), from_vec3(line.to, out.to);
  out.colour = line.colour;
  out.kind = line.kind;
  if (line.body != kInvalid) out.body = world.scene.bodies.handle(line.body);
  return out;
}

}  // namespace
}  // namespace carom::abi

using namespace carom;
using namespace carom::abi;

extern "C" {

int32_t carom_draw_desc_init(carom_draw_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, [](carom_draw_desc& d) {
    d.what = CAROM_DRAW_SHAPES | CAROM_DRAW_CONTACTS | CAROM_DRAW_JOINTS;
    d.scale = 0.2;
  });
}

int32_t carom_world_draw(carom_world* world, const carom_draw_desc* desc, carom_draw_line* dst, uint64_t stride,
                         uint64_t capacity, uint64_t* count, carom_error* error) {
  return guarded(error, [&](Call& call) {
    const Reading reading(call, world);
    carom_draw_desc d;
    carom_draw_desc_init(&d, sizeof d);
    if (!reading || (desc && !read_struct(call, 2, "desc", desc, d)) ||
        !only_bits(call, 2, "desc->what", d.what, kAll) || !only_bits(call, 2, "desc->reserved", d.reserved, 0) ||
        !known(call, 2, "desc->colouring", d.colouring, CAROM_DRAW_BY_ISLAND + 1) ||
        !in_range(call, 2, "desc->scale", d.scale, 1e-9, kLongestLine) || !present(call, 6, "count", count))
      return;
    const std::uint64_t step = stride ? stride : sizeof(carom_draw_line), space = dst ? capacity : 0;
    if (space && !element_stride<carom_draw_line>(call, 4, step)) return;
    const FloatScope scope;
    Array<DrawLine> lines(reading->memory);
    draw(*reading, {d.what, d.colouring == CAROM_DRAW_BY_ISLAND, d.scale}, lines);
    *count = lines.size();
    for (std::uint64_t i = 0; i < std::min<std::uint64_t>(space, lines.size()); ++i)
      write_element(element(*reading, lines[i]), dst, i, step);
  });
}

}  // extern "C"
