// Runs the `carom` command as a shell would, for tests of what a person meets.
#pragma once

#include <sys/wait.h>

#include <cstdio>
#include <string>

#include "carom_test.h"

namespace command_test {

struct Outcome {
  int code;          // exit status; -1: it did not exit
  std::string text;  // stdout and stderr
  bool says(const std::string& what) const { return text.find(what) != std::string::npos; }
};

/// @param before  of the command's line: limits, say
inline Outcome run_carom(const std::string& arguments, bool errors_too = true, const std::string& before = "") {
  const std::string line = before + CAROM_COMMAND + " --plugins " + CAROM_PLUGIN_DIR + " " + arguments +
                           (errors_too ? " 2>&1" : " 2>/dev/null");
  FILE* pipe = popen(line.c_str(), "r");
  assert_non_null(pipe);
  Outcome outcome{};
  char buffer[4096];
  for (std::size_t n; (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;) outcome.text.append(buffer, n);
  const int status = pclose(pipe);
  outcome.code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

}  // namespace command_test
