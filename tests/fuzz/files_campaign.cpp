// Files without libFuzzer: numbered mutations of whole files, counted, with the worst time and the memory they took.
//
//   fuzz_files_campaign [--format F] --count N [--from K]     each format N times, or one
//   fuzz_files_campaign --format F --show K FILE              write input K to a file
//   fuzz_files_campaign --write-corpus DIR                    seeds and dictionaries for libFuzzer, a folder a format
#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "files.h"

using namespace carom::fuzz;

namespace {

class Draw {
 public:
  explicit Draw(std::uint64_t seed) : state_(seed * 0xD1342543DE82EF95ull + 1) {}
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9E3779B97F4A7C15ull);
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return z ^ z >> 31;
  }
  std::size_t below(std::size_t n) { return n ? next() % n : 0; }

 private:
  std::uint64_t state_;
};

bool is_number_at(const std::string& text, std::size_t at) { return text[at] >= '0' && text[at] <= '9'; }

void mutate(std::string& bytes, Draw& draw, const std::vector<std::string>& words,
            const std::vector<std::string>& seeds) {
  constexpr std::size_t kLargest = 1 << 16;
  const std::size_t at = draw.below(bytes.size() + 1), run = 1 + draw.below(draw.below(4) ? 8 : 64);
  const auto within = [&](std::size_t n) { return std::min(n, bytes.size() - at); };
  switch (draw.below(9)) {
    case 0:
      if (at < bytes.size()) bytes[at] = static_cast<char>(bytes[at] ^ 1 << draw.below(8));
      break;
    case 1:
      if (at < bytes.size()) bytes[at] = static_cast<char>(draw.below(256));
      break;
    case 2:
      bytes.erase(at, within(run));
      break;
    case 3:
      if (bytes.size() + run <= kLargest) bytes.insert(at, bytes.substr(draw.below(bytes.size() + 1), run));
      break;
    case 4:
      bytes.insert(at, words[draw.below(words.size())]);
      break;
    case 5:  // a whole number of some width, at a place where numbers stand
      for (std::size_t k = 0; k < std::size_t(1) << draw.below(4) && at + k < bytes.size(); ++k)
        bytes[at + k] = static_cast<char>(draw.below(3) ? 0 : 255);
      break;
    case 6: {  // a number of a text, by another
      std::size_t i = at;
      while (i < bytes.size() && !is_number_at(bytes, i)) ++i;
      std::size_t end = i;
      while (end < bytes.size() && is_number_at(bytes, end)) ++end;
      if (end > i) bytes.replace(i, end - i, words[draw.below(16)]);
      break;
    }
    case 7: {  // a word in quotes, by another
      const std::size_t i = bytes.find('"', at), end = i == std::string::npos ? i : bytes.find('"', i + 1);
      if (end != std::string::npos) bytes.replace(i, end - i + 1, words[draw.below(words.size())]);
      break;
    }
    default: {  // the tail of another file
      const std::string& other = seeds[draw.below(seeds.size())];
      bytes = bytes.substr(0, at) + other.substr(draw.below(other.size() + 1));
    }
  }
}

std::string input(FileFormat format, std::uint64_t index) {
  Draw draw(index * kFileFormats + static_cast<std::uint64_t>(format));
  const auto& seeds = seeds_of(format);
  std::string bytes = seeds[draw.below(seeds.size())];
  for (std::size_t n = 1 + draw.below(1 + draw.below(12)); n > 0; --n) mutate(bytes, draw, words_of(format), seeds);
  return bytes;
}

std::uint64_t g_index = 0;
const char* g_format = "";
void crashed(int signal) {
  std::fprintf(stderr, "SIGNAL %d by fuzz_files_campaign --format %s --show %llu FILE\n", signal, g_format,
               static_cast<unsigned long long>(g_index));
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

int run(FileFormat format, std::uint64_t from, std::uint64_t count) {
  using Clock = std::chrono::steady_clock;
  std::uint64_t read = 0, bad = 0, worst = 0;
  double longest = 0;
  g_format = name_of(format);
  const auto start = Clock::now();
  for (g_index = from; g_index < from + count; ++g_index) {
    const std::string bytes = input(format, g_index);
    const std::clock_t before = std::clock();
    const FileHeard heard = read_as(format, bytes);
    const double seconds = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    if (seconds > longest) longest = seconds, worst = g_index;
    read += heard.read;
    if (heard.violation.empty()) continue;
    ++bad;
    std::printf("VIOLATION in %s %llu: %s\n", name_of(format), static_cast<unsigned long long>(g_index),
                heard.violation.c_str());
  }
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  std::printf("%-9s %9llu files, %8llu read, %llu violations, %.0f a second; longest %.3f s (%llu); %ld MiB so far\n",
              name_of(format), static_cast<unsigned long long>(count), static_cast<unsigned long long>(read),
              static_cast<unsigned long long>(bad),
              static_cast<double>(count) / std::chrono::duration<double>(Clock::now() - start).count(), longest,
              static_cast<unsigned long long>(worst), usage.ru_maxrss / 1024);
  std::fflush(stdout);
#ifdef CAROM_SANITIZED
  return bad > 0;
#else
  constexpr double kLongest = 2;  // s, of processor time, of one file
  return bad > 0 || longest > kLongest;
#endif
}

void write_corpus(const std::filesystem::path& folder) {
  for (std::size_t f = 0; f < kFileFormats; ++f) {
    const auto format = static_cast<FileFormat>(f);
    const auto own = folder / name_of(format);
    std::filesystem::create_directories(own);
    std::size_t n = 0;
    for (const std::string& seed : seeds_of(format))
      std::ofstream(own / ("seed" + std::to_string(n++)), std::ios::binary) << seed;
    std::ofstream words(folder / (std::string(name_of(format)) + ".dict"));
    for (const std::string& word : words_of(format)) {
      words << '"';
      for (const char c : word) {
        if (c == '"' || c == '\\')
          words << '\\' << c;
        else if (c == '\n')
          words << "\\x0a";
        else
          words << c;
      }
      words << "\"\n";
    }
  }
}

}  // namespace

int main(int argc, char** argv) {
  std::uint64_t from = 0, count = 0;
  std::string only;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string option = argv[i], value = argv[i + 1];
    if (option == "--format")
      only = value;
    else if (option == "--count")
      count = std::strtoull(value.c_str(), nullptr, 10);
    else if (option == "--from")
      from = std::strtoull(value.c_str(), nullptr, 10);
    else if (option == "--write-corpus")
      return write_corpus(value), 0;
    else if (option == "--show" && i + 2 < argc) {
      for (std::size_t f = 0; f < kFileFormats; ++f)
        if (only == name_of(static_cast<FileFormat>(f)))
          std::ofstream(argv[i + 2], std::ios::binary)
              << input(static_cast<FileFormat>(f), std::strtoull(value.c_str(), nullptr, 10));
      return 0;
    } else
      return std::fprintf(stderr, "usage: see the head of files_campaign.cpp\n"), 2;
  }
  for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGILL}) std::signal(signal, crashed);
  int bad = 0, ran = 0;
  for (std::size_t f = 0; f < kFileFormats; ++f) {
    const auto format = static_cast<FileFormat>(f);
    if (only.empty() || only == name_of(format)) bad |= run(format, from, count), ++ran;
  }
  return ran ? bad : 2;
}
