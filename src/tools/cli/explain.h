// What was wrong with a command line, in words of the shell: which word, and what to type instead.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "host/host.h"

namespace carom::tools {

/// @param app  that was parsed, as far as it went   @return an Error to print: what is wrong, and what to type
Error explain(const CLI::App& app, const CLI::ParseError& wrong);

/// The help of a command, of `carom` itself for no words.   @param words  "accuracy", "run"   @throws Error for a name that is none
std::string help_of(const CLI::App& app, const std::vector<std::string>& words);

}  // namespace carom::tools
