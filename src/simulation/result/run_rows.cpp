#include "simulation/result/run_rows.hpp"

#include "dynamics/drilling/chained_string.hpp"
#include "rotation/rotation_vector.hpp"
#include "simulation/step/wear_step.hpp"

namespace tdbd::simulation {
namespace {

/// The row looks at the angles and speeds given.
HistoryRow row_of(const Case& c, const Simulation& s, const std::vector<double>& cone_angles,
                  const std::vector<double>& cone_speeds) {
  HistoryRow row;
  row.time = time_at(c.time, s.state.steps_done);
  row.p_WB = s.state.place.X_WB.p;
  row.rotation_vector = rotation::log(s.state.place.X_WB.R);
  row.rotation_angle = s.state.place.turned;
  row.removed_volume_total = s.state.ledger.removed.value();
  row.removed_volume_by_part = s.state.cut.removed_by_part;
  row.cone_angles = cone_angles;
  row.cone_speeds = cone_speeds;
  row.sections = s.work.measures.sections;
  row.contacts = s.work.measures.contacts;
  row.swept_vertices = s.state.cut.moved;
  row.rock_triangles = s.state.rock.surface.triangle_count();
  return row;
}

WearRow wear_row(const WearState& s, const WearWork& w) {
  WearRow row;
  row.distance = s.distance;
  for (std::size_t i = 0; i < s.pieces.size(); ++i) {
    if (w.solids[i].cutter < 0) {
      row.lost_height.push_back(w.flats[i].height);
      row.part_volume.push_back(s.pieces[i].volume);
      continue;
    }
    row.width.push_back(w.flats[i].width);
    row.volume.push_back(s.pieces[i].volume);
    row.temperature.push_back(s.rubs[i].temperature);
    row.force.push_back(s.rubs[i].force);
  }
  return row;
}

}  // namespace

std::vector<HistoryPart> history_parts(const bit::Bit& bit) {
  std::vector<HistoryPart> parts;
  for (const bit::Part& p : bit.parts) parts.push_back({p.name, bit::kind_name(p.kind)});
  return parts;
}

HistoryExtent history_extent(const Case& c) {
  HistoryExtent extent;
  extent.cones.reserve(c.bit.cones.size());
  for (const bit::Cone& cone : c.bit.cones) extent.cones.push_back(cone.name);
  extent.contact_areas = c.measure.contact == ContactMeasure::on;
  extent.forces = c.forces.forces == Forces::on;
  extent.drive = c.motion.kind == MotionKind::drilling;
  extent.chain = extent.drive && c.drilling.system.chained.has_value();
  if (extent.chain)
    extent.nodes = node_names(c.drilling.system.chained->chain, c.output.chain.nodes);
  if (wears(c.wear))
    for (const bit::WearSolid& solid : solids_of(c))
      (solid.cutter >= 0 ? extent.worn_cutters : extent.worn_parts).push_back(solid.name);
  if (c.measure.section == SectionMeasure::off) return extent;
  extent.cutters.reserve(c.bit.cutters.size());
  for (const bit::Cutter& cutter : c.bit.cutters) extent.cutters.push_back(cutter_name(cutter));
  return extent;
}

Rows rows_of(const Case& c) {
  return c.output.history_every > 1 ? Rows::of_windows : Rows::of_steps;
}

ChainView chain_view(const Case& c, const Simulation& s) {
  const dynamics::DrillingSystem& system = c.drilling.system;
  return {system.chained->chain, s.state.drive->chain, s.work.drive.chain,
          dynamics::end_motion(system, *s.state.drive, s.work.drive)};
}

void take_step(const Case& of_run, const Simulation& s, History& history) {
  const Case& c = case_now(of_run, s.work);
  const std::vector<double> angles = angles_of(s.state.cones), speeds = speeds_of(s.state.cones);
  HistoryRow row = row_of(c, s, angles, speeds);
  const LoadedStep loaded{s.work.loads,       s.work.velocity,
                          s.state.place.X_WB, s.state.cut.removed_by_part,
                          c.time.step,        s.work.rates};
  if (c.forces.forces == Forces::on) row.loaded = &loaded;
  const DriveRow drive = s.state.drive ? drive_row(c.drilling.system, *s.state.drive, s.work.drive,
                                                   s.state.place.turned)
                                       : DriveRow{};
  if (s.state.drive) row.drive = &drive;
  const WearRow wear = s.work.wear ? wear_row(*s.state.wear, *s.work.wear) : WearRow{};
  if (s.work.wear) row.wear = &wear;
  std::vector<double> nodes;
  if (!c.output.chain.nodes.empty()) append_nodes(chain_view(c, s), c.output.chain.nodes, nodes);
  row.nodes = nodes;
  history.take(row);
}

}  // namespace tdbd::simulation
