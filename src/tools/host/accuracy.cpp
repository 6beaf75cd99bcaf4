// Accuracy in, steps out: what a tool asks for, and what came of it.
#include "host/host.h"

namespace carom::tools {

void World::ask(double tolerance) {
  if (!(tolerance > 0 && tolerance <= 1e6))
    throw Error("--accuracy is out of range",
                "give m and rad per second of motion, more than 0 and at most 1e6: --accuracy 1e-3");
  carom_accuracy asked;
  carom_accuracy_init(&asked, sizeof asked);
  asked.place = asked.turn = tolerance;
  Call call;
  call.done(carom_world_set_accuracy(world_, &asked, call), "asking for an accuracy");
}

carom_growth World::growth(double dt, std::uint32_t steps) const {
  carom_growth growth{};
  growth.struct_size = sizeof growth;
  Call call;
  call.done(carom_world_measure_growth(world_, dt, steps, &growth, call), "measuring how errors grow");
  return growth;
}

std::vector<carom_island> World::islands() const {
  std::uint64_t count = 0;
  Call call;
  const auto read = [&](carom_island* to) {
    call.done(carom_world_get_islands(world_, to, sizeof *to, count, &count, call), "reading islands");
  };
  read(nullptr);
  std::vector<carom_island> list(count);
  read(list.data());
  return list;
}

}  // namespace carom::tools
