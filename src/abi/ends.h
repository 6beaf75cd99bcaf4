// The two ends of a joint or a spring: bodies, or one and the world. Argument 2 of a call, a descriptor.
#pragma once

#include "abi/world.h"

namespace carom::abi {

/// Of a body's slot, or kInvalid.
inline bool is_dynamic(const World& world, std::uint32_t slot) {
  return slot != kInvalid && world.scene.type[slot] == BodyType::dynamic;
}

/// @return false, and noted, if the handle names neither a body nor the world
inline bool read_end(Call& call, const World& world, const char* name, carom_body handle, std::uint32_t& slot) {
  slot = kInvalid;
  if (handle == CAROM_NULL_HANDLE) return true;
  if (!resolve(call, 2, name, world.scene.bodies, handle)) return false;
  slot = handle_slot(handle);
  return true;
}

/// Both ends, which are different ones, and one of them can be moved.
/// @param what  "joins"
template <class Desc, class Def>
bool read_ends(Call& call, const World& world, const Desc& d, const char* what, Def& def) {
  if (!read_end(call, world, "desc->body_a", d.body_a, def.body_a) ||
      !read_end(call, world, "desc->body_b", d.body_b, def.body_b))
    return false;
  if (def.body_a == def.body_b)
    return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc %s %s to itself", what, d.body_a ? "a body" : "the world") ||
           call.advise("set body_a and body_b to two different bodies, one of them dynamic");
  return is_dynamic(world, def.body_a) || is_dynamic(world, def.body_b) ||
         call.fail(CAROM_E_OUT_OF_RANGE, 2, "neither of the two bodies is dynamic; one must be") ||
         call.advise("make one of the two bodies dynamic");
}

inline carom_body handle_of_end(const World& world, std::uint32_t slot) {
  return slot == kInvalid ? CAROM_NULL_HANDLE : world.scene.bodies.handle(slot);
}

}  // namespace carom::abi
