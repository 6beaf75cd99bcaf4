// Sequences of calls without libFuzzer: numbered inputs of a generator of its own, counted, over several processes.
//
//   fuzz_calls_campaign --count N [--from K] [--jobs J] [--seconds S] [--edge 1]
//   fuzz_calls_campaign [--edge 1] --show K   that one, with each call and its answer
//
// With --edge 1 one good number in four is as large or as small as it may be.
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "calls.h"

using namespace carom::fuzz;

namespace {

constexpr std::size_t kBytes = 480;  // some thirty calls

constexpr std::uint64_t kTold = 100000;  // after so many a job says how far it is

/// Most sequences are short: four to fourteen calls.
std::size_t size_of(std::uint64_t index) { return index % 8 == 0 ? kBytes : 48 + index % 7 * 24; }

struct Options {
  std::uint64_t from = 0, count = 0;
  int jobs = 1;
  double seconds = 1e9;
  bool to_the_edge = false;
};
struct Sum {
  std::uint64_t sequences = 0, calls = 0, refused = 0, steps = 0, replayed = 0, bad = 0;
};

/// As of fuzz_campaign: any of them can be made again alone.
void input(std::uint64_t index, std::uint8_t* bytes) {
  std::uint64_t state = index * 0xD1342543DE82EF95ull + 1;
  for (std::size_t i = 0; i < kBytes; i += 8) {
    std::uint64_t z = (state += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    z ^= z >> 31;
    std::memcpy(bytes + i, &z, 8);
  }
}

std::uint64_t running = 0;
void crashed(int signal) {
  std::fprintf(stderr, "SIGNAL %d in sequence %llu\n", signal, static_cast<unsigned long long>(running));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

Sum work(const Options& o, int job) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  Sum sum;
  std::uint8_t bytes[kBytes];
  for (std::uint64_t i = o.from + static_cast<std::uint64_t>(job); i < o.from + o.count;
       i += static_cast<std::uint64_t>(o.jobs)) {
    if (std::chrono::duration<double>(Clock::now() - start).count() > o.seconds) break;
    running = i;
    input(i, bytes);
    const Heard h = run_calls(bytes, size_of(i), false, o.to_the_edge);
    if (++sum.sequences % kTold == 0)
      std::fprintf(stderr, "job %d: %llu sequences, %.0f s\n", job, static_cast<unsigned long long>(sum.sequences),
                   std::chrono::duration<double>(Clock::now() - start).count());
    sum.calls += h.calls, sum.refused += h.refused, sum.steps += h.steps, sum.replayed += h.replayed;
    if (h.complaint.empty()) continue;
    std::fprintf(stderr, "VIOLATION in sequence %llu: %s\n", static_cast<unsigned long long>(i), h.complaint.c_str());
    if (++sum.bad >= 20) break;
  }
  return sum;
}

void show(std::uint64_t index, bool to_the_edge) {
  std::uint8_t bytes[kBytes];
  input(index, bytes);
  const Heard h = run_calls(bytes, size_of(index), true, to_the_edge);
  std::printf("%s%s\n", h.trace.c_str(), h.complaint.c_str());
}

int campaign(const Options& o) {
  const auto start = std::chrono::steady_clock::now();
  Sum all;
  bool good = true;
  if (o.jobs == 1) {
    all = work(o, 0);
  } else {
    int ends[2];
    if (pipe(ends)) return 2;
    for (int job = 0; job < o.jobs; ++job)
      if (fork() == 0) {
        const Sum sum = work(o, job);
        _exit(write(ends[1], &sum, sizeof sum) == sizeof sum ? 0 : 1);
      }
    close(ends[1]);
    for (Sum sum; read(ends[0], &sum, sizeof sum) == sizeof sum;)
      all.sequences += sum.sequences, all.calls += sum.calls, all.refused += sum.refused, all.steps += sum.steps,
          all.replayed += sum.replayed, all.bad += sum.bad;
    for (int status = 0; wait(&status) > 0;) good = good && status == 0;
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf("%llu sequences in %.1f s: %llu calls, %llu of them refused, %llu steps; %llu sequences replayed: %s\n",
              static_cast<unsigned long long>(all.sequences), seconds, static_cast<unsigned long long>(all.calls),
              static_cast<unsigned long long>(all.refused), static_cast<unsigned long long>(all.steps),
              static_cast<unsigned long long>(all.replayed), good && all.bad == 0 ? "no violation" : "VIOLATIONS");
  return good && all.bad == 0 && all.sequences > 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  Options o;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string key = argv[i];
    if (key == "--count") o.count = std::strtoull(argv[i + 1], nullptr, 10);
    if (key == "--from") o.from = std::strtoull(argv[i + 1], nullptr, 10);
    if (key == "--jobs") o.jobs = std::atoi(argv[i + 1]);
    if (key == "--seconds") o.seconds = std::atof(argv[i + 1]);
    if (key == "--edge") o.to_the_edge = std::atoi(argv[i + 1]) != 0;
    if (key == "--show") return show(std::strtoull(argv[i + 1], nullptr, 10), o.to_the_edge), 0;
  }
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, crashed);
  if (o.count > 0 && o.jobs > 0) return campaign(o);
  std::fprintf(
      stderr,
      "usage: fuzz_calls_campaign --count N [--from K] [--jobs J] [--seconds S] [--edge 1] | [--edge 1] --show K\n");
  return 2;
}
