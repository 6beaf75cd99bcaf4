// How a thread leaves a call otherwise than by returning from it: pthread_exit() in a callback unwinds the stack, as an
// exception does, but must not be stopped on its way. Whoever catches everything lets this one through.
#pragma once

#include <exception>  // says which standard library it is

#ifdef __GLIBCXX__
#include <cxxabi.h>
#endif

#include "core/layers.h"

namespace carom::core {

#ifdef __GLIBCXX__
using ThreadExit = __cxxabiv1::__forced_unwind;
#else
/// Where threads end without unwinding, it is never thrown.
struct ThreadExit {
  ThreadExit() = delete;
};
#endif

}  // namespace carom::core
