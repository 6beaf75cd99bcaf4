// Judges answers to the hard pairs by their own references: a hang, a crash and a NaN are wrong answers like others.
#include "hard.h"

#include <signal.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <deque>

#include "hard_pairs.h"
#include "score.h"

namespace carom::bench {

namespace {

enum Outcome : int { right, crashed, hung, no_number, verdict, value, normal, kOutcomes };

struct Case {
  explicit Case(test::HardPair pair)
      : a(std::move(pair.a)),
        b(std::move(pair.b)),
        expected(pair.expected),
        tolerance(pair.tolerance),
        smallest(pair.smallest),
        asked(1e-6 * std::max(a.shape.bounding_radius, b.shape.bounding_radius)) {
    query = {&a.solid, &b.solid, placement(Frame()), placement(pair.b_in_a), 0};
  }

  OwnedSolid a, b;
  Query query;
  double expected, tolerance, smallest, asked;
};

/// @return a verdict on one answer; lengths against the smallest feature of the pair, or
///         1e-6 of its size, which is what was asked for, beyond the reference's own error
Outcome judge(const Case& c, const Answer& answer) {
  const double asked = 1e-6 * c.smallest;
  if (wrong_verdict(answer, c.expected, c.tolerance + asked)) return verdict;
  const bool touching = std::fabs(c.expected) <= c.tolerance + asked;
  if (std::isnan(answer.separation)) return right;  // yes or no was the question
  if (!std::isfinite(answer.separation)) return no_number;
  if (std::fabs(answer.separation - c.expected) > c.tolerance + std::max(kWrong * c.smallest, c.asked)) return value;
  const double spare = c.tolerance + std::max(kWaste * c.smallest, c.asked);
  if (!touching && !(waste(c.query, answer, c.expected) <= spare)) return normal;
  return right;
}

/// The child's exit status carries the outcome home. Crashes are its own, and so are hangs: a timer ends it.
Outcome ask_apart(Peer& peer, const Case& c) {
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child == 0) {
    // CPU time, so that a busy machine makes no library hang; the alarm is for one that sleeps.
    const itimerval limit{{0, 0}, {2, 0}};
    setitimer(ITIMER_PROF, &limit, nullptr);
    alarm(60);
    if (!std::freopen("/dev/null", "w", stderr) || !std::freopen("/dev/null", "w", stdout)) _exit(crashed);
    Answer answer;
    peer.prepare(&c.query, 1);
    peer.ask(0, answer);
    _exit(judge(c, answer));
  }
  int status = 0;
  if (child < 0 || waitpid(child, &status, 0) != child) return crashed;
  if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGPROF || WTERMSIG(status) == SIGALRM ? hung : crashed;
  return WEXITSTATUS(status) < kOutcomes ? static_cast<Outcome>(WEXITSTATUS(status)) : crashed;
}

}  // namespace

void print_hard(const Peers& peers, const char* path) {
  std::deque<Case> cases;
  for (test::HardPair& pair : test::load_hard_pairs(path)) cases.emplace_back(std::move(pair));
  std::printf("\n%zu hard pairs\n  %-26s %6s %6s %8s %6s %8s %8s %8s %8s\n", cases.size(), "", "asked", "fail",
              "crashed", "hung", "no number", "verdict", "value", "normal");
  for (const std::unique_ptr<Peer>& peer : peers) {
    std::array<int, kOutcomes> count{};
    int asked = 0;
    for (const Case& c : cases) {
      if (peer->lacks(*c.query.a) || peer->lacks(*c.query.b)) continue;
      ++asked;
      ++count[ask_apart(*peer, c)];
    }
    std::printf("  %-26s %6d %6d %8d %6d %8d %8d %8d %8d\n", peer->name(), asked, asked - count[right], count[crashed],
                count[hung], count[no_number], count[verdict], count[value], count[normal]);
    std::fflush(stdout);
  }
}

}  // namespace carom::bench
