// calls.c by way of carom.hpp.
#include <carom/carom.hpp>
#include <chrono>

int main() {
  constexpr int kBodies = 10000, kSingle = 200000, kBulk = 100;
  auto engine = carom::Engine::create();
  auto world = engine.world();
  const auto shape = engine.shape("sphere", {0.5});
  std::vector<carom::Body> bodies;
  for (int i = 0; i < kBodies; i++) bodies.push_back(world.body(shape, {.position = {2.0 * i, 0, 0}}));
  std::vector<carom::Vec3> positions(kBodies);
  double single = 1e99, bulk = 1e99, sum = 0;
  const auto timed = [](int n, auto each) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < n; i++) each(i);
    return std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count() / n;
  };
  for (int round = 0; round < 7; round++) {
    single = std::min(single, timed(kSingle, [&](int i) { sum += bodies[std::size_t(i % kBodies)].position()[0]; }));
    bulk = std::min(bulk, timed(kBulk, [&](int) { world.positions(positions); }));
  }
  std::printf("%.1f %.0f\n", single, bulk);
  return sum > 0 && positions[1][0] == 2 ? 0 : 1;
}
