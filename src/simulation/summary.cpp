#include "simulation/summary.hpp"

#include <sys/resource.h>

#include <nlohmann/json.hpp>

#include "core/provenance.hpp"
#include "mesh/files_whole.hpp"

namespace tdbd::simulation {
namespace {

using Json = nlohmann::ordered_json;

/// Grows when a key changes its meaning or goes away.
constexpr int schema = 1;

Json provenance_json(const RunSummary& s) {
  const Provenance& p = provenance();
  return {{"version", p.version}, {"commit", p.commit},       {"compiler", p.compiler},
          {"flags", p.flags},     {"case_hash", s.case_hash}, {"seed", s.seed}};
}

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
          {"maintenance_volume_m3", s.maintenance_volume}};
}

Json rock_json(const RunSummary& s) {
  return {{"rock_triangles_start", s.rock_triangles_start},
          {"rock_triangles_end", s.rock_triangles_end},
          {"rock_quality_min", s.rock_quality_min},
          {"rock_quality_1_percent", s.rock_quality_1_percent},
          {"maintenance", s.maintenance}};
}

}  // namespace

std::string to_json(const RunSummary& s) {
  Json json = {{"schema", schema},
               {"command", s.command},
               {"title", s.title},
               {"status", s.status == RunStatus::completed ? "completed" : "interrupted"}};
  json.update(provenance_json(s));
  json.update(Json{{"steps", s.steps},
                   {"revolutions", s.revolutions},
                   {"duration_s", s.duration},
                   {"gage_radius_m", s.gage_radius}});
  json.update(removed_json(s));
  json.update(rock_json(s));
  return json.dump(2) + "\n";
}

std::string to_json(const Timing& t) {
  const Json json = {{"seconds_per_step_median", t.seconds_per_step_median},
                     {"wall_seconds", t.wall_seconds},
                     {"peak_memory_bytes", t.peak_memory_bytes},
                     {"threads", t.threads}};
  return json.dump(2) + "\n";
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  mesh::WholeFile file(path);
  file.stream() << text;
  file.commit();
}

long peak_memory_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return 1024 * usage.ru_maxrss;
}

}  // namespace tdbd::simulation
