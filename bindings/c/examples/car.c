/* A car brakes: from 20 m/s on tyres of grip 1 it needs v^2 / (2 g) = 20.4 m. */
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
  carom_body ground, body;
  carom_collider collider;
  carom_body_desc about;
  carom_collider_desc part;
  carom_vehicle_desc desc;
  carom_wheel_desc wheel[4];
  carom_vehicle_input input;
  carom_vehicle car;
  carom_wheel state[4];
  const double up[4] = {0, 1, 0, 0}, origin[3] = {0, 0, 0}, half[3] = {0.85, 0.3, 2}, fast[3] = {0, 0, 20};
  double begin[3] = {0}, end[3];
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, origin, &ground, &e));
  TRY(carom_body_desc_init(&about, sizeof about));
  about.fields = CAROM_BODY_FIELD_MASS | CAROM_BODY_FIELD_CENTER | CAROM_BODY_FIELD_INERTIA, about.mass = 1200;
  about.inertia[0] = 1600, about.inertia[4] = 1800, about.inertia[8] = 500, about.position[1] = 0.6;
  TRY(carom_body_create(world, &about, &body, &e));
  TRY(carom_collider_desc_init(&part, sizeof part));
  part.position[1] = 0.15;
  TRY(carom_shape_create_named(engine, "box", half, 3, &part.shape, &e));
  TRY(carom_collider_create(world, body, &part, &collider, &e));
  carom_vehicle_desc_init(&desc, sizeof desc), carom_vehicle_input_init(&input, sizeof input);
  carom_vehicle_init(&car, sizeof car), desc.chassis = body, input.gear = 0;
  for (int i = 0; i < 4; i++) {
    carom_wheel_desc_init(&wheel[i], sizeof *wheel), carom_wheel_init(&state[i], sizeof *state);
    wheel[i].position[0] = i % 2 ? -0.75 : 0.75, wheel[i].position[2] = i < 2 ? 1.3 : -1.3;
    wheel[i].position[1] = -0.32, wheel[i].brake = 1e5, wheel[i].slide = 1;
  }
  for (int step = 0; step < 330; step++) {
    if (step == 120) { /* until then it settles on its springs */
      TRY(carom_body_set_velocity(world, body, fast, origin, &e));
      TRY(carom_body_get_pose(world, body, begin, NULL, &e));
      for (int i = 0; i < 4; i++) state[i].spin = 20 / 0.33;
      input.brake = 1;
    }
    TRY(carom_vehicle_drive(world, &desc, wheel, 4, &input, &car, state, 1.0 / 60, &e));
    TRY(carom_world_step(world, 1.0 / 60, &e));
  }
  TRY(carom_body_get_pose(world, body, end, NULL, &e));
  printf("it brakes from 20 m/s in %.1f m and stands: %.2f m/s\n", end[2] - begin[2], fabs(car.speed));
  CHECK(fabs(end[2] - begin[2] - 400 / (2 * 9.81)) < 0.5 && fabs(car.speed) < 1e-3);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
