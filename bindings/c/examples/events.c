/* Events of contacts: when a ball that falls 2 m hits the ground, and how fast. */
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
  carom_body ground, ball;
  carom_contact_event event, hit = {0};
  uint64_t count, hits = 0;
  const double up[4] = {0, 1, 0, 0}, origin[3] = {0, 0, 0}, radius = 0.5, above[3] = {0, 2.5, 0};
  const double fall = sqrt(2 * 2 / 9.81); /* s */
  double at = 0;
  TRY(carom_engine_create(NULL, &engine, &e));
  TRY(carom_world_create(engine, NULL, &world, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_STATIC, "half_space", up, 4, origin, &ground, &e));
  TRY(carom_body_create_named(world, CAROM_BODY_DYNAMIC, "sphere", &radius, 1, above, &ball, &e));
  TRY(carom_world_collect_events(world, CAROM_EVENTS_CONTACT, 1, &e));
  for (int step = 0; step < 60; step++) {
    TRY(carom_world_step(world, 1.0 / 60, &e)); /* events are those of the last step */
    carom_contact_event events[8];
    TRY(carom_world_get_contact_events(world, events, sizeof event, 8, &count, &e));
    for (uint64_t i = 0; i < count && i < 8; i++)
      if (events[i].kind == CAROM_CONTACT_HIT && !hits++) hit = events[i], at = (step + 1) / 60.0;
  }
  printf("%d hit, after %.2f s, at %.2f m/s\n", (int)hits, at, hit.approach_speed);
  CHECK(hits == 1 && (hit.body_a == ball || hit.body_b == ball));
  CHECK(fabs(at - fall) < 2.0 / 60 && fabs(hit.approach_speed - 9.81 * fall) < 9.81 / 60);
  TRY(carom_world_destroy(world, &e));
  TRY(carom_engine_destroy(engine, &e));
  return 0;
}
