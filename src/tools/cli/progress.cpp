#include "cli/progress.h"

#include <algorithm>
#include <cstdio>

#include "cli/table.h"
#include "host/system.h"

namespace carom::tools {

ShareOfProgress::ShareOfProgress(std::size_t parts)
    : parts_(std::max<std::size_t>(1, parts)), rewrites_(errors_are_seen()) {}

void ShareOfProgress::show(double share) const {
  if (rewrites_)
    std::fprintf(stderr, "\r\033[K  %s %3.0f %%  %.60s", bar(share, 20).c_str(), 100 * share, what_.c_str());
  else
    std::fprintf(stderr, "  %3.0f %%: %s\n", 100 * share, what_.c_str());
}

void ShareOfProgress::begins(const std::string& what) {
  what_ = what;
  show(static_cast<double>(std::min(begun_, parts_)) / static_cast<double>(parts_));
  ++begun_;
}

void ShareOfProgress::goes_on(double done) {
  if (!rewrites_ || begun_ == 0) return;
  show(std::min(1.0, (static_cast<double>(begun_ - 1) + done) / static_cast<double>(parts_)));
}

void ShareOfProgress::clear() const {
  if (rewrites_ && begun_ > 0) std::fprintf(stderr, "\r\033[K");
}

}  // namespace carom::tools
