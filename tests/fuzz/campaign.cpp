// The same target without libFuzzer: numbered inputs from a generator of its own, counted, over several processes; and
// the replay of cases kept as text.
//
//   fuzz_campaign [--target pair|cast] --chunks N [--from K] [--jobs J] [--done FILE] [--found FILE]
//   fuzz_campaign [--target pair|cast] --replay FILE
// A chunk is 100,000 executions, always the same ones. FILE of --done lists the chunks that are through; those are
// skipped, so that a campaign can be broken off, taken up again, and spread differently.
#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <set>

#include "target.h"

using namespace carom::fuzz;

namespace {

constexpr std::uint64_t kChunk = 100000;

struct Options {
  std::uint64_t from = 0, chunks = 0;
  int jobs = 1;
  std::string target = "pair", done, found, replay;
};

/// Input number `index`, by splitmix64 ([Steele2014]'s mixing): any of them can be made again alone.
void input(std::uint64_t index, std::uint8_t* bytes) {
  std::uint64_t state = index * 0xD1342543DE82EF95ull + 1;
  for (std::size_t i = 0; i < kCaseBytes; i += 8) {
    std::uint64_t z = (state += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    z ^= z >> 31;
    std::memcpy(bytes + i, &z, 8);
  }
}

std::unique_ptr<Target> target;

/// A crash is a finding, too: say which case it was.
void crashed(int signal) {
  std::fprintf(stderr, "SIGNAL %d\n%s\n", signal, target->line().c_str());
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

/// One write per line: lines of several processes don't mix.
void append(const std::string& path, const std::string& line) {
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0644);
  if (file < 0 || write(file, line.data(), line.size()) != static_cast<ssize_t>(line.size()))
    std::fprintf(stderr, "%s: %s\n", path.c_str(), std::strerror(errno));
  if (file >= 0) close(file);
}

bool run_case(const Options& options) {
  const Verdict verdict = target->verdict();
  if (verdict.good) return true;
  const std::string text = std::string("# ") + verdict.reason + '\n' + target->line() + '\n';
  if (options.found.empty())
    std::fprintf(stderr, "VIOLATION %s", text.c_str());
  else
    append(options.found, text);
  return false;
}

/// @return violations
std::uint64_t run_chunk(const Options& options, std::uint64_t chunk) {
  std::uint8_t bytes[kCaseBytes];
  std::uint64_t bad = 0;
  for (std::uint64_t i = chunk * kChunk; i < (chunk + 1) * kChunk; ++i) {
    input(i, bytes);
    target->take(bytes, sizeof bytes);
    bad += !run_case(options);
  }
  if (!options.done.empty()) append(options.done, std::to_string(chunk) + ' ' + std::to_string(bad) + '\n');
  return bad;
}

int work(const Options& options, int job, const std::set<std::uint64_t>& skip) {
  std::uint64_t bad = 0;
  for (std::uint64_t k = options.from; k < options.from + options.chunks; ++k)
    if (k % static_cast<std::uint64_t>(options.jobs) == static_cast<std::uint64_t>(job) && !skip.count(k))
      bad += run_chunk(options, k);
  return bad ? 1 : 0;
}

int campaign(const Options& options) {
  std::set<std::uint64_t> skip;
  std::ifstream before(options.done);
  for (std::uint64_t chunk = 0, bad = 0; before >> chunk >> bad;) skip.insert(chunk);
  const auto start = std::chrono::steady_clock::now();
  bool good = true;
  if (options.jobs == 1) {
    good = work(options, 0, skip) == 0;
  } else {
    for (int job = 0; job < options.jobs; ++job)
      if (fork() == 0) _exit(work(options, job, skip));
    for (int status = 0; wait(&status) > 0;) good = good && status == 0;
  }
  std::uint64_t through = options.chunks;
  for (const std::uint64_t k : skip) through -= k >= options.from && k < options.from + options.chunks;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::printf(
      "%llu executions in %.1f s, %.0f a second; %llu done before: %s\n",
      static_cast<unsigned long long>(through * kChunk), seconds, static_cast<double>(through * kChunk) / seconds,
      static_cast<unsigned long long>((options.chunks - through) * kChunk), good ? "no violation" : "VIOLATIONS");
  return good ? 0 : 1;
}

int replay(const Options& options) {
  std::ifstream file(options.replay);
  if (!file) return std::fprintf(stderr, "cannot read %s\n", options.replay.c_str()), 2;
  int cases = 0, bad = 0;
  for (std::string line; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (!target->read(line)) return std::fprintf(stderr, "no case: %s\n", line.c_str()), 2;
    if (target->line() != line) return std::fprintf(stderr, "text does not come back: %s\n", line.c_str()), 2;
    ++cases;
    bad += !run_case(options);
  }
  std::printf("%d cases, %d violations\n", cases, bad);
  return cases == 0 || bad ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string key = argv[i], value = argv[i + 1];
    if (key == "--chunks") options.chunks = std::strtoull(value.c_str(), nullptr, 10);
    if (key == "--from") options.from = std::strtoull(value.c_str(), nullptr, 10);
    if (key == "--jobs") options.jobs = std::max(1, std::atoi(value.c_str()));
    if (key == "--target") options.target = value;
    if (key == "--done") options.done = value;
    if (key == "--found") options.found = value;
    if (key == "--replay") options.replay = value;
  }
  target = options.target == "cast" ? cast_target() : pair_target();
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) std::signal(signal, crashed);
  if (!options.replay.empty()) return replay(options);
  if (options.chunks > 0) return campaign(options);
  std::fprintf(stderr,
               "usage: fuzz_campaign [--target pair|cast] --chunks N [--from K] [--jobs J] [--done FILE] [--found "
               "FILE] | --replay FILE\n");
  return 2;
}
