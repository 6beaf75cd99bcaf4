// The two of `carom accuracy` that take long: sweep and report.
#pragma once

#include "cli/commands.h"

namespace carom::tools {
void add_sweep_and_report_commands(CLI::App& accuracy_command, Context& context);
}
