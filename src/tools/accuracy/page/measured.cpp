// Small measurements for a report.
#include "accuracy/page/measured.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "host/cpu_time.h"
#include "host/files.h"

namespace carom::tools::accuracy {
namespace {

struct Family {
  const char *name, *plugin;
  std::vector<double> params;
};

/// Corners on a sphere of 0.5 m, spread by the golden angle.
std::vector<double> spread_corners(int n) {
  std::vector<double> xyz;
  for (int i = 0; i < n; ++i) {
    const double y = 1 - (2 * i + 1.0) / n, r = std::sqrt(1 - y * y), angle = 2.399963229728653 * i;
    for (const double v : {r * std::cos(angle), y, r * std::sin(angle)}) xyz.push_back(0.5 * v);
  }
  return xyz;
}

struct Pair {
  double at[3], turn_a[4], turn_b[4];
};

/// Apart by up to a metre, or in overlap, at random attitudes; the same for every family.
std::vector<Pair> pairs(bool apart) {
  std::mt19937_64 random(7);
  // Not std::normal_distribution: the same pairs with every library.
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto each = [&](auto& components) {  // the last first, as it once was: no order is promised in an argument list
    for (Eigen::Index i = components.size(); i-- > 0;) components[i] = uniform() - 0.5;
  };
  std::vector<Pair> list(200);
  for (Pair& p : list) {
    Vec way;
    do each(way);
    while (way.norm() < 0.05 || way.norm() > 0.5);
    const double distance = apart ? 1.8 + uniform() : 0.1 + 0.4 * uniform();
    Vec::Map(p.at) = distance * way.normalized();
    for (double* turn : {p.turn_a, p.turn_b}) {
      Eigen::Vector4d q;
      do each(q);
      while (q.norm() < 0.1 || q.norm() > 0.5);
      Eigen::Vector4d::Map(turn) = q.normalized();
    }
  }
  return list;
}

}  // namespace

std::vector<Extras::Tolerance> measure_tolerances(Engine& engine) {
  const std::vector<Family> families = {{"boxes", "box", {0.5, 0.3, 0.4}},
                                        {"hulls of 32", "hull", spread_corners(32)},
                                        {"cylinders", "cylinder", {0.4, 0.5}},
                                        {"ellipsoids", "ellipsoid", {0.5, 0.3, 0.4}}};
  std::vector<Extras::Tolerance> found;
  for (const Family& family : families) {
    const carom_shape shape = engine.shape(family.plugin, family.params);
    for (const bool apart : {true, false}) {
      const std::vector<Pair> list = pairs(apart);
      for (int digits = 1; digits <= 13; digits += 2) {
        carom_distance_desc desc;
        Call call;
        call.done(carom_distance_desc_init(&desc, sizeof desc), "describing a query");
        desc.tolerance = std::pow(10, -digits);
        desc.pair_routines = 0;
        double least = 1e300, width = 0;
        for (int repeat = 0; repeat < 5; ++repeat) {
          double sum = 0;
          const double begun = cpu_time();
          for (const Pair& p : list) {
            const double home[3] = {0, 0, 0};
            carom_distance d;
            d.struct_size = sizeof d;
            call.done(carom_shape_distance(engine.get(), shape, home, p.turn_a, shape, p.at, p.turn_b, &desc, &d, call),
                      "measuring distances");
            sum += d.upper - d.lower;
          }
          least = std::min(least, cpu_time() - begun);
          width = sum / static_cast<double>(list.size());
        }
        found.push_back({std::string(family.name) + (apart ? ", apart" : ", deep"), desc.tolerance,
                         1e9 * least / static_cast<double>(list.size()), width});
      }
    }
  }
  return found;
}

std::vector<Extras::Effect> measure_effects(Engine& engine) {
  struct Sample {
    std::string unit;
    std::vector<double> ns;
  };
  std::map<std::string, Sample> samples;
  for (const char* name : {"weather", "falling", "net", "conveyor", "ragdoll"}) {
    Stage stage(engine);
    const Scene& scene = find_scene(name);
    build(scene, {}, stage);
    stage.world.time_effects(true);
    for (int step = 0; step < 60; ++step) {
      stage.world.step(scene.dt);
      if (step < 20) continue;
      for (const carom_plan_line& line : stage.world.plan())
        if (line.effect != CAROM_PLAN_NO_EFFECT && line.runs && line.timing == CAROM_TIME_OWN && line.participants >= 5)
          samples[line.name].unit = line.unit,
          samples[line.name].ns.push_back(1e9 * line.seconds / static_cast<double>(line.participants));
    }
  }
  std::vector<Extras::Effect> effects;
  for (auto& [name, sample] : samples) {
    std::vector<double>& ns = sample.ns;
    std::sort(ns.begin(), ns.end());
    const auto at = [&](double share) {
      return ns[static_cast<std::size_t>(share * static_cast<double>(ns.size() - 1))];
    };
    effects.push_back({name, sample.unit, at(0.5), (at(0.75) - at(0.25)) / 2});
  }
  return effects;
}

std::vector<Extras::Effect> read_effects(const std::string& path) {
  std::istringstream file(read_file(path, "give --effects a file that `effect_costs --csv` wrote"));
  std::vector<Extras::Effect> effects;
  std::string line;
  std::getline(file, line);
  if (!line.starts_with("effect,participants,unit,"))
    throw Error(path + " is no table of effects", "give --effects a file that `effect_costs --csv` wrote");
  while (std::getline(file, line)) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (const char c : line) {
      if (c == '"')
        quoted = !quoted;
      else if (c == ',' && !quoted)
        cells.emplace_back();
      else
        cells.back() += c;
    }
    if (cells.size() < 8) throw Error(path + ": a line has too few cells", "write the file again");
    const double participants = std::max(1.0, std::atof(cells[1].c_str()));
    effects.push_back(
        {cells[0], cells[2], std::atof(cells[4].c_str()), 1e6 * std::atof(cells[7].c_str()) / participants});
  }
  return effects;
}

}  // namespace carom::tools::accuracy
