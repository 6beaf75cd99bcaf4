#include "check/verdict.h"

namespace carom::tools {

const char* phase_text(Phase phase) {
  switch (phase) {
    case Phase::start:
      return "starting";
    case Phase::load:
      return "loading the shared object";
    case Phase::describe:
      return "reading its description";
    case Phase::sample:
      return "sampling its support function";
    case Phase::threads:
      return "sampling its support function from several threads";
    case Phase::shapes:
      return "making shapes of it in the engine";
    case Phase::engine_load:
      return "loading it into the engine";
    case Phase::done:
      return "unloading it";
  }
  return "?";
}

}  // namespace carom::tools
