// What a host does between steps, by calls of the C ABI.
#include "jury/built/builder.h"
#include "jury/trial.h"

namespace carom::tools::jury {
namespace {

constexpr const char* kDoing = "meddling with a scene";

void put(Stage& stage, carom_body body, const Deed& deed) {
  Call call;
  call.done(carom_body_set_pose(stage.world.get(), body, deed.state.position.data(),
                                deed.state.orientation.coeffs().data(), call),
            kDoing);
}

void throw_body(Stage& stage, carom_body body, const Deed& deed) {
  Call call;
  call.done(carom_body_set_velocity(stage.world.get(), body, deed.state.velocity.data(), deed.state.omega.data(), call),
            kDoing);
}

void remove_body(Stage& stage, carom_body& body) {
  Call call;
  call.done(carom_body_destroy(stage.world.get(), body, call), kDoing);
  body = CAROM_NULL_HANDLE;
}

/// Anew, with the handle that the engine gives it then.
void add(Stage& stage, std::size_t member, const Deed& deed) {
  Actor again = stage.actors[member];
  again.position = deed.state.position, again.orientation = deed.state.orientation;
  again.linear_velocity = deed.state.velocity, again.angular_velocity = deed.state.omega;
  const std::size_t made = stage.add(std::move(again));
  stage.actors[member] = stage.actors[made];
  stage.actors.pop_back();
}

}  // namespace

void act(Scenery& scenery, const Deed& deed) {
  Stage& stage = scenery.stage;
  switch (deed.what) {
    case Deed::What::put:
      put(stage, stage.actors[deed.who].body, deed);
      return throw_body(stage, stage.actors[deed.who].body, deed);
    case Deed::What::throws:
      return throw_body(stage, stage.actors[deed.who].body, deed);
    case Deed::What::add:
      return add(stage, deed.who, deed);
    case Deed::What::remove:
      return remove_body(stage, stage.actors[deed.who].body);
    case Deed::What::drive:
      scenery.scene.links[deed.who].drive.goal = deed.value;
      return set_drive(stage, scenery.scene.links[deed.who]);
    case Deed::What::pace:
      return;  // course_of() heeds it
  }
}

}  // namespace carom::tools::jury
