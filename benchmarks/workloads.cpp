#include "benchmarks/workloads.hpp"

namespace tdbd::bench {
namespace {

constexpr double mm = 1e-3;
constexpr const char* standard = "standard-workload";

}  // namespace

const std::vector<Workload>& workloads() {
  static const std::vector<std::string> volumes = {"measure.section='off'",
                                                   "measure.contact='off'"};
  static const std::vector<std::string> in_turn = {"measure.section_every=4"};
  static const std::vector<Workload> all = {
      {"standard-1.0", standard, 1.0 * mm, {}, "standard workload 1.0 mm, everything on"},
      {"standard-1.0-in-turn", standard, 1.0 * mm, in_turn, "1.0 mm, sections every 4th step"},
      {"standard-1.0-volumes", standard, 1.0 * mm, volumes, "1.0 mm, volumes only"},
      {"standard-0.7", standard, 0.7 * mm, {}, "0.7 mm, everything on"},
      {"standard-0.7-in-turn", standard, 0.7 * mm, in_turn, "0.7 mm, sections every 4th step"},
      {"standard-0.7-volumes", standard, 0.7 * mm, volumes, "0.7 mm, volumes only"},
      {"drill-bit-b", "drill-bit-b", 1.0 * mm, {}, "`drill-bit-b`, the whole dynamic step"},
      {"drill-bit-r", "drill-bit-r", 1.6 * mm, {}, "`drill-bit-r` (roller cones, 1.6 mm)"},
      {"drill-bit-b-whirl", "drill-bit-b-whirl", 1.5 * mm, {}, "`drill-bit-b-whirl` (1.5 mm)"}};
  return all;
}

const Workload& metre_workload() {
  static const Workload metre{
      "metre", "bit-b-steady", 2.0 * mm, {"rock.trim=0.14"}, "bit B at 2.0 mm under a wall"};
  return metre;
}

const std::vector<ZMapWorkload>& z_map_workloads() {
  static const std::vector<ZMapWorkload> all = {
      {"z-map-1.0", 1.0 * mm, "height field of 1.0 mm cells"},
      {"z-map-0.5", 0.5 * mm, "height field of 0.5 mm cells"},
      {"z-map-0.25", 0.25 * mm, "height field of 0.25 mm cells"}};
  return all;
}

Drilling start_workload(const Workload& w, const std::vector<std::string>& more_settings,
                        long warm_steps) {
  std::vector<std::string> settings = w.settings;
  settings.insert(settings.end(), more_settings.begin(), more_settings.end());
  Drilling d = start_drilling(w.of, w.edge_length, settings);
  drill(d, warm_steps < 0 ? steps_of_a_revolution(d.plan) : warm_steps);
  return d;
}

RivalDrilling<reference::ZMap> start_workload(const ZMapWorkload& w) {
  const simulation::Case plan = read_plan(standard, 1.0 * mm, {});
  RivalDrilling<reference::ZMap> field = start_z_map(plan, w.cell);
  drill(field, steps_of_a_revolution(plan));
  return field;
}

RivalDrilling<reference::Spokes> start_spokes_workload() {
  const simulation::Case plan = read_plan(standard, 1.0 * mm, {});
  RivalDrilling<reference::Spokes> spokes = start_spokes(plan, 120, 500);
  drill(spokes, steps_of_a_revolution(plan));
  return spokes;
}

}  // namespace tdbd::bench
