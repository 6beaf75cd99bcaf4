// The part of `carom accuracy` that asks for accuracies.
#pragma once

#include "cli/commands.h"

namespace carom::tools {
void add_ask_command(CLI::App& accuracy_command, Context& context);
}
