// The deepest contact point of a pair, alone.
#include "collision/manifold/manifold.h"
#include "collision/manifold/match.h"

namespace carom::collision {

void keep_deepest(const Candidates& found, const ManifoldSettings& settings, Manifold& manifold) {
  const ContactPoint* const nearest = deepest(found, settings.contact_distance);
  if (!nearest) {
    manifold.count = 0;
    return;
  }
  ContactPoint next = *nearest;
  next.age = manifold.count > 0 && same_point(manifold.point[0], next, merge_distance(settings))
                 ? manifold.point[0].age + 1
                 : 0;
  manifold.point[0] = next;
  manifold.has_more_corners = false;
  manifold.count = 1;
}

}  // namespace carom::collision
