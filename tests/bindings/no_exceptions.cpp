// carom.hpp where exceptions are switched off: failures are values.
#include <carom/carom.hpp>

#if defined(__cpp_exceptions)
#error "this file is compiled with -fno-exceptions"
#endif

/// Null, or what went wrong.
const char* without_exceptions() {
  auto engine = carom::results::Engine::create();
  if (!engine) return "no engine";
  auto world = engine->world();
  if (!world || !world->ground()) return "no world";
  if (auto refused = engine->shape("sphere", {-1.0}); refused || refused.error().details.code != CAROM_E_OUT_OF_RANGE)
    return "a radius of -1 was not refused";
  auto shape = engine->shape("sphere", {0.5});
  if (!shape) return "no shape";
  auto ball = world->body(*shape, {.position = {0, 3, 0}});
  for (int i = 0; i < 180; i++)
    if (!world->step(1.0 / 60)) return "no step";
  auto position = ball->position();
  return position && std::abs((*position)[1] - 0.5) < 0.002 ? nullptr : "it does not lie on the ground";
}
