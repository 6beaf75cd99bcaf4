// A child process under a CPU limit: a support function that hangs or crashes takes only the child with it.
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <new>

#include "check/verdict.h"
#include "host/host.h"

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

Verdict& map_verdict() {
  void* memory = mmap(nullptr, sizeof(Verdict), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) throw Error("no shared memory for the check", "free some memory and try again");
  return *new (memory) Verdict();
}

void unmap_verdict(Verdict& verdict) { munmap(&verdict, sizeof(Verdict)); }

ChildEnd run_in_child(unsigned cpu_seconds, Verdict& shared, void (*work)(Verdict&, const void*),
                      const void* argument) {
  std::fflush(nullptr);  // or the child would print our pending text again
  const pid_t child = fork();
  if (child < 0) throw Error("cannot start a child process", "the limit of processes may be reached; try again later");
  if (child == 0) {
    const rlimit cpu = {cpu_seconds, cpu_seconds + 1};
    const rlimit no_core = {0, 0};
    setrlimit(RLIMIT_CPU, &cpu);
    setrlimit(RLIMIT_CORE, &no_core);
    try {
      work(shared, argument);
    } catch (...) {  // or it would go on as a second parent
      shared.threw = 1;
    }
    _exit(0);  // no destructors of the parent's copies
  }
  using Clock = std::chrono::steady_clock;
  const auto deadline = Clock::now() + std::chrono::seconds(2 * cpu_seconds + 5);  // for one that sleeps
  ChildEnd end;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (Clock::now() > deadline && !end.out_of_time) {
      end.out_of_time = true;
      kill(child, SIGKILL);
    }
    usleep(2000);
  }
  if (WIFSIGNALED(status)) {
    end.signal = WTERMSIG(status);
    end.out_of_time = end.out_of_time || end.signal == SIGXCPU;
  } else {
    end.status = WEXITSTATUS(status);
    end.finished = end.status == 0 && shared.complete && !shared.threw;
  }
  return end;
}

}  // namespace carom::tools
