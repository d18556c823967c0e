#include "simulation/result/history.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/error.hpp"
#include "dynamics/drilling/chained_string.hpp"
#include "rotation/screw.hpp"
#include "simulation/step/wear_step.hpp"

namespace tdbd::simulation {
namespace {

bool is_of_nodes(const RecordLayout& layout, const RecordColumn& c) {
  return c.axis >= 0 && layout.axes[at(c.axis)].name == "node";
}

/// Whether a row of many steps also contains the minimum and maximum of a column: true for means of
/// the bit as a whole and of the string's nodes.
bool has_extremes(const RecordLayout& layout, const RecordColumn& c) {
  return (c.axis < 0 || is_of_nodes(layout, c)) && c.over == Over::mean;
}

std::string since_last_row(std::string long_name) {
  const std::string step = "in the step";
  if (const auto at = long_name.find(step); at != std::string::npos)
    long_name.replace(at, step.size(), "since the last row");
  return long_name;
}

/// Whether a column is stored in single precision in long runs. Most numbers of a row belong to
/// parts and cutters. Angles of cones become large and need all digits.
bool takes_much_room(const RecordLayout& layout, const RecordColumn& c) {
  return c.axis >= 0 && layout.axes[at(c.axis)].name != "cone" && !is_of_nodes(layout, c);
}

/// Returns the columns of rows that represent many steps, or one.
RecordLayout row_layout(RecordLayout layout, Rows rows) {
  const std::vector<RecordColumn> of_step = layout.columns;
  for (RecordColumn& c : layout.columns) {
    if (rows == Rows::of_steps) c.over = Over::point;
    if (rows == Rows::of_windows) c.long_name = since_last_row(c.long_name);
    if (rows == Rows::of_windows && takes_much_room(layout, c)) c.precision = Precision::single;
  }
  if (rows == Rows::of_steps) return layout;
  layout.storage = Storage::deflated;
  for (const RecordColumn& c : of_step) {
    if (!has_extremes(layout, c)) continue;
    layout.columns.push_back(
        {c.name + "_min", c.units, c.long_name + ", least", c.axis, c.csv, Over::minimum});
    layout.columns.push_back(
        {c.name + "_max", c.units, c.long_name + ", greatest", c.axis, c.csv, Over::maximum});
  }
  return layout;
}

/// Calls visit(column, first number, count) for every column.
template <class Visit>
void visit_columns(const RecordLayout& layout, Visit&& visit) {
  std::size_t first = 0;
  for (const RecordColumn& c : layout.columns) {
    const std::size_t count = layout.width(c);
    visit(c, first, count);
    first += count;
  }
}

void take_up(const std::vector<double>& step, HistoryWindow& w) {
  if (w.steps++ == 0) {
    w.sum = w.least = w.greatest = step;
    return;
  }
  for (std::size_t i = 0; i < step.size(); ++i) {
    w.sum[i] += step[i];
    w.least[i] = std::fmin(w.least[i], step[i]);  // NaN is ignored
    w.greatest[i] = std::fmax(w.greatest[i], step[i]);
  }
}

/// Computes the row of a window. `last`: the values of its last step.
void row_of_window(const RecordLayout& steps, const std::vector<double>& last,
                   const HistoryWindow& w, std::vector<double>& row) {
  row = last;
  visit_columns(steps, [&](const RecordColumn& c, std::size_t first, std::size_t count) {
    for (std::size_t i = first; i < first + count; ++i) {
      if (c.over == Over::sum) row[i] = w.sum[i];
      if (c.over == Over::mean) row[i] = w.sum[i] / static_cast<double>(w.steps);
    }
  });
  visit_columns(steps, [&](const RecordColumn& c, std::size_t first, std::size_t count) {
    if (!has_extremes(steps, c)) return;
    for (const std::vector<double>* all : {&w.least, &w.greatest}) {
      const auto from = all->begin() + static_cast<std::ptrdiff_t>(first);
      row.insert(row.end(), from, from + static_cast<std::ptrdiff_t>(count));
    }
  });
}

/// The returned row refers to the given angles and speeds, which must outlive it.
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

History::History(const std::filesystem::path& path, const std::vector<HistoryPart>& parts,
                 const HistoryExtent& extent, Rows rows)
    : extent_(extent),
      rows_(rows),
      steps_(step_layout(parts, extent)),
      layout_(row_layout(steps_, rows)),
      record_(path, layout_) {}

void History::take(const HistoryRow& step) {
  numbers_of(step, extent_, window_.last);
  if (window_.last.size() != steps_.row_width())
    throw RunError(fmt::format("a step of {} numbers in a history of {}", window_.last.size(),
                               steps_.row_width()));
  if (rows_ == Rows::of_windows)
    take_up(window_.last, window_);
  else
    window_.steps = 1;
}

bool History::write() {
  if (window_.steps == 0) return false;
  if (rows_ == Rows::of_windows)
    row_of_window(steps_, window_.last, window_, row_);
  else
    row_ = window_.last;
  window_.steps = 0;
  record_.append(row_);
  return true;
}

void History::close() { record_.close(); }

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
