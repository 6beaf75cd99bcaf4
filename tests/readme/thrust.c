/* What CONTRIBUTING.md's recipe makes, as a host sees it: an attribute that the descriptor, the setter and the getter know, and
 * that pushes the bodies that have it and no other. Compiled by readme/recipe, against headers with its patch. */
#include <carom/carom.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#define TRY(call)                                                                         \
  do {                                                                                    \
    if ((call) != CAROM_OK) return printf("%s: %s. %s\n", #call, e.message, e.remedy), 1; \
  } while (0)
#define HOLDS(what)                                                                \
  do {                                                                             \
    if (!(what)) return printf("line %d: %s does not hold\n", __LINE__, #what), 1; \
  } while (0)
static int near(double a, double b) { return fabs(a - b) < 1e-9; }

int main(void) {
  carom_error e = CAROM_ERROR_INIT;
  carom_engine* engine;
  carom_world *world, *fork;
  carom_body_desc desc;
  carom_body pushed, turned, spinning, left_alone, set_later, twin;
  double v[3], value[4] = {9, 9, 9, 9};
  const double nothing[3] = {0, 0, 0}, half = sqrt(0.5), forward[4] = {0, 0, 8, 0}, wrong[4] = {0, 0, 0, 1},
               nan4[4] = {0, NAN, 0, 0};
  carom_attribute_info info;
  carom_plan_line lines[256];
  uint64_t count = 0;
  int seen = 0;
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));

  memset(&info, 0, sizeof info), info.struct_size = sizeof info;
  TRY(carom_attribute_get_info(CAROM_ATTRIBUTE_THRUST, &info, &e));
  HOLDS(!strcmp(info.name, "thrust") && info.numbers == 3 && info.effect == CAROM_EFFECT_THRUST);
  HOLDS(!strcmp(carom_effect_name(CAROM_EFFECT_THRUST), "thrust"));

  TRY(carom_body_desc_init(&desc, sizeof desc));
  HOLDS(desc.gravity_factor == 1 && desc.force_field_mask == 1 && !memcmp(desc.thrust, nothing, sizeof nothing));
  TRY(carom_body_create(world, &desc, &left_alone, &e));
  TRY(carom_body_create(world, &desc, &set_later, &e));
  desc.fields = CAROM_BODY_FIELD_MASS, desc.mass = 2;
  desc.thrust[2] = 6;
  TRY(carom_body_create(world, &desc, &pushed, &e));
  desc.orientation[1] = half, desc.orientation[3] = half; /* a quarter turn about y: its z axis is the world's x axis */
  TRY(carom_body_create(world, &desc, &turned, &e));
  desc.fields |= CAROM_BODY_FIELD_INERTIA, desc.inertia[0] = desc.inertia[4] = desc.inertia[8] = 1;
  desc.orientation[1] = 0, desc.orientation[3] = 1, desc.angular_velocity[1] = 2;
  TRY(carom_body_create(world, &desc, &spinning, &e));
  desc.thrust[1] = NAN;
  HOLDS(carom_body_create(world, &desc, &twin, &e) == CAROM_E_NOT_FINITE && strstr(e.message, "desc->thrust"));
  HOLDS(carom_body_set_attribute(world, set_later, CAROM_ATTRIBUTE_THRUST, wrong, &e) == CAROM_E_OUT_OF_RANGE);
  HOLDS(carom_body_set_attribute(world, set_later, CAROM_ATTRIBUTE_THRUST, nan4, &e) == CAROM_E_NOT_FINITE);
  TRY(carom_body_set_attribute(world, set_later, CAROM_ATTRIBUTE_THRUST, forward, &e));
  TRY(carom_body_get_attribute(world, set_later, CAROM_ATTRIBUTE_THRUST, value, &e));
  HOLDS(!memcmp(value, forward, sizeof value));
  TRY(carom_body_get(world, turned, &desc, &e));
  HOLDS(desc.thrust[0] == 0 && desc.thrust[1] == 0 && desc.thrust[2] == 6);
  TRY(carom_world_fork(world, &fork, &e));

  for (int i = 0; i < 60; i++) {
    TRY(carom_world_step(world, 1.0 / 60, &e));
    TRY(carom_world_step(fork, 1.0 / 60, &e));
  }
  TRY(carom_body_get_velocity(world, left_alone, v, NULL, &e)); /* after 1 s: F t / m, and gravity for all */
  HOLDS(near(v[0], 0) && near(v[1], -9.81) && near(v[2], 0));
  TRY(carom_body_get_velocity(world, pushed, v, NULL, &e));
  HOLDS(near(v[0], 0) && near(v[1], -9.81) && near(v[2], 3));
  TRY(carom_body_get_velocity(world, turned, v, NULL, &e));
  HOLDS(near(v[0], 3) && near(v[1], -9.81) && near(v[2], 0));
  TRY(carom_body_get_velocity(world, set_later, v, NULL, &e)); /* 1 kg */
  HOLDS(near(v[0], 0) && near(v[1], -9.81) && near(v[2], 8));
  TRY(carom_body_get_velocity(world, spinning, v, NULL,
                              &e)); /* F / (m w) (1 - cos w t, sin w t) by order 2: (w h)^2 / 12 = 1e-4 */
  HOLDS(fabs(v[0] - 1.5 * (1 - cos(2))) < 1e-3 && near(v[1], -9.81) && fabs(v[2] - 1.5 * sin(2)) < 1e-3);
  TRY(carom_world_translate_handles(fork, &turned, 1, &twin, &e));
  TRY(carom_body_get_velocity(fork, twin, v, NULL, &e));
  HOLDS(near(v[0], 3) && near(v[1], -9.81) && near(v[2], 0));

  TRY(carom_world_get_plan(world, lines, sizeof lines[0], 256, &count, &e));
  for (uint64_t i = 0; i < count; i++)
    if (lines[i].effect == CAROM_EFFECT_THRUST) {
      HOLDS(lines[i].runs && lines[i].participants == 4);
      seen++;
    }
  HOLDS(seen == 1);
  TRY(carom_world_destroy(fork, &e));
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  puts("thrust pushes what has it");
  return 0;
}
