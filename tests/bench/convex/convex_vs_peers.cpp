// The convex core beside other libraries in one process: time, support calls, errors and failures on the same pairs.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <stdexcept>

#include "../module_reason.h"
#include "check.h"
#include "hard.h"
#include "measure.h"
#include "score.h"

namespace {

using namespace carom;
using namespace carom::bench;

struct Options {
  std::vector<std::string> families{std::begin(kBenchFamilies), std::end(kBenchFamilies)};
  std::vector<std::string> modules{CAROM_PEER_MODULES};
  std::vector<std::string> only;
  int pairs = 5000, passes = 15;
  bool coherent = false, hard = false, no_time = false, count = false, check = false;
  std::string csv, curve;
};

class Table {
 public:
  explicit Table(const std::string& csv) : csv_(csv.empty() ? nullptr : std::fopen(csv.c_str(), "w")) {
    if (!csv.empty() && !csv_) throw std::runtime_error("can't write " + csv);
    if (csv_)
      std::fprintf(csv_,
                   "family,kind,library,ns,calls,error_50,error_999,error_max,failures,wrong_verdicts,wasteful_normals,"
                   "normals,queries\n");
  }
  ~Table() {
    if (csv_) std::fclose(csv_);
  }
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  void head(const Set& set, const SweepCheck& check) const {
    std::printf("\n%s, %s: %zu queries. Reference against a sweep of %d: +%.0e / -%.0e m\n", set.family.c_str(),
                set.kind.c_str(), set.queries.size(), check.queries, check.worst_above, check.worst_below);
    std::printf("  %-26s %9s %7s %9s %9s %9s %6s %8s %9s\n", "", "ns", "calls", "err 50%", "99.9%", "max", "fail",
                "verdict", "normal>cm");
  }

  void row(const Set& set, const char* peer, double ns, const Score& s) const {
    std::printf("  %-26s %9.0f ", peer, ns);
    s.calls > 0 ? std::printf("%7.1f ", s.calls) : std::printf("%7s ", "n/a");
    if (s.values)
      std::printf("%9.1e %9.1e %9.1e ", s.median, s.most, s.worst);
    else
      std::printf("%9s %9s %9s ", "-", "-", "-");
    std::printf("%6d %8d ", s.failures, s.verdicts);
    s.normals ? std::printf("%7.2f %%\n", 100.0 * s.wasteful / s.normals) : std::printf("%9s\n", "-");
    if (csv_)
      std::fprintf(csv_, "%s,%s,\"%s\",%.1f,%.2f,%.3e,%.3e,%.3e,%d,%d,%d,%d,%d\n", set.family.c_str(), set.kind.c_str(),
                   peer, ns, s.calls, s.median, s.most, s.worst, s.failures, s.verdicts, s.wasteful, s.normals,
                   s.queries);
    std::fflush(stdout);
  }

 private:
  std::FILE* csv_;
};

Peers make_peers(const Options& options) {
  Peers all, chosen;
  add_carom(all);
  add_ccd(all);
  for (const std::string& path : options.modules) {
    const std::string reason = reason_missing(path);
    if (reason.empty())
      add_module(all, path.c_str());
    else
      std::printf("Not in the table: %s: %s\n", path.c_str(), reason.c_str());
  }
  for (std::unique_ptr<Peer>& peer : all) {
    const std::string name = peer->name();
    const auto named = [&](const std::string& part) { return name.find(part) != std::string::npos; };
    if (options.only.empty() || std::any_of(options.only.begin(), options.only.end(), named))
      chosen.push_back(std::move(peer));
  }
  return chosen;
}

/// Why a library can't be asked about all of a set; null: it can.
const char* lacks(const Peer& peer, const Set& set) {
  for (const Query& query : set.queries)
    for (const Solid* const solid : {query.a, query.b})
      if (const char* const lack = peer.lacks(*solid)) return lack;
  return nullptr;
}

void run(const std::vector<Peer*>& asked, const Set& set, const Options& options, const Table& table) {
  std::vector<Peer*> peers;
  std::vector<std::string> unasked;
  for (Peer* const peer : asked)
    if (const char* const lack = lacks(*peer, set))
      unasked.push_back(std::string(peer->name()) + ": " + lack);
    else
      peers.push_back(peer);
  for (Peer* const peer : peers) peer->prepare(set.queries.data(), set.queries.size());
  if (options.count) return count_instructions(peers, set);
  const std::vector<Reference> reference = references(set);
  const SweepCheck check = sweep(set, reference, std::max(1, static_cast<int>(set.queries.size()) / 50));
  std::vector<Score> scores;
  for (Peer* const peer : peers) scores.push_back(score(*peer, set, reference));
  const std::vector<double> ns =
      options.no_time ? std::vector<double>(peers.size(), NAN) : measure(peers, set, options.passes);
  table.head(set, check);
  for (std::size_t p = 0; p < peers.size(); ++p) table.row(set, peers[p]->name(), ns[p], scores[p]);
  for (const std::string& line : unasked) std::printf("  not asked: %s\n", line.c_str());
}

/// What accuracy costs: every sub-algorithm at every tolerance, one line each.
void write_curve(const Options& options) {
  std::FILE* const file = std::fopen(options.curve.c_str(), "w");
  if (!file) throw std::runtime_error("can't write " + options.curve);
  std::fprintf(file, "family,kind,simplex,tolerance,ns,calls,error_999,error_max\n");
  const char* const simplices[] = {"johnson", "voronoi", "voronoi_last"};
  Peers owned;
  std::vector<Peer*> peers;
  for (std::uint32_t simplex = 0; simplex < 3; ++simplex)
    for (int digits = 2; digits <= 12; ++digits) {
      owned.push_back(make_carom(simplex, std::pow(10.0, -digits)));
      peers.push_back(owned.back().get());
    }
  for (const std::string& name : options.families) {
    const Family family(name, options.pairs);
    for (const Set* const set : {&family.apart, &family.deep}) {
      for (Peer* const peer : peers) peer->prepare(set->queries.data(), set->queries.size());
      const std::vector<Reference> reference = references(*set);
      const std::vector<double> ns = measure(peers, *set, options.passes);
      for (std::size_t p = 0; p < peers.size(); ++p) {
        const Score s = score(*peers[p], *set, reference);
        std::fprintf(file, "%s,%s,%s,1e-%zu,%.1f,%.2f,%.3e,%.3e\n", name.c_str(), set->kind.c_str(), simplices[p / 11],
                     2 + p % 11, ns[p], s.calls, s.most, s.worst);
      }
    }
    std::printf("curve: %s\n", name.c_str());
    std::fflush(stdout);
  }
  std::fclose(file);
}

void compare(const Options& options) {
  const Peers peers = make_peers(options);
  if (options.hard) print_hard(peers, CAROM_TEST_DATA "/convex_pairs.jsonl");
  std::vector<Peer*> all, forgetful;
  for (const std::unique_ptr<Peer>& peer : peers) {
    all.push_back(peer.get());
    if (!peer->remembers()) forgetful.push_back(peer.get());
  }
  const Table table(options.csv);
  for (const std::string& name : options.families) {
    if (name.empty()) continue;  // CLI11 hands an empty list over as one empty name
    const Family family(name, options.pairs);
    run(forgetful, family.apart, options, table);
    run(forgetful, family.deep, options, table);
    if (!options.coherent) continue;
    run(all, family.coherent(false), options, table);
    run(all, family.coherent(true), options, table);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"Convex pairs: Carom beside other libraries, speed and what it is worth, in one run."};
  Options options;
  app.add_option("--family", options.families, "Families to run (none: pass an empty list)")->expected(0, -1);
  app.add_option("--pairs", options.pairs, "Pairs a set")->check(CLI::Range(1, 100000))->capture_default_str();
  app.add_option("--passes", options.passes, "Passes over a set")->check(CLI::Range(1, 1000))->capture_default_str();
  app.add_option("--only", options.only, "Libraries whose names hold one of these");
  app.add_option("--module", options.modules, "Shared objects with further libraries (see peer.h)");
  app.add_flag("--coherent", options.coherent, "Also 50 pairs in 400 frames of slow motion, apart and deep");
  app.add_flag("--hard", options.hard, "Also the hard pairs of tests/data, each in a process of its own");
  app.add_flag("--check", options.check, "Hold every library to closed forms instead; exit code 1 if one is wrong");
  app.add_flag("--no-time", options.no_time, "Errors alone");
  app.add_flag("--count", options.count,
               "Count instructions instead, under callgrind (tests/bench/count_instructions)");
  app.add_option("--curve", options.curve, "Measure tolerance against time and error instead, into this file");
  app.add_option("--csv", options.csv, "Write every row to this file as well");
  CLI11_PARSE(app, argc, argv);
  try {
    if (options.check) return check(make_peers(options)) ? 1 : 0;
    options.curve.empty() ? compare(options) : write_curve(options);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "convex_vs_peers: %s\n", error.what());
    return 1;
  }
  return 0;
}
