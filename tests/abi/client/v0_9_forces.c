/* A client of version 0.9, with declarations of its own: forces, the plan, the ledger. It follows the headers until 1.0 is frozen. */
#include "stage.h"

int32_t carom_body_add_force_at(carom_world* world, carom_body body, const double force[3], const double point[3],
                                carom_error* error);
int32_t carom_body_set_drag(carom_world* world, carom_body body, double linear, double quadratic, carom_error* error);
int32_t carom_body_get_drag(carom_world* world, carom_body body, double* linear, double* quadratic, carom_error* error);
int32_t carom_world_set_wind(carom_world* world, const double velocity[3], carom_error* error);
int32_t carom_world_get_wind(carom_world* world, double velocity[3], carom_error* error);
typedef uint64_t carom_force_field;
#define CAROM_FORCE_FIELD_UNIFORM 0u
typedef struct carom_force_field_desc {
  uint32_t struct_size;
  uint32_t kind;
  uint32_t is_force;
  uint32_t mask;
  double position[3];
  double orientation[4];
  double half[3];
  double vector[3];
  double strength;
  double pull;
  double lift;
  double reference;
  double core;
  double reach;
  int32_t falloff;
  uint32_t reserved;
  uint64_t user;
} carom_force_field_desc;
int32_t carom_force_field_desc_init(carom_force_field_desc* desc, uint32_t struct_size);
int32_t carom_force_field_create(carom_world* world, const carom_force_field_desc* desc, carom_force_field* field,
                                 carom_error* error);
int32_t carom_force_field_update(carom_world* world, carom_force_field field, const carom_force_field_desc* desc,
                                 carom_error* error);
int32_t carom_force_field_get(carom_world* world, carom_force_field field, carom_force_field_desc* desc,
                              carom_error* error);
int32_t carom_force_field_destroy(carom_world* world, carom_force_field field, carom_error* error);
int32_t carom_body_set_force_field_mask(carom_world* world, carom_body body, uint32_t mask, carom_error* error);
int32_t carom_body_get_force_field_mask(carom_world* world, carom_body body, uint32_t* mask, carom_error* error);
typedef uint64_t carom_spring;
typedef struct carom_spring_desc {
  uint32_t struct_size;
  uint32_t only_pulls;
  carom_body body_a;
  carom_body body_b;
  double anchor_a[3];
  double anchor_b[3];
  double rest;
  double stiffness;
  double damping;
  uint64_t user;
} carom_spring_desc;
int32_t carom_spring_desc_init(carom_spring_desc* desc, uint32_t struct_size);
int32_t carom_spring_create(carom_world* world, const carom_spring_desc* desc, carom_spring* spring,
                            carom_error* error);
int32_t carom_spring_update(carom_world* world, carom_spring spring, double rest, double stiffness, double damping,
                            carom_error* error);
int32_t carom_spring_get(carom_world* world, carom_spring spring, carom_spring_desc* desc, carom_error* error);
int32_t carom_spring_get_state(carom_world* world, carom_spring spring, double* length, double* force,
                               carom_error* error);
int32_t carom_spring_destroy(carom_world* world, carom_spring spring, carom_error* error);
typedef struct carom_water {
  uint32_t struct_size;
  uint32_t reserved;
  double normal[3];
  double level;
  double density;
  double current[3];
  double drag;
} carom_water;
int32_t carom_water_init(carom_water* water, uint32_t struct_size);
int32_t carom_world_set_water(carom_world* world, const carom_water* water, carom_error* error);
int32_t carom_world_get_water(carom_world* world, carom_water* water, uint32_t* present, carom_error* error);
#define CAROM_EFFECT_GRAVITY 3u
#define CAROM_MODE_FORBID 1u
const char* carom_effect_name(uint32_t effect);
int32_t carom_world_set_effect(carom_world* world, uint32_t effect, uint32_t mode, carom_error* error);
int32_t carom_world_get_effect(carom_world* world, uint32_t effect, uint32_t* mode, carom_error* error);
int32_t carom_body_set_effect(carom_world* world, carom_body body, uint32_t effect, uint32_t mode, carom_error* error);
int32_t carom_body_get_effect(carom_world* world, carom_body body, uint32_t effect, uint32_t* mode, carom_error* error);
int32_t carom_world_time_effects(carom_world* world, uint32_t on, carom_error* error);
typedef struct carom_plan_line {
  uint32_t effect;
  uint32_t stage;
  uint32_t mode;
  uint32_t runs;
  uint64_t participants;
  uint64_t wanted;
  uint64_t evaluations;
  uint64_t bytes;
  double seconds;
  uint32_t timing;
  uint32_t reserved;
  char name[32];
  char unit[24];
  char reason[128];
} carom_plan_line;
int32_t carom_world_get_plan(carom_world* world, carom_plan_line* dst, uint64_t stride, uint64_t capacity,
                             uint64_t* count, carom_error* error);
typedef struct carom_ledger_entry {
  const char* name;
  double kinetic;
  double potential;
  double linear[3];
  double angular[3];
  double total_kinetic;
  double total_potential;
  double total_linear[3];
  double total_angular[3];
} carom_ledger_entry;
typedef struct carom_ledger_state {
  uint32_t struct_size;
  uint32_t is_kept;
  uint64_t steps;
  double start_kinetic;
  double start_potential;
  double start_linear[3];
  double start_angular[3];
  double before_kinetic;
  double before_potential;
  double before_linear[3];
  double before_angular[3];
  double now_kinetic;
  double now_potential;
  double now_linear[3];
  double now_angular[3];
  double rounding_energy;
  double rounding_linear;
  double rounding_angular;
  double total_rounding_energy;
  double total_rounding_linear;
  double total_rounding_angular;
} carom_ledger_state;
int32_t carom_world_enable_ledger(carom_world* world, uint32_t on, carom_error* error);
int32_t carom_world_get_ledger(carom_world* world, carom_ledger_entry* dst, uint64_t stride, uint64_t capacity,
                               uint64_t* count, carom_error* error);
int32_t carom_world_get_ledger_state(carom_world* world, carom_ledger_state* state, carom_error* error);

int main(void) {
  Stage s;
  carom_force_field_desc field;
  carom_force_field f;
  carom_spring_desc spring;
  carom_spring held;
  carom_water water;
  static carom_plan_line lines[64];
  static carom_ledger_entry causes[64];
  carom_ledger_state state;
  carom_collider collider;
  carom_body sprung, blown;
  uint64_t n = 0, i;
  uint32_t bits = 0, present = 0;
  int seen = 0;
  double a, b, at[3], sum = 0;
  const double wind[3] = {5, 0, 0}, none[3] = {0, 0, 0};

  stage_make(&s, 1);
  sprung = stage_ball(&s, 0, 20, 0, &collider);
  blown = stage_ball(&s, 50, 20, 0, &collider);
  OK(carom_body_set_drag(s.world, blown, 1e5, 0, NULL));
  OK(carom_body_get_drag(s.world, blown, &a, &b, NULL));
  CHECK(a == 1e5 && b == 0);
  OK(carom_world_set_wind(s.world, wind, NULL));
  OK(carom_world_get_wind(s.world, at, NULL));
  CHECK(at[0] == 5);
  OK(carom_force_field_desc_init(&field, sizeof field));
  field.kind = CAROM_FORCE_FIELD_UNIFORM, field.vector[1] = 9.81, field.mask = 4;
  OK(carom_force_field_create(s.world, &field, &f, NULL));
  OK(carom_force_field_update(s.world, f, &field, NULL));
  OK(carom_force_field_get(s.world, f, &field, NULL));
  OK(carom_body_set_force_field_mask(s.world, blown, 4, NULL)); /* it weighs nothing there */
  OK(carom_body_get_force_field_mask(s.world, blown, &bits, NULL));
  CHECK(bits == 4);
  OK(carom_spring_desc_init(&spring, sizeof spring));
  spring.body_b = sprung, spring.anchor_a[1] = 25, spring.rest = 5, spring.stiffness = 1e5, spring.damping = 1e4;
  OK(carom_spring_create(s.world, &spring, &held, NULL));
  OK(carom_spring_update(s.world, held, 5, 1e5, 1e4, NULL));
  OK(carom_spring_get(s.world, held, &spring, NULL));
  OK(carom_water_init(&water, sizeof water));
  OK(carom_world_set_water(s.world, &water, NULL));
  OK(carom_world_get_water(s.world, &water, &present, NULL));
  CHECK(present == 1 && water.density == 1000);
  CHECK(strcmp(carom_effect_name(CAROM_EFFECT_GRAVITY), "gravity") == 0);
  OK(carom_body_set_effect(s.world, s.body, CAROM_EFFECT_GRAVITY, CAROM_MODE_FORBID, NULL));
  OK(carom_body_get_effect(s.world, s.body, CAROM_EFFECT_GRAVITY, &bits, NULL));
  CHECK(bits == CAROM_MODE_FORBID);
  OK(carom_world_get_effect(s.world, CAROM_EFFECT_GRAVITY, &bits, NULL));
  OK(carom_world_set_effect(s.world, CAROM_EFFECT_GRAVITY, bits, NULL));
  OK(carom_world_time_effects(s.world, 1, NULL));
  OK(carom_body_add_force_at(s.world, s.body, none, none, NULL));
  OK(carom_world_enable_ledger(s.world, 1, NULL));
  stage_steps(&s, 300);
  stage_position(&s, s.body, at);
  CHECK(at[1] == 1);
  stage_position(&s, blown, at);
  CHECK(at[0] > 60 && fabs(at[1] - 20) < 1e-6);
  stage_position(&s, sprung, at);
  CHECK(fabs(at[1] - (20 - 523.6 * 9.81 / 1e5)) < 0.01); /* m g / k lower */
  OK(carom_spring_get_state(s.world, held, &a, &b, NULL));
  CHECK(fabs(a - 5 - 523.6 * 9.81 / 1e5) < 0.01 && b > 0);
  OK(carom_world_get_plan(s.world, lines, sizeof *lines, 64, &n, NULL));
  for (i = 0; i < n; ++i) seen += lines[i].effect == CAROM_EFFECT_GRAVITY && lines[i].runs == 1;
  CHECK(seen == 1);
  OK(carom_world_get_ledger(s.world, causes, sizeof *causes, 64, &n, NULL));
  state.struct_size = sizeof state;
  OK(carom_world_get_ledger_state(s.world, &state, NULL));
  for (i = 0; i < n && i < 64; ++i) sum += causes[i].total_kinetic;
  CHECK(state.is_kept == 1 && state.steps == 300);
  CHECK(fabs(state.start_kinetic + sum - state.now_kinetic) <= state.total_rounding_energy);
  OK(carom_spring_destroy(s.world, held, NULL));
  OK(carom_force_field_destroy(s.world, f, NULL));
  stage_end(&s);
  return 0;
}
