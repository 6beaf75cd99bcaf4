/* A client of version 0.9, with declarations of its own: joints, filters, events, questions to a world. It follows the headers until 1.0 is frozen. */
#include "stage.h"

typedef uint64_t carom_joint;
#define CAROM_JOINT_HINGE 1u
#define CAROM_JOINT_WORLD_FRAME 0x1u
#define CAROM_COORDINATE_TWIST 0u
typedef struct carom_joint_desc {
  uint32_t struct_size;
  uint32_t kind;
  uint32_t fields;
  uint32_t reserved;
  carom_body body_a;
  carom_body body_b;
  double position_a[3];
  double orientation_a[4];
  double position_b[3];
  double orientation_b[4];
  double length;
  double break_force;
  double break_torque;
  uint64_t user;
} carom_joint_desc;
typedef struct carom_joint_limit {
  uint32_t struct_size;
  uint32_t enabled;
  double lower;
  double upper;
} carom_joint_limit;
typedef struct carom_joint_motor {
  uint32_t struct_size;
  uint32_t enabled;
  double speed;
  double most;
} carom_joint_motor;
typedef struct carom_joint_spring {
  uint32_t struct_size;
  uint32_t enabled;
  double target;
  double frequency;
  double damping;
  double most;
} carom_joint_spring;
typedef struct carom_joint_state {
  uint32_t struct_size;
  uint32_t broken;
  double force[3];
  double torque[3];
  double gap;
  double angle;
  double coordinate[4];
} carom_joint_state;
int32_t carom_joint_desc_init(carom_joint_desc* desc, uint32_t struct_size);
int32_t carom_joint_limit_init(carom_joint_limit* limit, uint32_t struct_size);
int32_t carom_joint_motor_init(carom_joint_motor* motor, uint32_t struct_size);
int32_t carom_joint_spring_init(carom_joint_spring* spring, uint32_t struct_size);
int32_t carom_joint_create(carom_world* world, const carom_joint_desc* desc, carom_joint* joint, carom_error* error);
int32_t carom_joint_destroy(carom_world* world, carom_joint joint, carom_error* error);
int32_t carom_joint_get(carom_world* world, carom_joint joint, carom_joint_desc* desc, carom_error* error);
int32_t carom_joint_get_state(carom_world* world, carom_joint joint, carom_joint_state* state, carom_error* error);
int32_t carom_joint_set_limit(carom_world* world, carom_joint joint, uint32_t coordinate,
                              const carom_joint_limit* limit, carom_error* error);
int32_t carom_joint_get_limit(carom_world* world, carom_joint joint, uint32_t coordinate, carom_joint_limit* limit,
                              carom_error* error);
int32_t carom_joint_set_motor(carom_world* world, carom_joint joint, uint32_t coordinate,
                              const carom_joint_motor* motor, carom_error* error);
int32_t carom_joint_set_spring(carom_world* world, carom_joint joint, uint32_t coordinate,
                               const carom_joint_spring* spring, carom_error* error);
int32_t carom_world_get_joints(carom_world* world, carom_joint* joints, uint64_t capacity, uint64_t* count,
                               carom_error* error);
int32_t carom_body_set_filter(carom_world* world, carom_body body, uint64_t category, uint64_t mask, int32_t group,
                              carom_error* error);
int32_t carom_body_ignore_collision(carom_world* world, carom_body body_a, carom_body body_b, uint32_t apart,
                                    carom_error* error);
int32_t carom_collider_set_sensor(carom_world* world, carom_collider collider, uint32_t sensor, carom_error* error);
int32_t carom_collider_is_sensor(carom_world* world, carom_collider collider, uint32_t* sensor, carom_error* error);
int32_t carom_collider_set_filter(carom_world* world, carom_collider collider, uint64_t category, uint64_t mask,
                                  int32_t group, carom_error* error);
#define CAROM_EVENTS_CONTACT 1u
#define CAROM_EVENTS_SENSOR 2u
#define CAROM_EVENTS_SLEEP 4u
#define CAROM_CONTACT_BEGIN 0u
typedef struct carom_contact_event {
  uint32_t kind;
  uint32_t reserved;
  carom_collider collider_a;
  carom_collider collider_b;
  carom_body body_a;
  carom_body body_b;
  double point[3];
  double normal[3];
  double impulse;
  double approach_speed;
} carom_contact_event;
typedef struct carom_sensor_event {
  uint32_t kind;
  uint32_t reserved;
  carom_collider sensor;
  carom_collider other;
  carom_body sensor_body;
  carom_body other_body;
} carom_sensor_event;
int32_t carom_world_collect_events(carom_world* world, uint32_t kinds, double hit_speed, carom_error* error);
int32_t carom_world_get_contact_events(carom_world* world, carom_contact_event* dst, uint64_t stride, uint64_t capacity,
                                       uint64_t* count, carom_error* error);
int32_t carom_world_get_sensor_events(carom_world* world, carom_sensor_event* dst, uint64_t stride, uint64_t capacity,
                                      uint64_t* count, carom_error* error);
#define CAROM_CAST_HIT 1u
typedef struct carom_query_desc {
  uint32_t struct_size;
  uint32_t flags;
  uint64_t category;
  uint64_t mask;
  carom_body ignore;
  double tolerance;
  double target;
  uint32_t iterations;
  uint32_t reserved;
} carom_query_desc;
typedef struct carom_world_hit {
  uint32_t outcome;
  uint32_t status;
  uint64_t query;
  carom_collider collider;
  carom_body body;
  double time;
  double lower;
  double upper;
  double separation;
  double normal[3];
  double point[3];
  double point_own[3];
} carom_world_hit;
int32_t carom_query_desc_init(carom_query_desc* desc, uint32_t struct_size);
int32_t carom_world_cast_ray(carom_world* world, const double origin[3], const double direction[3], double max,
                             const carom_query_desc* desc, carom_world_hit* hit, uint64_t size, carom_error* error);

int main(void) {
  Stage s;
  carom_joint_desc desc;
  carom_joint_limit limit;
  carom_joint_motor motor;
  carom_joint_spring spring;
  carom_joint_state state;
  carom_joint joint, joints[2];
  carom_collider swinging, sensing;
  carom_body pendulum, sensor;
  carom_contact_event contacts[4];
  carom_sensor_event senses[4];
  carom_query_desc how;
  carom_world_hit hit;
  uint64_t n = 0;
  uint32_t is_sensor = 0;
  int i, began = 0, entered = 0;
  double at[3];
  const double eye[3] = {0, 9, 0}, down[3] = {0, -1, 0};

  stage_make(&s, 1);
  pendulum = stage_ball(&s, 10, 5, 0, &swinging);
  sensor = stage_ball(&s, 0.25, 0.5, 0, &sensing);
  OK(carom_collider_set_sensor(s.world, sensing, 1, NULL));
  OK(carom_collider_is_sensor(s.world, sensing, &is_sensor, NULL));
  CHECK(is_sensor == 1);
  OK(carom_body_ignore_collision(s.world, pendulum, sensor, 1, NULL));
  OK(carom_body_set_filter(s.world, s.body, 2, ~(uint64_t)0, 0, NULL));
  OK(carom_joint_desc_init(&desc, sizeof desc));
  desc.kind = CAROM_JOINT_HINGE, desc.fields = CAROM_JOINT_WORLD_FRAME;
  desc.body_b = pendulum;
  desc.position_a[0] = 8, desc.position_a[1] = 5; /* 2 m beside it, axis x of the frame along z */
  desc.orientation_a[1] = -sqrt(0.5), desc.orientation_a[3] = sqrt(0.5);
  OK(carom_joint_create(s.world, &desc, &joint, NULL));
  OK(carom_joint_limit_init(&limit, sizeof limit));
  OK(carom_joint_motor_init(&motor, sizeof motor));
  OK(carom_joint_spring_init(&spring, sizeof spring));
  limit.enabled = 1, limit.lower = -1, limit.upper = 1;
  OK(carom_joint_set_limit(s.world, joint, CAROM_COORDINATE_TWIST, &limit, NULL));
  OK(carom_joint_set_motor(s.world, joint, CAROM_COORDINATE_TWIST, &motor, NULL));
  OK(carom_joint_set_spring(s.world, joint, CAROM_COORDINATE_TWIST, &spring, NULL));
  limit.upper = 0;
  OK(carom_joint_get_limit(s.world, joint, CAROM_COORDINATE_TWIST, &limit, NULL));
  CHECK(limit.upper == 1);
  OK(carom_world_collect_events(s.world, CAROM_EVENTS_CONTACT | CAROM_EVENTS_SENSOR, 1, NULL));
  for (i = 0; i < 100; ++i) {
    OK(carom_world_step(s.world, 0.01, NULL));
    OK(carom_world_get_contact_events(s.world, contacts, sizeof *contacts, 4, &n, NULL));
    began += n > 0 && contacts[0].kind == CAROM_CONTACT_BEGIN;
    OK(carom_world_get_sensor_events(s.world, senses, sizeof *senses, 4, &n, NULL));
    entered += n > 0 && senses[0].sensor == sensing && senses[0].other_body == s.body;
  }
  CHECK(began > 0 && entered > 0);
  stage_position(&s, pendulum, at);
  CHECK(fabs(sqrt((at[0] - 8) * (at[0] - 8) + (at[1] - 5) * (at[1] - 5)) - 2) < 0.01); /* on its circle */
  state.struct_size = sizeof state;
  OK(carom_joint_get_state(s.world, joint, &state, NULL));
  CHECK(!state.broken && fabs(state.coordinate[CAROM_COORDINATE_TWIST]) < 1.05 && state.gap < 0.01);
  OK(carom_world_get_joints(s.world, joints, 2, &n, NULL));
  CHECK(n == 1 && joints[0] == joint);
  OK(carom_joint_get(s.world, joint, &desc, NULL));
  CHECK(desc.body_b == pendulum);
  OK(carom_query_desc_init(&how, sizeof how));
  how.category = 1;
  OK(carom_world_cast_ray(s.world, eye, down, 20, &how, &hit, sizeof hit, NULL));
  CHECK(hit.outcome == CAROM_CAST_HIT && hit.body == s.body && fabs(hit.time - 8) < 0.01);
  OK(carom_joint_destroy(s.world, joint, NULL));
  stage_end(&s);
  return 0;
}
