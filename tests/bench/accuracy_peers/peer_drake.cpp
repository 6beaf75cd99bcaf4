// Drake in a module. Its wheel has no headers, so a child process runs drake_server.py, which builds worlds and steps
// them, and tells the CPU time of each step. Joints are a tree of ball and prismatic joints in reduced coordinates; a
// ball joint that closes a loop is a constraint, of discrete plants alone. Boxes, capsules and cylinders touch
// half-spaces and each other by hydroelastic patches, since a point a pair is all that they have otherwise; balls touch
// by points.
// Dials: approximation (of a discrete plant: 0 lagged, 1 similar, 2 SAP, 3 TAMSI), integrator (of a continuous one: 1
// CENIC, 2 implicit Euler, 3 Radau, 4 and 5 Runge-Kutta of those orders; 0: the plant is discrete), accuracy, substeps,
// modulus (Pa, of patches; 0: points), resolution (of the patches of capsules and cylinders, in radii; 0: they touch by
// points), stiffness (N/m, of points), dissipation (s/m), relaxation (s), threshold (of near-rigid contacts), stiction
// (m/s), bounce_steps and bounce_time (s; of a bounce in a discrete and in a continuous plant).
#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "peer.h"

namespace carom::bench {
namespace {

constexpr int kPatience = 20;  // s of the wall clock, for any one answer

/// No answer in that time.
struct Silent : std::runtime_error {
  Silent() : std::runtime_error("Drake: no answer in " + std::to_string(kPatience) + " s") {}
};

/// The child. It answers one question after the other; if it dies or falls silent, it is lost with all its worlds.
class Server {
 public:
  Server() {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) throw std::runtime_error("Drake: no socket");
    line_ = ends[0];
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[1], 0);
    const char* const words[] = {CAROM_DRAKE_PYTHON, "-s", CAROM_DRAKE_SERVER, CAROM_DRAKE_FOLDER, nullptr};
    const int failed =
        posix_spawn(&child_, words[0], &actions, nullptr, const_cast<char* const*>(words), environ);  // it writes none
    posix_spawn_file_actions_destroy(&actions);
    close(ends[1]);
    if (failed) {
      close(line_);
      throw std::runtime_error("Drake: " CAROM_DRAKE_PYTHON " can't be started");
    }
    const timeval patience = {kPatience, 0};
    setsockopt(line_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    const std::vector<double> parts = answer();
    for (const double part : parts) version_ += (version_.empty() ? "" : ".") + std::to_string(static_cast<int>(part));
  }
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;
  ~Server() { end(); }

  const std::string& version() const { return version_; }
  bool alive() const { return line_ >= 0; }

  /// @param kind  0 build, 1 step, 2 forget   @throws runtime_error with the child's words
  std::vector<double> ask(std::int64_t kind, const std::vector<double>& numbers) {
    const std::int64_t head[2] = {kind, static_cast<std::int64_t>(numbers.size() * sizeof(double))};
    give(head, sizeof head), give(numbers.data(), numbers.size() * sizeof(double));
    return answer();
  }

 private:
  std::vector<double> answer() {
    std::int64_t head[2];
    get(head, sizeof head);
    if (head[0] != 0) {
      std::string words(static_cast<std::size_t>(head[1]), ' ');
      get(words.data(), words.size());
      throw std::runtime_error("Drake: " + words);
    }
    std::vector<double> numbers(static_cast<std::size_t>(head[1]) / sizeof(double));
    get(numbers.data(), numbers.size() * sizeof(double));
    return numbers;
  }
  void give(const void* data, std::size_t size) {
    const char* from = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t n = line_ < 0 ? -1 : send(line_, from, size, MSG_NOSIGNAL);
      if (n <= 0) lose();
      from += n, size -= static_cast<std::size_t>(n);
    }
  }
  void get(void* data, std::size_t size) {
    char* to = static_cast<char*>(data);
    while (size > 0) {
      const ssize_t n = line_ < 0 ? -1 : recv(line_, to, size, 0);
      if (n < 0 && line_ >= 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) end(), throw Silent();
      if (n <= 0) lose();
      to += n, size -= static_cast<std::size_t>(n);
    }
  }
  [[noreturn]] void lose() {
    end();
    throw std::runtime_error("Drake: its process is gone");
  }
  void end() {
    if (line_ < 0) return;
    close(line_);
    line_ = -1;
    kill(child_, SIGKILL);
    waitpid(child_, nullptr, 0);
  }

  int line_ = -1;
  pid_t child_ = 0;
  std::string version_;
};

/// One for all worlds, started anew after it was lost.   @throws runtime_error
std::shared_ptr<Server> server() {
  static std::shared_ptr<Server> one;
  if (!one || !one->alive()) one = std::make_shared<Server>();
  return one;
}

struct Dial {
  const char* name;
  double usual;  // negative, or 0 where 0 means nothing: Drake's own
};
constexpr Dial kDials[] = {{"approximation", 0}, {"integrator", 0}, {"accuracy", 1e-4},   {"substeps", 1},
                           {"stiffness", 0},     {"modulus", 1e7},  {"dissipation", -1},  {"relaxation", -1},
                           {"threshold", -1},    {"stiction", -1},  {"bounce_steps", 10}, {"bounce_time", 1e-3},
                           {"resolution", 0.1}};

void append(std::vector<double>& list, const double* x, std::size_t n) { list.insert(list.end(), x, x + n); }

/// As drake_server.py reads it: counts, gravity, dials, 28 numbers a body, 22 a joint.
std::vector<double> numbers_of(const WorldPlan& plan) {
  std::vector<double> list = {static_cast<double>(plan.count), static_cast<double>(plan.joint_count)};
  append(list, plan.gravity, 3);
  for (const Dial& dial : kDials) list.push_back(plan.dial(dial.name, dial.usual));
  for (std::size_t i = 0; i < plan.count; ++i) {
    const BodyPlan& b = plan.bodies[i];
    double params[4] = {0, 0, 0, 0};
    if (b.solid != Solid::hull) std::copy_n(b.params, std::min<std::size_t>(b.param_count, 4), params);
    list.push_back(static_cast<double>(b.solid));
    append(list, params, 4);
    list.push_back(b.is_static), list.push_back(b.mass);
    append(list, b.inertia, 3);
    list.push_back(b.friction), list.push_back(b.restitution);
    append(list, b.start.position, 3), append(list, b.start.orientation, 4);
    append(list, b.start.velocity, 3), append(list, b.start.omega, 3);
    append(list, b.shape_at, 3);
  }
  for (std::size_t i = 0; i < plan.joint_count; ++i) {
    const JointPlan& j = plan.joints[i];
    for (const std::size_t end : {j.a, j.b}) list.push_back(end == kWorldBody ? -1 : static_cast<double>(end));
    append(list, j.on_a, 3), append(list, j.on_b, 3);
    list.push_back(static_cast<double>(j.kind));
    append(list, j.axes_on_a, 4), append(list, j.axes_on_b, 4);
    for (const double x : {j.motor_speed, j.motor_force, j.stiffness, j.damping, j.target}) list.push_back(x);
  }
  return list;
}

class DrakeWorld : public PeerWorld {
 public:
  explicit DrakeWorld(const WorldPlan& plan)
      : server_(server()), number_(server_->ask(0, numbers_of(plan)).at(0)), states_(13 * plan.count, NAN) {
    for (std::size_t i = 0; i < plan.count; ++i) {
      double* const s = &states_[13 * i];
      const BodyState& start = plan.bodies[i].start;
      std::copy_n(start.position, 3, s), std::copy_n(start.orientation, 4, s + 3);
      std::copy_n(start.velocity, 3, s + 7), std::copy_n(start.omega, 3, s + 10);
    }
  }
  ~DrakeWorld() override {
    try {
      if (server_->alive()) server_->ask(2, {number_});
    } catch (const std::exception&) {  // it is gone with all its worlds
    }
  }

  void step(double dt) override {
    if (silent_) return;
    seconds_ = 0;
    if (lost_) return;
    std::vector<double> question = {number_, dt};
    append(question, pushes_.data(), pushes_.size());
    pushes_.clear();
    try {
      const std::vector<double> found = server_->ask(1, question);
      seconds_ = found.at(0);
      std::copy(found.begin() + 1, found.end(), states_.begin());
    } catch (const Silent&) {  // it takes too long: so will each further step
      seconds_ = kPatience, silent_ = true;
    } catch (const std::exception&) {  // Drake throws where its state is no longer finite
      lost_ = true;
      std::fill(states_.begin(), states_.end(), NAN);
    }
  }

  double seconds_elsewhere() const override { return seconds_; }

  void push(std::size_t body, const double* force) override {
    pushes_.push_back(static_cast<double>(body));
    append(pushes_, force, 3);
  }

  void read(BodyState* states) const override {
    for (std::size_t i = 0; i < states_.size(); i += 13, ++states) {
      const double* const s = &states_[i];
      std::copy_n(s, 3, states->position), std::copy_n(s + 3, 4, states->orientation);
      std::copy_n(s + 7, 3, states->velocity), std::copy_n(s + 10, 3, states->omega);
    }
  }

  std::size_t contact_points() const override { return kNotTold; }

 private:
  std::shared_ptr<Server> server_;
  double number_;
  std::vector<double> states_;  // [bodies, 13]
  std::vector<double> pushes_;  // [4 each] which body, N
  double seconds_ = 0;
  bool lost_ = false, silent_ = false;
};

}  // namespace

extern "C" __attribute__((visibility("default"))) PeerEngine carom_bench_engine() {
  static std::string name;
  try {
    name = "Drake " + server()->version() + " (double)";
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
  }
  return {name.empty() ? nullptr : name.c_str(), make_or_tell<DrakeWorld>, [] { return std::size_t(0); }};
}

}  // namespace carom::bench
