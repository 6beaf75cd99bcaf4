// What `carom run` says and writes after a run.
#include "cli/run_output.h"

#include <cmath>
#include <cstdio>

#include "cli/table.h"

namespace carom::tools {
namespace {

const char* fault_text(std::uint32_t kind) {
  switch (kind) {
    case CAROM_FAULT_RETURNED:
      return "its support function reported failure";
    case CAROM_FAULT_NOT_FINITE:
      return "its support function gave NaN or infinity";
    case CAROM_FAULT_OUTSIDE:
      return "its support function gave a point outside its bounds";
    case CAROM_FAULT_NOT_SUPPORT:
      return "its support function gave a point worse than one before";
    case CAROM_FAULT_BODY_STATE:
      return "its state was not finite; it is held still";
    case CAROM_FAULT_PARTICLE_STATE:
      return "left the world, first of those that are held still";
    default:
      return "of a kind this program does not know";
  }
}

std::string name_of(const Stage& stage, const carom_fault& fault) {
  for (const Actor& actor : stage.actors)
    if (actor.body == fault.body && actor.particles == fault.particles && actor.index == fault.particle)
      return actor.name;
  return "?";
}

unsigned long long count(std::uint64_t n) { return n; }

}  // namespace

bool run_went_wrong(const RunSummary& run, const std::vector<KindSummary>& kinds) {
  bool wrong = run.faults > 0 || run.last.quarantined_bodies > 0 || run.last.quarantined_particles > 0;
  for (const KindSummary& k : kinds) wrong = wrong || k.escaped || k.not_finite;
  return wrong;
}

namespace {

void print_what_happened(const Stage& stage, const Observer* observer, const RunSummary& run,
                         const std::vector<KindSummary>& kinds) {
  std::printf("\nsimulated %.2f s of world time in %llu steps:\n", run.simulated, count(run.steps));
  if (observer) {
    for (const std::string& line : observer->tell(stage)) std::printf("  %s\n", line.c_str());
    if (!observer->came_off(stage))
      std::printf("  (the scene did not do what it shows: its parameters or dials prevent it)\n");
  }
  std::vector<std::vector<std::string>> rows = {
      {"bodies", "count", "moving", "y min", "y mean", "y max m", "fastest m/s", "escaped", "not finite"}};
  for (const KindSummary& k : kinds)
    rows.push_back({k.kind, format("%zu", k.count), format("%zu", k.moving), format("%.3f", k.low),
                    format("%.3f", k.mean), format("%.3f", k.high), format("%.3f", k.fastest), format("%zu", k.escaped),
                    format("%zu", k.not_finite)});
  std::printf("%s", table(rows, {false, true, true, true, true, true, true, true, true}).c_str());
  std::printf("faults: %llu; in quarantine: %llu bodies, %llu particles\n", count(run.faults),
              count(run.last.quarantined_bodies), count(run.last.quarantined_particles));
  for (std::size_t i = 0; i < std::min<std::size_t>(3, run.first_faults.size()); ++i)
    std::printf("  '%s': %s\n", name_of(stage, run.first_faults[i]).c_str(), fault_text(run.first_faults[i].kind));
  std::printf("contacts at the end: %llu points (most %llu) in %llu islands, from %llu pairs of bounds\n",
              count(run.last.contact_points), count(run.most_contact_points), count(run.last.groups),
              count(run.last.broad_pairs));
  std::printf(
      "errors at the end: penetration max %.3f mm, mean %.3f mm (worst during the run %.1f mm); closing speed "
      "%.4f m/s\n",
      1e3 * run.last.max_penetration, 1e3 * run.last.mean_penetration, 1e3 * run.worst_penetration,
      run.last.max_closing_speed);
  std::printf("kinetic energy at the end: %.4g J linear, %.4g J angular\n", run.last.linear_energy,
              run.last.angular_energy);
  std::printf("state hash: %016llx\n", count(run.hash));
}

/// Of the last step, worst first.
void print_islands(const std::vector<carom_island>& islands) {
  constexpr std::size_t kTold = 5;
  if (islands.empty()) return;
  std::vector<std::vector<std::string>> rows = {
      {"islands", "bodies", "substeps", "of runs", "m/s", "rad/s", "of tolerance", ""}};
  for (std::size_t k = 0; k < std::min(kTold, islands.size()); ++k) {
    const carom_island& i = islands[k];
    const bool joints = i.flags & CAROM_ISLAND_JOINTS_ALONE;
    rows.push_back({format("%zu", k + 1), format("%u", i.bodies), format("%u", i.substeps),
                    format("%llu", count(i.work)), format("%.1e", i.place), format("%.1e", i.turn),
                    format("%.2g", i.share),
                    std::string(joints ? format("by joints alone, order %u", i.order) : "") +
                        (i.flags & CAROM_ISLAND_BOUND ? " bound of work hit" : "") +
                        (i.flags & CAROM_ISLAND_STALLED ? " more substeps do not help" : "")});
  }
  std::printf("errors of islands at the end, worst first of %zu:\n%s", islands.size(),
              table(rows, {false, true, true, true, true, true, true}).c_str());
}

/// What becomes of errors that an accuracy leaves.   @param dt  s
void print_growth(const carom_growth& growth, double dt) {
  if (growth.steps == 0) return;
  std::printf("errors grew %.2g-fold in the first %.3g s", growth.factor, growth.steps * dt);
  if (growth.sensitive)
    std::printf(
        ": chaotic, e-fold every %.2g s. Held is the error that each step adds; places after many e-foldings are a "
        "guess.\n",
        1 / growth.rate);
  else
    std::printf(": not chaotic, the end is off by about the time times the error of islands\n");
}

void print_cost(const RunSummary& run) {
  std::printf("\ncost:\ncomputing time %.3f s for %llu steps (%.1f times real time)\n", run.total_seconds,
              count(run.steps), run.simulated / std::max(run.total_seconds, 1e-9));
  std::printf("steps per second: min %.0f, average %.0f, max %.0f\n\n", run.min_rate, run.average_rate, run.max_rate);
  std::vector<std::vector<std::string>> rows = {{"stage", "ms/step", "share", ""}};
  for (std::size_t i = 0; i < run.stage_seconds.size(); ++i) {
    const double share = run.stage_seconds[i] / std::max(run.total_seconds, 1e-12);
    rows.push_back({carom_stage_name(static_cast<std::uint32_t>(i)),
                    format("%.4f", 1e3 * run.stage_seconds[i] / static_cast<double>(run.steps)),
                    format("%.1f %%", 100 * share), bar(share, 30)});
  }
  std::printf("%s", table(rows, {false, true, true}).c_str());
  if (run.last.direct_groups || run.last.solver_residual > 0)
    std::printf("direct solver: %llu islands at the end, residual %.2g m/s\n", count(run.last.direct_groups),
                run.last.solver_residual);
  if (run.wedged_groups || run.rejected_solutions)
    std::printf(
        "solved otherwise, over the run: %llu islands that surfaces close on, %llu that would have gained energy\n",
        count(run.wedged_groups), count(run.rejected_solutions));
}

}  // namespace

void print_summary(const Stage& stage, const Observer* observer, const RunSummary& run,
                   const std::vector<KindSummary>& kinds) {
  print_what_happened(stage, observer, run, kinds);
  print_islands(stage.world.islands());
  print_growth(run.growth, run.simulated / static_cast<double>(run.steps));
  print_cost(run);
}

nlohmann::json summary_json(const Scene& scene, const Stage& stage, const Observer* observer, const RunSummary& run,
                            const std::vector<KindSummary>& kinds, double dt) {
  nlohmann::json stages = nlohmann::json::object();
  for (std::size_t i = 0; i < run.stage_seconds.size(); ++i)
    stages[carom_stage_name(static_cast<std::uint32_t>(i))] = run.stage_seconds[i];
  nlohmann::json ended = nlohmann::json::array();
  for (const KindSummary& k : kinds)
    ended.push_back({{"kind", k.kind},
                     {"count", k.count},
                     {"moving", k.moving},
                     {"escaped", k.escaped},
                     {"not_finite", k.not_finite},
                     {"y_min_m", k.low},
                     {"y_mean_m", k.mean},
                     {"y_max_m", k.high},
                     {"fastest_m_per_s", k.fastest}});
  nlohmann::json islands = nlohmann::json::array();
  for (const carom_island& i : stage.world.islands())
    islands.push_back({{"bodies", i.bodies},
                       {"substeps", i.substeps},
                       {"work", i.work},
                       {"order", i.order},
                       {"place_m_per_s", i.place},
                       {"turn_rad_per_s", i.turn},
                       {"share", i.share},
                       {"hit_bound", (i.flags & CAROM_ISLAND_BOUND) != 0}});
  nlohmann::json growth = nullptr;
  if (run.growth.steps > 0)
    growth = {{"steps", run.growth.steps},
              {"factor", run.growth.factor},
              {"rate_per_s", run.growth.rate},
              {"sensitive", run.growth.sensitive != 0}};
  nlohmann::json out = {
      {"scene", scene.name},
      {"dt_s", dt},
      {"steps", run.steps},
      {"simulated_s", run.simulated},
      {"computing_s", run.total_seconds},
      {"steps_per_s", {{"min", run.min_rate}, {"average", run.average_rate}, {"max", run.max_rate}}},
      {"stage_s", stages},
      {"bodies", stage.actors.size() - stage.particle_count()},
      {"particles", stage.particle_count()},
      {"contact_points", {{"end", run.last.contact_points}, {"most", run.most_contact_points}}},
      {"penetration_m",
       {{"max", run.last.max_penetration}, {"mean", run.last.mean_penetration}, {"worst", run.worst_penetration}}},
      {"kinetic_energy_j", {{"linear", run.last.linear_energy}, {"angular", run.last.angular_energy}}},
      {"ended", ended},
      {"islands", islands},
      {"growth", growth},
      {"faults", run.faults},
      {"quarantined_bodies", run.last.quarantined_bodies},
      {"quarantined_particles", run.last.quarantined_particles},
      {"hash", format("%016llx", count(run.hash))},
      {"remarks", stage.remarks}};
  if (observer) out["story"] = {{"came_off", observer->came_off(stage)}, {"lines", observer->tell(stage)}};
  return out;
}

CsvFile::CsvFile(const std::string& path) : path_(path), out_(path) {
  if (!out_) throw Error("cannot write " + path, "choose a folder that exists and may be written to");
  out_.imbue(std::locale::classic());
  out_.precision(9);
}

void CsvFile::close() {
  out_.close();
  if (!out_) throw Error("writing " + path_ + " failed", "free space on the disk");
}

void StepTable::add(const carom_step_report& r) {
  std::ofstream& out = file_.out();
  if (!header_) {
    out << "step,time_s,total_s";
    for (std::uint32_t i = 0; i < r.stage_count; ++i) out << ',' << carom_stage_name(i) << "_s";
    out << ",broad_pairs,contact_pairs,contact_points,groups,largest_group,gjk_calls,epa_calls,support_calls,"
           "velocity_impulses,position_moves,faults,max_penetration_m,mean_penetration_m,max_closing_speed_m_per_s,"
           "linear_energy_j,angular_energy_j\n";
    header_ = true;
  }
  out << r.steps << ',' << r.time << ',' << r.total_seconds;
  for (std::uint32_t i = 0; i < r.stage_count; ++i) out << ',' << r.stage_seconds[i];
  for (std::uint64_t n : {r.broad_pairs, r.contact_pairs, r.contact_points, r.groups, r.largest_group, r.gjk_calls,
                          r.epa_calls, r.support_calls, r.velocity_impulses, r.position_moves, r.faults})
    out << ',' << n;
  for (double x : {r.max_penetration, r.mean_penetration, r.max_closing_speed, r.linear_energy, r.angular_energy})
    out << ',' << x;
  out << '\n';
}

void MotionTable::write(const Stage& stage, const Recording& recording) {
  std::ofstream& out = file_.out();
  out << "time_s,body,kind,x_m,y_m,z_m,qx,qy,qz,qw\n";
  for (std::size_t f = 0; f < recording.frame_count(); ++f)
    for (std::size_t a = 0; a < stage.actors.size(); ++a) {
      if (stage.actors[a].type == CAROM_BODY_STATIC) continue;
      out << recording.times()[f] << ',' << stage.actors[a].name << ',' << stage.actors[a].kind;
      for (int i = 0; i < 7; ++i) out << ',' << recording.pose(f, a)[i];
      out << '\n';
    }
  file_.close();
}

}  // namespace carom::tools
