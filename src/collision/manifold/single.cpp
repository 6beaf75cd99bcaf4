// The deepest contact point of a pair, alone.
#include "collision/manifold/manifold.h"
#include "collision/manifold/match.h"

namespace carom {

void keep_deepest(const Candidates& found, const ManifoldSettings& settings, Manifold& manifold) {
  int deepest = -1;
  for (int i = 0; i < found.count; ++i)
    if (found.point[i].separation <= settings.contact_distance &&
        (deepest < 0 || found.point[i].separation < found.point[deepest].separation))
      deepest = i;
  if (deepest < 0) {
    manifold.count = 0;
    return;
  }
  ContactPoint next = found.point[deepest];
  next.age = manifold.count > 0 && same_point(manifold.point[0], next, merge_distance(settings))
                 ? manifold.point[0].age + 1
                 : 0;
  manifold.point[0] = next;
  manifold.count = 1;
}

}  // namespace carom
