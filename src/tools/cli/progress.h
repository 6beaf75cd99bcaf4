// How far a command that takes minutes has come.
#pragma once

#include <cstddef>
#include <string>

namespace carom::tools {

/// On a terminal a line that rewrites itself; elsewhere a line for each part: "   25 %: slide". Both on stderr.
class ShareOfProgress {
 public:
  /// @param parts  of about equal length
  explicit ShareOfProgress(std::size_t parts);
  ~ShareOfProgress() { clear(); }
  ShareOfProgress(const ShareOfProgress&) = delete;
  ShareOfProgress& operator=(const ShareOfProgress&) = delete;

  /// The next part begins; those before it are done.
  void begins(const std::string& what);
  /// @param done  of the part, 0 to 1
  void goes_on(double done);
  /// Before something else is printed.
  void clear() const;

 private:
  void show(double share) const;

  std::size_t parts_, begun_ = 0;
  bool rewrites_;
  std::string what_;
};

}  // namespace carom::tools
