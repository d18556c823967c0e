#include "simulation/result/summary.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>
#include <numeric>

#include "core/provenance.hpp"
#include "mesh/measures.hpp"

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

Json removed_json(const RunSummary& s) {
  Json by_part = Json::object(), by_part_by_revolution = Json::object();
  for (const PartVolumes& p : s.parts) {
    by_part[p.name] = p.removed;
    by_part_by_revolution[p.name] = p.by_revolution;
  }
  return {{"removed_volume_m3", s.removed_volume},
          {"removed_volume_by_part_m3", by_part},
          {"removed_volume_by_revolution_m3", s.removed_volume_by_revolution},
          {"removed_volume_by_part_by_revolution_m3", by_part_by_revolution},
          {"volume_ledger_defect", s.volume_ledger_defect},
          {"maintenance_volume_m3", s.maintenance_volume},
          {"trimmed_volume_m3", s.trimmed_volume}};
}

Json rock_json(const RunSummary& s) {
  return {{"rock_triangles_start", s.rock_triangles_start},
          {"rock_triangles_end", s.rock_triangles_end},
          {"rock_quality_min", s.rock_quality_min},
          {"rock_quality_1_percent", s.rock_quality_1_percent}};
}

/// Returns a mean over steps, or null if there were no steps.
template <class Figures>
Json known(const Figures& of, double x) {
  return of.steps > 0 ? Json(x) : Json();
}

Json cones_json(const RunSummary& s) {
  Json cones = Json::array();
  for (const ConeSummary& c : s.cones)
    cones.push_back({{"name", c.name},
                     {"mean_speed_ratio", known(c, c.mean_speed_ratio)},
                     {"min_speed_ratio", known(c, c.min_speed_ratio)},
                     {"max_speed_ratio", known(c, c.max_speed_ratio)},
                     {"std_speed_ratio", known(c, c.std_speed_ratio)},
                     {"rolling_ratio_gage_row", c.rolling_ratio_gage_row},
                     {"net_slip_gage_row", known(c, c.net_slip_gage_row)}});
  return cones;
}

/// Half-widths by the names of the results. They are null, with a reason, if a study does not
/// determine them.
Json numerical_json(const RunSummary& s) {
  Json studies = Json::array();
  for (const NumericalUncertainty& u : s.numerical) {
    Json study{{"of", u.keys}};
    for (const auto& [name, half_width] : u.figures) study[name] = half_width;
    if (!u.reason.empty()) study["reason"] = u.reason;
    studies.push_back(study);
  }
  return studies;
}

/// Numbers of events, most of which are 0 in a good run.
Json counters_json(const RunSummary& s) {
  Json counters{{"maintenance", s.maintenance}};
  if (s.drive) counters["implicit_forces"] = implicit_forces_json(s.drive->standing);
  if (!s.faces.empty())
    counters["sections_refused"] = {{"deep_in_rock", s.sections_refused_deep},
                                    {"over_the_top", s.sections_refused_over_the_top}};
  return counters;
}

/// Adds the means of the forces, and whether they are those of a steady state.
void put_loads(const RunSummary& s, Json& json) {
  json.update(to_json(*s.loads));
  if (!s.numerical.empty()) json["uncertainty"]["numerical"] = numerical_json(s);
  json["wob_set_n"] = s.set_weight ? Json(*s.set_weight) : Json();
  json["steady"] = s.steady.is_steady ? Json(*s.steady.is_steady) : Json();
  json["steady_test"] = to_json(s.steady);
}

Json sections_json(const RunSummary& s) {
  Json faces = Json::array();
  for (const FaceSummary& f : s.faces)
    faces.push_back({{"name", f.name},
                     {"mean_area_m2", known(f, f.mean_area)},
                     {"mean_swept_by_section_m3", known(f, f.mean_swept_by_section)},
                     {"mean_removed_volume_m3", known(f, f.mean_removed)},
                     {"rms_swept_by_section", known(f, f.rms_swept_by_section)},
                     {"rms_removed_volume", known(f, f.rms_removed)}});
  return faces;
}

Json broken_out_json(const RunSummary& s) {
  Json by_cutter = Json::object();
  for (const auto& [name, volume] : s.broken_out) by_cutter[name] = volume;
  return by_cutter;
}

std::vector<PartVolumes> part_volumes(const Case& c, const VolumeLedger& l) {
  std::vector<PartVolumes> parts;
  for (std::size_t i = 0; i < c.bit.parts.size(); ++i) {
    PartVolumes p{c.bit.parts[i].name, l.removed_by_part[i].value(), {}};
    for (const auto& revolution : l.removed_by_revolution) p.by_revolution.push_back(revolution[i]);
    parts.push_back(std::move(p));
  }
  return parts;
}

std::map<std::string, long> maintenance_counts(const rock::MaintenanceReport& r) {
  const auto counts = rock::counts(r);
  return {counts.begin(), counts.end()};
}

/// Returns the quantities that studies vary, by dotted key, SI. The time step is the one that is
/// used.
std::map<std::string, double> sizes_of(const Case& c) {
  std::map<std::string, double> sizes = c.quantities;
  sizes["time.step"] = c.time.step;
  return sizes;
}

Figures studied_figures_of(const RunSummary& r) {
  Figures figures{{"wob_mean_n", r.loads->wob.mean},
                  {"tob_mean_n_m", r.loads->tob.mean},
                  {"rop_mean_m_per_s", r.loads->rop.mean},
                  {"rotary_speed_mean_rad_per_s", r.loads->rotary_speed.mean}};
  if (!r.drive) return figures;
  figures["stick_slip_severity"] = r.diagnosis.stick_slip_severity;
  figures["torsional_frequency_hz"] = r.diagnosis.torsional_frequency;
  figures["orbit_radius_m"] = r.diagnosis.orbit_radius;
  figures["orbit_frequency_hz"] = r.diagnosis.orbit_frequency;
  return figures;
}

void add_drive(const Case& c, const Simulation& s, RunSummary& r) {
  const dynamics::DrillingSystem& system = case_now(c, s.work).drilling.system;
  r.diagnosis = diagnose(s.statistics.trace, s.statistics.loads.tob.mean);
  std::map<std::string, double> by_part;
  for (std::size_t i = 0; i < s.statistics.energy_by_part.size(); ++i)
    if (s.statistics.energy_by_part[i] != 0.0)
      by_part[c.bit.parts[i].name] = s.statistics.energy_by_part[i];
  r.drive = {dynamics::stored_energy(system, s.work.drive.at, s.state.drive->state),
             s.state.drive->ledger,
             by_part,
             expected_of(system, r.loads->rotary_speed.mean),
             {},
             s.statistics.standing};
  if (!system.chained) return;
  const string::Chain& chain = system.chained->chain;
  const string::Elements& e = chain.elements;
  const double inertia = system.gyrostat.inertia_B(2, 2);
  r.string = {e.length * chain.count(),
              e.length,
              chain.count(),
              static_loads(chain, system.mass * system.gravity, c.drilling.start_motion),
              chain_modes(chain, system.mass, inertia),
              string::longest_step(chain, system.mass, inertia),
              courant_numbers(c.drilling.string.sections, e.length, c.time.step),
              node_rest_share(chain, s.statistics.node_steps_at_rest, s.state.steps_done)};
}

}  // namespace

Json summary_head(const std::string& command, const std::string& title, RunStatus status,
                  const std::string& case_hash, std::uint64_t seed) {
  const Provenance& p = provenance();
  return {{"schema", summary_schema},
          {"command", command},
          {"title", title},
          {"status", status == RunStatus::completed ? "completed" : "interrupted"},
          {"version", p.version},
          {"commit", p.commit},
          {"compiler", p.compiler},
          {"flags", p.flags},
          {"case_hash", case_hash},
          {"seed", seed}};
}

std::string to_json(const RunSummary& s) {
  Json json = summary_head(s.command, s.title, s.status, s.case_hash, s.seed);
  if (!s.warnings.empty()) json["warnings"] = s.warnings;
  json.update(Json{{"steps", s.steps},
                   {"revolutions", s.revolutions},
                   {"duration_s", s.duration},
                   {"gage_radius_m", s.gage_radius}});
  json.update(removed_json(s));
  json.update(rock_json(s));
  if (s.loads) put_loads(s, json);
  if (s.drive) {
    json["energy"] = energy_json(*s.drive);
    const std::optional<double>& order = s.drive->order.residual.order;
    json["energy_residual_order"] = order ? Json(*order) : Json();
    json["energy_residual_order_of"] = energy_order_json(s.drive->order);
    json["diagnosis"] = diagnosis_json(s.diagnosis, s.drive->expected);
  }
  if (s.string) {
    json["string"] = statics_json(*s.string);
    json["string"].update(steps_json(*s.string));
  }
  if (!s.cones.empty()) json["cones"] = cones_json(s);
  if (!s.faces.empty()) json["sections"] = sections_json(s);
  if (!s.broken_out.empty()) json["broken_out_volume_by_cutter_m3"] = broken_out_json(s);
  if (s.wear) json["wear"] = wear_json(*s.wear);
  json["counters"] = counters_json(s);
  return json.dump(2) + "\n";
}

std::string to_json(const Timing& t) {
  const Json json = {{"seconds_per_step_median", t.seconds_per_step_median},
                     {"seconds_per_step_mean", t.seconds_per_step_mean},
                     {"wall_seconds", t.wall_seconds},
                     {"peak_memory_bytes", t.peak_memory_bytes},
                     {"threads", t.threads}};
  return json.dump(2) + "\n";
}

Timing timing_of(std::vector<double> step_seconds, double wall_seconds, int threads) {
  Timing t;
  t.wall_seconds = wall_seconds;
  t.peak_memory_bytes = peak_memory_bytes();
  t.threads = threads;
  if (step_seconds.empty()) return t;
  const double sum = std::accumulate(step_seconds.begin(), step_seconds.end(), 0.0);
  t.seconds_per_step_mean = sum / static_cast<double>(step_seconds.size());
  const auto middle = step_seconds.begin() + static_cast<std::ptrdiff_t>(step_seconds.size() / 2);
  std::nth_element(step_seconds.begin(), middle, step_seconds.end());
  t.seconds_per_step_median = *middle;
  return t;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::string failure_text(long steps_done, long steps, double t, const std::string& what) {
  return fmt::format("failed after {} of {} steps, at t = {} s: {}", steps_done, steps, t, what);
}

long peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * usage.ru_maxrss;
}

RunSummary summary_of(const Case& c, const Simulation& s, RunStatus status) {
  RunSummary r;
  r.command = "run";
  r.title = c.title;
  r.status = status;
  r.case_hash = c.hash;
  r.warnings = texts_of_result(c.warnings);
  r.found_at_end = end_warnings(c, s);
  for (const CaseWarning& w : r.found_at_end) r.warnings.push_back(without_place(w));
  const double from = time_at(c.time, c.time.first), to = time_at(c.time, s.state.steps_done);
  r.steps = s.state.steps_done - c.time.first;
  r.duration = to - from;
  r.revolutions = (s.state.place.turned - s.state.start_turned) / (2.0 * std::numbers::pi);
  r.removed_volume = s.state.ledger.removed.value();
  for (const auto& revolution : s.state.ledger.removed_by_revolution)
    r.removed_volume_by_revolution.push_back(
        std::accumulate(revolution.begin(), revolution.end(), 0.0));
  r.parts = part_volumes(c, s.state.ledger);
  r.volume_ledger_defect = ledger_defect(s);
  r.maintenance_volume = s.state.maintenance.volume_change;
  r.trimmed_volume = s.state.ledger.trimmed.value();
  r.rock_triangles_start = s.state.start_triangles;
  r.rock_triangles_end = s.state.rock.surface.triangle_count();
  const mesh::QualityStatistics quality = mesh::quality_statistics(s.state.rock.surface);
  r.rock_quality_min = quality.least;
  r.rock_quality_1_percent = quality.one_percent;
  r.gage_radius = c.bit.gage_radius;
  r.maintenance = maintenance_counts(s.state.maintenance);
  r.faces = summarize(c.bit, s.statistics.faces);
  if (c.forces.forces == Forces::on) {
    r.loads = summarize(c.bit, s.statistics.loads, to);
    r.loads->uncertainty = sampling_of(s.statistics.trace);
    r.set_weight = set_weight(c, r.loads->from, r.loads->to);
    r.steady = steady_state(s.statistics.trace);
  }
  if (s.state.drive) add_drive(c, s, r);
  if (r.loads && r.loads->steps > 0)
    for (const StudiedConvergence& study : c.output.convergence)
      r.numerical.push_back(numerical_uncertainty(study, sizes_of(c), studied_figures_of(r)));
  if (s.work.wear) r.wear = figures_of_wear(c, s);
  if (s.state.spalling)
    for (std::size_t i = 0; i < c.bit.cutters.size(); ++i)
      r.broken_out.emplace_back(cutter_name(c.bit.cutters[i]),
                                s.state.spalling->broken_out[i].value());
  r.sections_refused_deep = s.statistics.faces.refused_deep;
  r.sections_refused_over_the_top = s.statistics.faces.refused_over_the_top;
  for (std::size_t k = 0; k < s.state.cones.size(); ++k)
    r.cones.push_back(summarize(c.bit.cones[k], s.state.cones[k], s.statistics.cones[k]));
  return r;
}

}  // namespace tdbd::simulation
