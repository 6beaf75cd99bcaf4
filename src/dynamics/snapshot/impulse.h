// An impulse that a step starts from, as bytes.
#pragma once

#include "dynamics/contact/contact.h"
#include "dynamics/snapshot/section.h"

namespace carom::dynamics::snapshot {

/// @param now  when saving, what is written; what comes back is what the bytes say
template <class Io>
OldImpulse impulse(Io& io, const OldImpulse& now) {
  OldImpulse o;
  o.pair.a = io.value(now.pair.a), o.pair.b = io.value(now.pair.b);
  o.place = io.vec(now.place), o.p = io.vec(now.p);
  const bool turns = yes_or_no(io, Io::saves && !zero_bits(now.moment));
  o.moment = turns ? io.vec(now.moment) : Vec3(Vec3::zero());
  return o;
}

}  // namespace carom::dynamics::snapshot
