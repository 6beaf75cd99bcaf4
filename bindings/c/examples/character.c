/* A character walks over three steps of 0.2 m, and pushes a crate that stands there. */
#include <carom/carom.h>
#include <math.h>
#include <stdio.h>
#define TRY(call) \
  if ((call) != CAROM_OK) return fprintf(stderr, "%s. %s\n", e.message, e.remedy), 1
#define CHECK(what) \
  if (!(what)) return fprintf(stderr, "wrong: %s\n", #what), 1

int main(void) {
  carom_error e = CAROM_ERROR_INIT;
  carom_engine* engine;
  carom_world* world;
  carom_body ground, steps[3], crate;
  carom_shape capsule;
  carom_character_desc desc;
  carom_character walker;
  const double up[4] = {0, 1, 0, 0}, origin[3] = {0, 0, 0}, half[3] = {2, 0.1, 2};
  const double cube[3] = {0.2, 0.2, 0.2}, there[3] = {3, 0.8, 0};
  const double size[2] = {0.3, 0.6}, walk[3] = {1.5, 0, 0}, dt = 1.0 / 60;
  double moved[3];
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, origin, &ground, &e));
  for (int i = 0; i < 3; i++) {
    const double at[3] = {3 + 0.5 * i, 0.1 + 0.2 * i, 0};
    TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "box", half, 3, at, &steps[i], &e));
  }
  TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "box", cube, 3, there, &crate, &e));
  TRY(carom_shape_create_named(engine, "capsule", size, 2, &capsule, &e));
  TRY(carom_character_desc_init(&desc, sizeof desc));
  TRY(carom_character_init(&walker, sizeof walker));
  desc.step_up = 0.25, walker.position[1] = 1;
  TRY(carom_character_set_shape(engine, world, &desc, &walker, capsule, NULL, &e));
  for (int i = 0; i < 180; i++) {
    TRY(carom_world_step(world, dt, &e));
    TRY(carom_character_move(world, &desc, &walker, walk, 0, dt, &e));
    TRY(carom_character_push(world, &desc, &walker, dt, &e));
  }
  TRY(carom_body_get_pose(world, crate, moved, NULL, &e));
  const double pushed = moved[0] - 3, feet = walker.position[1] - walker.foot;
  const int firm = walker.ground == CAROM_GROUND_FIRM;
  printf("after 3 s it stands on %s ground, %.2f m up, and has pushed a crate by %.1f m\n", firm ? "firm" : "no firm",
         feet, pushed);
  CHECK(firm && fabs(feet - 0.6 - 0.0102) < 1e-4); /* a skin of 0.01 m and 2 % lies between */
  CHECK(pushed > 1 && pushed < 2 && walker.contact_count == 1 && walker.contact_bodies[0] == crate);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
