// Pairs a second: the single call in a loop, all pairs in one call on 1 and 2 threads, and on the first device of OpenCL.
// Results are compared: they have the same bits. `pairs_by_device [millions of pairs]`
#include <chrono>
#include <cstdio>
#include <functional>

#include "../abi/pair_draws.h"

namespace {

using namespace pair_draws;

double seconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

carom_engine* engine_of(uint32_t threads) {
  carom_engine* engine = nullptr;
  setenv("CAROM_PLUGIN_PATH", CAROM_PLUGIN_DIR, 0);
  carom_engine_create(nullptr, &engine, nullptr);
  carom_jobs_desc jobs;
  carom_jobs_desc_init(&jobs, sizeof jobs);
  jobs.threads = threads;
  carom_engine_set_jobs(engine, &jobs, nullptr);
  return engine;
}

/// @param gap  m: of two shapes of 1 m about as often apart as not at 1.6, nearly always apart at 6
Pairs drawn(carom_engine* engine, std::size_t n, double gap) {
  Pairs pairs;
  draw(pairs, shapes_of_all_kinds(engine, 1, 1), 2, n, 3, gap);
  return pairs;
}

void row(const char* what, std::size_t n, double time) {
  std::printf("| %s | %.3g |\n", what, static_cast<double>(n) / time);
}

void measure(std::size_t n, double gap) {
  std::vector<carom_distance> single, found(n);
  for (const uint32_t threads : {1u, 2u}) {
    carom_engine* engine = engine_of(threads);
    const Pairs pairs = drawn(engine, n, gap);
    if (threads == 1) {
      row("one call a pair", n, seconds([&] { single = one_by_one(engine, pairs, nullptr); }));
      std::size_t deep = 0;
      for (const carom_distance& d : single) deep += d.epa_iterations > 0;
      std::printf("| (cores overlap in %.1f %%) | |\n", 100 * static_cast<double>(deep) / static_cast<double>(n));
    }
    const carom_pairs view = pairs.view();
    row(threads == 1 ? "one call, 1 thread" : "one call, 2 threads", n,
        seconds([&] { carom_pairs_distance(engine, &view, nullptr, found.data(), sizeof found[0], nullptr); }));
    assert_same(found, single);
    carom_device* device = nullptr;
    carom_error e = CAROM_ERROR_INIT;
    if (carom_device_create(engine, 0, &device, &e) != CAROM_OK) {
      std::printf("no device: %s\n", e.message);
    } else {
      carom_device_info info = {};
      info.struct_size = sizeof info;
      const auto ask = [&] { carom_device_pairs_distance(device, &view, nullptr, found.data(), sizeof found[0], &e); };
      const double first = seconds(ask);  // compiles
      const double time = seconds(ask);
      carom_device_get_info(device, &info, nullptr);
      char what[320];
      std::snprintf(what, sizeof what, "%s (first call %.1f s, host did %.1f %%, on %u threads)", info.name, first,
                    100 * static_cast<double>(info.host_pairs) / static_cast<double>(info.pairs), threads);
      row(what, n, time);
      assert_same(found, single);
      carom_device_destroy(device, nullptr);
    }
    carom_engine_destroy(engine, nullptr);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const double millions = argc > 1 ? std::atof(argv[1]) : 0.1;
  for (const double gap : {1.6, 6.0}) {
    std::printf("\n%.2g million pairs within %g m\n\n| how | pairs a second |\n|---|---|\n", millions, gap);
    measure(static_cast<std::size_t>(1e6 * millions), gap);
  }
  return 0;
}
