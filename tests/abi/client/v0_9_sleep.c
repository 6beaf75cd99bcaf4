/* A client of version 0.9, with declarations of its own: threads, sleep, groups. It follows the headers until 1.0 is frozen. */
#include "stage.h"

typedef void (*carom_job_fn)(void* context, uint32_t begin, uint32_t end);
typedef struct carom_jobs_desc {
  uint32_t struct_size;
  uint32_t threads;
  void (*run)(void* user, carom_job_fn job, void* context, uint32_t count);
  void* user;
} carom_jobs_desc;
int32_t carom_jobs_desc_init(carom_jobs_desc* desc, uint32_t struct_size);
int32_t carom_engine_set_jobs(carom_engine* engine, const carom_jobs_desc* desc, carom_error* error);
int32_t carom_body_is_asleep(carom_world* world, carom_body body, uint32_t* asleep, carom_error* error);
int32_t carom_body_wake(carom_world* world, carom_body body, carom_error* error);
typedef struct carom_group {
  carom_body body;
  uint32_t bodies;
  uint32_t points;
  uint32_t solver;
  uint32_t reason;
  double mass_ratio;
  double sink;
} carom_group;
int32_t carom_world_get_groups(carom_world* world, carom_group* dst, uint64_t stride, uint64_t capacity,
                               uint64_t* count, carom_error* error);

#define DIAL_SOLVER_AUTO 3 /* what has come since 0.9 in lists that grow */
#define DIAL_SLEEP 29u

static uint64_t run(Stage* s) {
  uint64_t hash, n = 0;
  uint32_t asleep = 0;
  int i;
  carom_group groups[8];
  stage_world(s, 0.6);
  for (i = 1; i < 5; ++i) {
    carom_collider collider;
    stage_ball(s, 3. * i, 0.6, 0, &collider);
  }
  OK(carom_world_set_dial(s->world, CAROM_DIAL_SOLVER, DIAL_SOLVER_AUTO, NULL));
  OK(carom_world_set_dial(s->world, DIAL_SLEEP, 1, NULL));
  stage_steps(s, 20);
  OK(carom_world_get_groups(s->world, groups, sizeof *groups, 8, &n, NULL));
  CHECK(n == 5 && groups[0].bodies == 1 && groups[0].points == 1);
  stage_steps(s, 300);
  OK(carom_body_is_asleep(s->world, s->body, &asleep, NULL));
  CHECK(asleep == 1);
  OK(carom_body_wake(s->world, s->body, NULL));
  OK(carom_body_is_asleep(s->world, s->body, &asleep, NULL));
  CHECK(asleep == 0);
  OK(carom_world_hash(s->world, &hash, NULL));
  OK(carom_world_destroy(s->world, NULL));
  return hash;
}

int main(void) {
  Stage s;
  carom_jobs_desc jobs;
  uint64_t alone;
  stage_engine(&s);
  alone = run(&s);
  OK(carom_jobs_desc_init(&jobs, sizeof jobs));
  jobs.threads = 2;
  OK(carom_engine_set_jobs(s.engine, &jobs, NULL));
  CHECK(run(&s) == alone);
  OK(carom_engine_destroy(s.engine, NULL));
  return 0;
}
