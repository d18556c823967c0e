#include "simulation/result/summary.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/provenance.hpp"

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
          {"rock_quality_1_percent", s.rock_quality_1_percent},
          {"maintenance", s.maintenance}};
}

/// A figure over steps, null without any.
template <class Figures>
Json known(const Figures& of, double x) {
  return of.steps > 0 ? Json(x) : Json();
}

Json cones_json(const RunSummary& s) {
  Json cones = Json::array();
  for (const ConeFigures& c : s.cones)
    cones.push_back({{"name", c.name},
                     {"mean_speed_ratio", known(c, c.mean_speed_ratio)},
                     {"min_speed_ratio", known(c, c.min_speed_ratio)},
                     {"max_speed_ratio", known(c, c.max_speed_ratio)},
                     {"std_speed_ratio", known(c, c.std_speed_ratio)},
                     {"rolling_ratio_gage_row", c.rolling_ratio_gage_row},
                     {"net_slip_gage_row", known(c, c.net_slip_gage_row)}});
  return cones;
}

/// Half-widths under the names of the figures, null with a reason where a study does not tell them.
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

Json sections_json(const RunSummary& s) {
  Json faces = Json::array();
  for (const FaceFigures& f : s.faces)
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
  if (s.loads) json.update(to_json(*s.loads));
  if (s.loads && !s.numerical.empty()) json["uncertainty"]["numerical"] = numerical_json(s);
  if (s.drive) {
    json["energy"] = energy_json(*s.drive);
    const std::optional<double>& order = s.drive->order.residual.order;
    json["energy_residual_order"] = order ? Json(*order) : Json();
    json["energy_residual_order_of"] = energy_order_json(s.drive->order);
    json["standing"] = standing_json(s.drive->standing);
    json["diagnosis"] = diagnosis_json(s.diagnosis, s.drive->expected);
  }
  if (s.string) {
    json["string"] = statics_json(*s.string);
    json["string"].update(steps_json(*s.string));
  }
  if (!s.cones.empty()) json["cones"] = cones_json(s);
  if (!s.faces.empty()) json["sections"] = sections_json(s);
  if (!s.faces.empty())
    json["sections_refused"] = {{"deep_in_rock", s.sections_refused_deep},
                                {"over_the_top", s.sections_refused_over_the_top}};
  if (!s.broken_out.empty()) json["broken_out_volume_by_cutter_m3"] = broken_out_json(s);
  if (s.wear) json["wear"] = wear_json(*s.wear);
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

}  // namespace tdbd::simulation
