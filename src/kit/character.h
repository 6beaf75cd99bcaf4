// What the calls of carom/character.h share.
#pragma once

#include <carom/character.h>

#include "kit/bodies.h"

namespace carom::kit {

/// What a host passes, checked. @param given  NULL: defaults
bool read_desc(Call& call, int argument, const carom_character_desc* given, carom_character_desc& desc);
bool read_character(Call& call, int argument, const carom_character* given, carom_character& character);
/// The character's own body is one of the world, if it has one; and the world may be read now.
bool has_body(Call& call, int argument, carom_world* world, const carom_character_desc& desc);

/// @see carom_character_push(), carom_character_move_body()
bool push(Call& call, carom_world* world, const carom_character_desc& desc, const carom_character& character, Real dt);
bool move_body(Call& call, carom_world* world, const carom_character_desc& desc, const carom_character& character,
               Real dt);

}  // namespace carom::kit
