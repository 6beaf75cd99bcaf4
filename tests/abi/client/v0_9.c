/* A client of version 0.9, with declarations of its own: structs of their first sizes, canaries behind them. It follows the headers until 1.0 is frozen. */
#include "stage.h"

typedef struct Guarded {
  carom_step_report report;
  uint64_t canary;
} Guarded;

static int32_t lies = 0;
static int32_t may_lie(void* user, const double* params, uint64_t count, const double dir[3], double out[3]) {
  int i;
  (void)user, (void)count;
  for (i = 0; i < 3; ++i) out[i] = dir[i] < 0 ? -params[0] : params[0];
  return lies;
}

static uint64_t run(Stage* s) {
  uint64_t hash = 0;
  double y[3];
  stage_world(s, 5);
  stage_steps(s, 50);
  stage_position(s, s->body, y);
  CHECK(fabs(y[1] - (5 - 9.81 / 8)) < 9.81 / 2 * 0.5 * 0.01); /* Euler's error, on either side */
  stage_steps(s, 150);
  stage_position(s, s->body, y);
  CHECK(fabs(y[1] - 0.5) < 0.01);
  OK(carom_world_hash(s->world, &hash, NULL));
  return hash;
}

int main(void) {
  Stage s;
  uint32_t major, minor, patch, dial, count;
  uint64_t n = 0, first;
  Guarded guarded;
  carom_error error = CAROM_ERROR_INIT;
  carom_dial_info dial_info;
  carom_distance distance;
  carom_contact contacts[4];
  struct {
    carom_shape_info info;
    uint64_t canary;
  } shape;
  struct {
    carom_fault faults[2];
    uint64_t canary;
  } faults;
  carom_shape_plugin invalid_plugin = stage_plugin;
  carom_plugin plugin;
  carom_shape crate;
  carom_collider_desc part;
  carom_collider second;
  const double at[3] = {0, 0, 0}, far[3] = {3, 0, 0}, upright[4] = {0, 0, 0, 1}, half = 0.5;
  double value, position[3];

  OK(carom_version(&major, &minor, &patch));
  CHECK(major == CAROM_VERSION_MAJOR);
  CHECK(strcmp(carom_result_name(CAROM_E_BUSY), "CAROM_E_BUSY") == 0);
  stage_engine(&s);
  first = run(&s);
  OK(carom_world_destroy(s.world, NULL));
  CHECK(run(&s) == first);

  /* Reports: as much of them as there was, and no byte more. */
  memset(&guarded, 0x5a, sizeof guarded);
  guarded.report.struct_size = sizeof guarded.report;
  OK(carom_world_get_report(s.world, &guarded.report, &error));
  CHECK(guarded.canary == 0x5a5a5a5a5a5a5a5a && guarded.report.struct_size == sizeof guarded.report);
  CHECK(guarded.report.stage_count <= 16 && guarded.report.steps == 200 && guarded.report.bodies == 2);
  CHECK(guarded.report.contact_points == 1 && guarded.report.max_penetration < 0.01 && guarded.report.faults == 0);
  CHECK(strcmp(carom_stage_name(CAROM_STAGE_SOLVE), "solve") == 0);
  memset(&shape, 0x5a, sizeof shape);
  shape.info.struct_size = sizeof shape.info;
  OK(carom_shape_get_info(s.engine, s.ball, &shape.info, &error));
  CHECK(shape.canary == 0x5a5a5a5a5a5a5a5a && shape.info.form == CAROM_FORM_SPHERE && shape.info.mass_exact == 1);
  CHECK(fabs(shape.info.volume - 3.14159265358979 / 6) < 1e-12);
  OK(carom_world_get_contacts(s.world, contacts, sizeof *contacts, 4, &n, &error));
  CHECK(n == 1 && contacts[0].body_a != contacts[0].body_b && fabs(fabs(contacts[0].normal[1]) - 1) < 1e-9);

  /* Dials by name, queries without a world. */
  OK(carom_dial_get_count(&count));
  CHECK(count >= CAROM_DIAL_COUNT);
  OK(carom_dial_find("broad_phase", &dial, &error));
  CHECK(dial == CAROM_DIAL_BROAD_PHASE);
  dial_info.struct_size = sizeof dial_info;
  OK(carom_dial_get_info(dial, &dial_info, &error));
  CHECK(strcmp(dial_info.name, "broad_phase") == 0 && dial_info.choices != NULL);
  OK(carom_world_set_dial(s.world, dial, CAROM_BROAD_GRID, &error));
  OK(carom_world_get_dial(s.world, dial, &value, &error));
  CHECK(value == CAROM_BROAD_GRID);
  distance.struct_size = sizeof distance;
  OK(carom_shape_distance(s.engine, s.ball, at, upright, s.ball, far, upright, NULL, &distance, &error));
  CHECK(fabs(distance.separation - 2) < 1e-6 && distance.lower <= 2 && distance.upper >= 2);

  /* A wrong argument, with its detail. */
  CHECK(carom_world_step(s.world, -1, &error) == CAROM_E_OUT_OF_RANGE);
  CHECK(error.code == CAROM_E_OUT_OF_RANGE && error.argument == 2 && error.message[0] && error.remedy[0]);

  /* A plugin that lies: told in elements of the first size. */
  invalid_plugin.id = "kept.invalid_plugin", invalid_plugin.geometry = NULL, invalid_plugin.support = may_lie;
  OK(carom_plugin_register(s.engine, &invalid_plugin, &plugin, &error));
  OK(carom_shape_create(s.engine, plugin, &half, 1, &crate, &error));
  OK(carom_collider_desc_init(&part, sizeof part));
  part.shape = crate;
  OK(carom_collider_create(s.world, s.body, &part, &second, &error));
  OK(carom_world_step(s.world, 0.01, &error));
  lies = 1;
  OK(carom_world_step(s.world, 0.01, &error));
  lies = 0;
  memset(&faults, 0x5a, sizeof faults);
  OK(carom_world_get_faults(s.world, faults.faults, sizeof *faults.faults, 2, &n, &error));
  CHECK(n == 1 && faults.faults[0].kind == CAROM_FAULT_RETURNED && faults.faults[0].shape == crate);
  CHECK(faults.faults[0].body == s.body && faults.canary == 0x5a5a5a5a5a5a5a5a);
  stage_steps(&s, 10);
  stage_position(&s, s.body, position);
  CHECK(position[1] > 0.4 && position[1] < 0.6);

  OK(carom_body_destroy(s.world, s.body, &error));
  CHECK(carom_body_set_pose(s.world, s.body, at, upright, &error) == CAROM_E_STALE_HANDLE);
  stage_end(&s);
  return 0;
}
