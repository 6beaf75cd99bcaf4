// The calls of carom/character.h: what they take and check. mover.h moves, character_push.cpp pushes.
#include "kit/character.h"

#include <carom/shape.h>

#include "kit/mover.h"

namespace carom::kit {
namespace {

constexpr double kFarthest = 1e12;  // m: where a place still has a tenth of a millimetre
constexpr double kFastest = 1e9;    // m/s

carom_character_desc usual_desc() {
  carom_character_desc desc{};
  desc.struct_size = sizeof desc;
  desc.flags = CAROM_CHARACTER_TURNS;
  desc.up[1] = 1;
  desc.gravity = 9.81, desc.fall_speed = 100;
  desc.max_slope = 0.8727;
  desc.step_up = desc.step_down = 0.3;
  desc.skin = 0.01;
  desc.acceleration = 1e9, desc.air_acceleration = 10;
  desc.mass = 80, desc.push_force = 500;
  desc.recover_speed = 5;
  desc.category = desc.mask = ~std::uint64_t(0);
  return desc;
}

carom_character usual_character() {
  carom_character character{};
  character.struct_size = sizeof character;
  character.orientation[3] = character.ground_orientation[3] = 1;
  character.ground_normal[1] = 1;
  return character;
}

/// Where the shape ends along and across `up`, from its origin.
bool measure(Call& call, carom_engine* engine, carom_shape shape, const carom_character_desc& desc,
             carom_character& character) {
  const Quat q = quat_of(character.orientation);
  const Vec3 up = q.conjugate() * Vec3::from(desc.up).normalized();
  const Vec3 side = any_perpendicular(up).normalized(), other = up.cross(side);
  const Vec3 directions[6] = {up, -up, side, -side, other, -other};
  Vec3 points[6];
  carom_error inner = CAROM_ERROR_INIT;
  const std::int32_t result = carom_shape_support(engine, shape, directions[0].data(), 6, points[0].data(), &inner);
  if (!call.passed(result, inner, inner.argument == 1 ? 1 : 5)) return false;
  character.shape = shape;
  character.head = points[0].dot(up), character.foot = -points[1].dot(up);
  character.reach = 0;
  for (int i = 2; i < 6; ++i) character.reach = larger(character.reach, points[i].dot(directions[i]));
  return true;
}

}  // namespace

bool read_desc(Call& call, int argument, const carom_character_desc* given, carom_character_desc& desc) {
  desc = usual_desc();
  return !given ||
         (read_struct(call, argument, "desc", given, desc) &&
          only_bits(call, argument, "desc->flags", desc.flags, CAROM_CHARACTER_TURNS | CAROM_CHARACTER_FLIES) &&
          unit(call, argument, "desc->up", desc.up, 3) &&
          within(call, argument, "desc->gravity", desc.gravity, 0, 1e6) &&
          within(call, argument, "desc->fall_speed", desc.fall_speed, 0, 1e6) &&
          within(call, argument, "desc->max_slope", desc.max_slope, 0, 1.57) &&
          within(call, argument, "desc->step_up", desc.step_up, 0, 1e6) &&
          within(call, argument, "desc->step_down", desc.step_down, 0, 1e6) &&
          within(call, argument, "desc->skin", desc.skin, 1e-6, 1e6) &&
          within(call, argument, "desc->acceleration", desc.acceleration, 0, 1e9) &&
          within(call, argument, "desc->air_acceleration", desc.air_acceleration, 0, 1e9) &&
          within(call, argument, "desc->mass", desc.mass, 0, 1e9) &&
          within(call, argument, "desc->push_force", desc.push_force, 0, 1e12) &&
          within(call, argument, "desc->recover_speed", desc.recover_speed, 0, 1e6));
}

bool read_character(Call& call, int argument, const carom_character* given, carom_character& c) {
  c = usual_character();
  if (!read_struct(call, argument, "character", given, c)) return false;
  const int contacts = static_cast<int>(c.contact_count);
  const auto place = [&](const char* name, const double* v) {
    return within(call, argument, name, v, 3, -kFarthest, kFarthest);
  };
  const auto speed = [&](const char* name, const double* v) {
    return within(call, argument, name, v, 3, -kFastest, kFastest);
  };
  if (!known(call, argument, "character->ground", c.ground, CAROM_GROUND_FIRM + 1) ||
      !only_bits(call, argument, "character->reserved", c.reserved, 0) || !place("character->position", c.position) ||
      !unit(call, argument, "character->orientation", c.orientation, 4) || !speed("character->velocity", c.velocity) ||
      !within(call, argument, "character->foot", c.foot, -1e9, 1e9) ||
      !within(call, argument, "character->head", c.head, -1e9, 1e9) ||
      !within(call, argument, "character->reach", c.reach, 0, 1e9) ||
      !place("character->ground_point", c.ground_point) ||
      !unit(call, argument, "character->ground_normal", c.ground_normal, 3) ||
      !speed("character->ground_velocity", c.ground_velocity) ||
      !within(call, argument, "character->ground_position", c.ground_position, 3, -1e15, 1e15) ||
      !unit(call, argument, "character->ground_orientation", c.ground_orientation, 4))
    return false;
  if (c.contact_count > CAROM_CHARACTER_CONTACTS)
    return call.fail(CAROM_E_OUT_OF_RANGE, argument, "character->contact_count is %u, at most %u", c.contact_count,
                     CAROM_CHARACTER_CONTACTS);
  for (int i = 0; i < contacts; ++i)
    if (!place("character->contact_points", c.contact_points + 3 * i) ||
        !unit(call, argument, "character->contact_normals", c.contact_normals + 3 * i, 3) ||
        !within(call, argument, "character->contact_speeds", c.contact_speeds[i], 0, 2 * kFastest))
      return false;
  return true;
}

namespace {

bool set_shape(Call& call, carom_engine* engine, carom_world* world, const carom_character_desc& desc,
               carom_character& c, carom_shape shape, std::uint32_t* fits) {
  const Vec3 up = Vec3::from(desc.up).normalized();
  const bool first = c.shape == CAROM_NULL_HANDLE;
  const double foot = c.foot;
  if (!measure(call, engine, shape, desc, c)) return false;
  Vec3 p = Vec3::from(c.position);
  if (!first) p += (c.foot - foot) * up;
  for (int k = 0; k < 3; ++k) c.position[k] = p[k];
  Probe probe(call, world, 5);
  probe.look_for(desc.category, desc.mask, desc.body);
  probe.set_shape(shape, quat_of(c.orientation));
  Met met;  // asked of in any case, so that a shape of another engine is refused
  if (!probe.nearest(p, desc.skin, met)) return false;
  if (fits) *fits = !met.any || met.separation >= 0.5 * desc.skin;
  return true;
}

bool move(Call& call, carom_world* world, const carom_character_desc& desc, carom_character& c, const double walk[3],
          double jump, double dt) {
  Mover mover(call, world, desc, c, dt);
  if (!mover.move(Vec3::from(walk), jump)) return false;
  carom_character out;
  Call checked(nullptr);
  if (!read_character(checked, 3, &c, out))
    return call.fail(CAROM_E_OUT_OF_RANGE, 3,
                     "the character would leave the world: place within 1e12 m, speed within 1e9 m/s");
  return true;
}

}  // namespace
}  // namespace carom::kit

using namespace carom::kit;

extern "C" {

int32_t carom_character_desc_init(carom_character_desc* desc, uint32_t struct_size) {
  return init_struct(desc, struct_size, usual_desc());
}

int32_t carom_character_init(carom_character* character, uint32_t struct_size) {
  return init_struct(character, struct_size, usual_character());
}

int32_t carom_character_set_shape(carom_engine* engine, carom_world* world, const carom_character_desc* desc,
                                  carom_character* character, carom_shape shape, uint32_t* fits, carom_error* error) {
  return run_call(error, [&](Call& call) {
    carom_character_desc d;
    carom_character c;
    std::uint32_t does_fit = 1;
    if (!present(call, 1, "engine", engine) || !present(call, 2, "world", world) || !read_desc(call, 3, desc, d) ||
        !has_body(call, 3, world, d) || !read_character(call, 4, character, c) ||
        !set_shape(call, engine, world, d, c, shape, fits ? &does_fit : nullptr))
      return;
    if (fits) *fits = does_fit;
    if (does_fit) write_struct(c, character);
  });
}

int32_t carom_character_move(carom_world* world, const carom_character_desc* desc, carom_character* character,
                             const double walk[3], double jump, double dt, carom_error* error) {
  return run_call(error, [&](Call& call) {
    carom_character_desc d;
    carom_character c;
    if (!present(call, 1, "world", world) || !read_desc(call, 2, desc, d) || !has_body(call, 2, world, d) ||
        !read_character(call, 3, character, c) || !within(call, 4, "walk", walk, 3, -1e6, 1e6) ||
        !within(call, 5, "jump", jump, 0, 1e6) || !within(call, 6, "dt", dt, 0, 1))
      return;
    if (c.shape == CAROM_NULL_HANDLE) {
      call.fail(CAROM_E_INVALID_HANDLE, 3, "character->shape is none: call carom_character_set_shape() first");
      return;
    }
    if (move(call, world, d, c, walk, jump, dt)) write_struct(c, character);
  });
}

int32_t carom_character_push(carom_world* world, const carom_character_desc* desc, const carom_character* character,
                             double dt, carom_error* error) {
  return run_call(error, [&](Call& call) {
    carom_character_desc d;
    carom_character c;
    if (present(call, 1, "world", world) && read_desc(call, 2, desc, d) && has_body(call, 2, world, d) &&
        read_character(call, 3, character, c) && within(call, 4, "dt", dt, 1e-9, 1))
      push(call, world, d, c, dt);
  });
}

int32_t carom_character_move_body(carom_world* world, const carom_character_desc* desc,
                                  const carom_character* character, double dt, carom_error* error) {
  return run_call(error, [&](Call& call) {
    carom_character_desc d;
    carom_character c;
    if (present(call, 1, "world", world) && present(call, 2, "desc", desc) && read_desc(call, 2, desc, d) &&
        has_body(call, 2, world, d) && read_character(call, 3, character, c) && within(call, 4, "dt", dt, 1e-9, 1))
      move_body(call, world, d, c, dt);
  });
}

}  // extern "C"
