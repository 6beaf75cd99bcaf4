// Loops on the host's threads: parts are claimed here, so that a host that asks for one twice, out of order or not at
// all costs time and nothing else.
#include "abi/jobs.h"

#include <algorithm>
#include <atomic>
#include <system_error>

#include "core/float_scope.h"
#include "core/job_pool.h"

namespace carom::abi {
namespace {

constexpr std::uint32_t kMostThreads = 256;

/// One loop, and which of its parts are claimed.
struct Loop {
  static constexpr std::uint32_t kMostParts = 64;  // bits of a word

  Jobs::Task task;
  void* context;
  std::uint32_t count, grain, parts;
  std::atomic<std::uint64_t> claimed{0};
  std::atomic<bool> failed{false};  // a part was not finished

  void take(std::uint32_t part) {
    const std::uint64_t bit = std::uint64_t{1} << part;
    if (claimed.fetch_or(bit, std::memory_order_relaxed) & bit) return;
    const std::uint32_t begin = part * grain;
    task(context, begin, grain < count - begin ? begin + grain : count);
  }
};

extern "C" void do_parts(void* context, std::uint32_t begin, std::uint32_t end) {
  Loop& loop = *static_cast<Loop*>(context);
  const int cancellation = hold_cancellation();
  {
    const InsideJob inside;
    const FloatScope scope;
    try {
      for (std::uint32_t part = begin; part < std::min(end, loop.parts); ++part) loop.take(part);
    } catch (const ThreadExit&) {
      loop.failed.store(true, std::memory_order_relaxed);
      throw;
    } catch (...) {  // the host's own code between here and the step need not know exceptions
      loop.failed.store(true, std::memory_order_relaxed);
    }
  }
  give_cancellation(cancellation);
}

class HostJobs final : public Jobs {
 public:
  explicit HostJobs(const carom_jobs_desc& desc) : run_(desc.run), user_(desc.user) {}

  void run(Task task, void* context, std::uint32_t count, std::uint32_t grain) override {
    grain = std::max(grain, (count - 1) / Loop::kMostParts + 1);
    Loop loop{task, context, count, grain, (count - 1) / grain + 1};
    call_host([&] { run_(user_, do_parts, &loop, loop.parts); });
    for (std::uint32_t part = 0; part < loop.parts; ++part) loop.take(part);  // what the host left
    if (loop.failed.load(std::memory_order_relaxed)) throw CallbackLeft();
  }

 private:
  void (*run_)(void*, carom_job_fn, void*, std::uint32_t);
  void* user_;
};

}  // namespace

bool make_jobs(Call& call, const carom_jobs_desc& desc, Memory* memory, Owned<Jobs>& jobs) {
  if (desc.threads > kMostThreads)
    return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->threads is %u, must be at most %u", desc.threads, kMostThreads);
  if (desc.run && desc.threads > 1)
    return call.fail(CAROM_E_OUT_OF_RANGE, 2, "desc->threads is %u, and desc->run is given: only one may be",
                     desc.threads);
  if (desc.run) {
    jobs = make_owned<Jobs, HostJobs>(memory, desc);
  } else if (desc.threads > 1) {
    try {
      jobs = make_owned<Jobs, JobPool>(memory, desc.threads, mark_inside, memory);
    } catch (const std::system_error& e) {
      return call.fail(CAROM_E_LIMIT, 2, "no %u threads to be had: %s", desc.threads, e.what());
    }
  }
  return true;
}

}  // namespace carom::abi
