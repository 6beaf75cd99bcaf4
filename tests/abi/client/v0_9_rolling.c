/* A client of version 0.9, with declarations of its own: a surface that resists rolling. It follows the headers until 1.0 is frozen. */
#include "stage.h"

int32_t carom_material_get_resistance(carom_world* world, carom_material material, double* rolling, double* spinning,
                                      carom_error* error);
int32_t carom_material_set_resistance(carom_world* world, carom_material material, double rolling, double spinning,
                                      carom_error* error);

/* @return how far a ball rolls in 3 s that starts at 1 m/s */
static double rolls(double resistance) {
  Stage s;
  carom_material_desc desc;
  carom_material material;
  carom_collider_desc part;
  double rolling, spinning, at[3];
  const double v[3] = {1, 0, 0}, w[3] = {0, 0, -2}; /* 1 m/s on 0.5 m */
  stage_make(&s, 0.5);
  OK(carom_material_desc_init(&desc, sizeof desc));
  OK(carom_material_create(s.world, &desc, &material, NULL));
  OK(carom_material_set_resistance(s.world, material, resistance, 0.25, NULL));
  OK(carom_material_get_resistance(s.world, material, &rolling, &spinning, NULL));
  CHECK(rolling == resistance && spinning == 0.25);
  OK(carom_collider_destroy(s.world, s.collider, NULL));
  OK(carom_collider_destroy(s.world, s.ground_collider, NULL));
  OK(carom_collider_desc_init(&part, sizeof part));
  part.shape = s.ball, part.material = material;
  OK(carom_collider_create(s.world, s.body, &part, &s.collider, NULL));
  part.shape = s.floor;
  OK(carom_collider_create(s.world, s.ground, &part, &s.ground_collider, NULL));
  OK(carom_body_set_velocity(s.world, s.body, v, w, NULL));
  stage_steps(&s, 300);
  stage_position(&s, s.body, at);
  stage_end(&s);
  return at[0];
}

int main(void) {
  CHECK(fabs(rolls(0) - 3) < 0.05);
  CHECK(rolls(0.1) < 1); /* 7/10 v^2 r / (rolling g) = 0.36 m */
  return 0;
}
