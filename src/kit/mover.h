// One move of a character: it follows the ground, leaves what it overlaps, walks or falls, and looks for ground.
#pragma once

#include <carom/character.h>

#include "kit/probe.h"
#include "kit/slide.h"

namespace carom::kit {

class Mover {
 public:
  /// @param character  checked; changes as the move goes on
  Mover(Call& call, carom_world* world, const carom_character_desc& desc, carom_character& character, Real dt);
  /// @param walk  m/s   @param jump  m/s
  bool move(const Vec3& walk, Real jump);

 private:
  /// A motion across `up` on its way over the ground.
  struct Way {
    Vec3 wish;      // m, across up: all of the way
    Real left = 1;  // share of it that is still to go
    Planes ground;  // that it goes over
    Planes walls;   // across up
    Real base = 0;  // m, along up: where the height of a step counts from
    bool stepped = false;
  };

  bool follow_ground();
  bool follow_surface(const Vec3& point, Vec3& velocity);
  bool recover();
  bool walk(const Vec3& wish);
  bool fall(const Vec3& wish, Real jump);
  bool fly(const Vec3& wish);
  bool land(const Met& met, const Vec3& velocity, const Vec3& rest);

  bool go(Way& way);
  bool step_up(Way& way, const Vec3& ahead, const Met& met, bool& done);
  bool is_step(const Way& way, const Vec3& ahead, const Met& met, Real& height);
  bool slide_through(const Vec3& motion, const Vec3& velocity, carom_body skip, Planes& planes);
  bool look_for_ground(Real reach, const Vec3& velocity, bool stepped);
  bool stand(const Met& met, const Vec3& normal, std::uint32_t ground);
  bool is_held(const Met& met, bool& held);
  bool leave_ground(const Vec3& velocity);
  bool touch(const Met& met, const Vec3& velocity);
  Real clear_share(const Vec3& motion, const Met& met) const;
  Real advance(const Vec3& motion, const Met& met);

  bool sweep(const Vec3& motion, Met& met, carom_body skip = CAROM_NULL_HANDLE) {
    return probe_.sweep(p_, motion, skin_, skip, met);
  }
  Vec3 across(const Vec3& v) const { return v - v.dot(up_) * up_; }
  bool is_firm(const Vec3& normal) const { return normal.dot(up_) >= least_up_; }
  Real foot_level() const { return p_.dot(up_) - c_.foot - (skin_ + margin_); }

  Call& call_;
  carom_world* world_;
  const carom_character_desc& desc_;
  carom_character& c_;
  Probe probe_;
  Real dt_, skin_, margin_, least_up_;
  Vec3 up_, p_;
  Vec3 ground_velocity_;  // m/s, of what it rode as the move began, or left
};

}  // namespace carom::kit
