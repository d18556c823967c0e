#include "simulation/case/doubtful_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "mesh/measures.hpp"
#include "simulation/case/chain_doubts.hpp"
#include "simulation/case/drilling_keys.hpp"

namespace tdbd::simulation {
namespace {

CaseWarning warning(const Config& c, const std::string& key, const std::string& text) {
  return {c.place(key), key, text};
}

std::string in_table(const TableKey& table, std::string_view key) {
  return fmt::format("{}.{}", table.name, key);
}

/// The middle of a part's three sizes, m; 0 without a mesh.
double width_of(const bit::Part& part) {
  if (part.mesh_P.positions.empty()) return 0.0;
  const Vec3 size = mesh::bounding_box(part.mesh_P).size();
  std::array<double, 3> sizes{size.x(), size.y(), size.z()};
  std::ranges::sort(sizes);
  return sizes[1];
}

void doubt_edges(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  const double width = narrowest_width(read.bit), edge = read.rock.edge_length;
  if (width == 0.0 || edge <= 0.5 * width) return;
  warnings.push_back(warning(
      c, in_table(rock_keys::table, rock_keys::edge_length),
      fmt::format("edges of {:.3g} mm do not show what a part {:.3g} mm wide cuts; volumes and "
                  "forces mean something with at most half of that",
                  1e3 * edge, 1e3 * width)));
}

/// The narrowest tooth with a law, m; 0: none.
double narrowest_bearing_tooth(const Case& read) {
  double narrowest = 0.0;
  for (std::size_t i = 0; i < read.bit.parts.size(); ++i) {
    const bit::Part& part = read.bit.parts[i];
    if (part.kind != bit::PartKind::tooth || part.cutting != bit::Cutting::cuts) continue;
    if (!has_law(read.forces, read.bit, i)) continue;
    const double width = width_of(part);
    if (width > 0.0 && (narrowest == 0.0 || width < narrowest)) narrowest = width;
  }
  return narrowest;
}

/// Errors of tooth forces are of second order in the edge length (reports/studies/contact-forces).
void doubt_tooth_forces(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  constexpr double edges_per_width = 6.0;
  const ForcePlan& forces = read.forces;
  if (forces.forces == Forces::off) return;
  const double width = narrowest_bearing_tooth(read), edge = read.rock.edge_length;
  if (width == 0.0 || edges_per_width * edge <= width) return;
  warnings.push_back(warning(
      c, in_table(rock_keys::table, rock_keys::edge_length),
      fmt::format("edges of {:.3g} mm are coarse for the forces on a tooth {:.3g} mm wide; for "
                  "errors of at most about 5 % use {:.2g} mm",
                  1e3 * edge, 1e3 * width, 1e3 * width / edges_per_width)));
}

/// Nearer than the longest edge, a section crosses triangles that the face has reached already.
void doubt_section_lead(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  const double lead = read.measure.section_lead, longest = read.maintenance.longest_edge;
  const bool has_faces = std::ranges::any_of(read.bit.parts, [](const bit::Part& part) {
    return part.kind == bit::PartKind::face && part.cutting == bit::Cutting::cuts;
  });
  if (!has_faces || read.measure.section == SectionMeasure::off) return;
  if (read.maintenance.every == 0 || lead >= longest) return;
  warnings.push_back(warning(
      c, in_table(measure_keys::table, measure_keys::section_lead.name),
      fmt::format("sections {:.3g} edge lengths ahead are too small where edges are up to {:.3g} "
                  "edge lengths long (maintenance.longest_edge): found {:.3g}, expected at least "
                  "{:.3g}",
                  lead, longest, lead, longest)));
}

void doubt_weight(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  if (read.motion.kind != MotionKind::drilling) return;
  const double most = most_weight_per_diameter * 2.0 * read.bit.gage_radius;
  const std::vector<double>& weights = read.drilling.system.top.load.values;
  const double heaviest = weights.empty() ? 0.0 : std::ranges::max(weights);
  if (heaviest <= most) return;
  warnings.push_back(
      warning(c, in_table(motion_keys::table, motion_keys::weight_on_bit),
              fmt::format("{:.4g} kN on a bit of {:.4g} mm: teeth break at {:.3g} kN (10 klbf per "
                          "inch of diameter)",
                          1e-3 * heaviest, 2e3 * read.bit.gage_radius, 1e-3 * most)));
}

/// The forces along +z with which the string holds a bit off bottom, N: each load less the weight
/// that the hook carries, or the weight alone where an axial spring carries it.
std::vector<double> holding_forces(const dynamics::DrillingSystem& s) {
  const double weight = s.mass * s.gravity;
  if (s.top.axial == dynamics::AxialMode::rate)
    return {s.string.stiffness(2, 2) > 0.0 ? -weight : 0.0};
  std::vector<double> forces = s.top.load.values;
  for (double& f : forces) f -= weight;
  return forces;
}

/// A force F down at a height H above the centre of mass turns a bit that leans by a small angle a
/// with the moment F H a, and bending stiffness turns it back. Lateral springs do not: off bottom the
/// centre of mass moves aside instead.
void doubt_attachment(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  if (read.motion.kind != MotionKind::drilling) return;
  const dynamics::DrillingSystem& s = read.drilling.system;
  const double height = s.centre_B.z() - s.string.attachment_B.z();
  const double bending = s.string.turn_stiffness(0, 0);
  double worst = 0.0;  // N
  for (const double force : holding_forces(s))
    if (force * height > worst * height) worst = force;
  if (worst * height <= bending) return;
  warnings.push_back(warning(
      c, in_table(string_keys::table, string_keys::attachment_height),
      fmt::format(
          "off bottom the bit topples: the string {} it with {:.4g} N at a point {:.4g} mm "
          "{} its centre of mass; found a bending stiffness of {:.4g} N m/rad, expected more "
          "than {:.4g} N m/rad, or the default height",
          worst < 0.0 ? "holds" : "pushes", std::abs(worst), 1e3 * std::abs(height),
          height < 0.0 ? "below" : "above", bending, worst * height)));
}

/// 1/kg: how an impulse along the radius at the ring changes its speed.
double mobility_of_ring(const dynamics::DrillingSystem& s) {
  const double arm = s.wall.ring_z_B - s.centre_B.z();
  const Mat3& turning = s.gyrostat.carrier_inverse_B;
  return 1.0 / s.mass + arm * arm * std::max(turning(0, 0), turning(1, 1));
}

/// Where the bit touches its wall for a few steps, or rolls around it in a few, the step does not
/// resolve the contact. Both limits are those within which the whirling bit of the study whirl-climb
/// advances within 5 % of its limit.
void doubt_wall_step(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  constexpr double steps_per_touch = 10.0, largest_turn = 0.25;  // rad
  const dynamics::DrillingSystem& s = read.drilling.system;
  if (read.motion.kind != MotionKind::drilling || !(s.wall.stiffness > 0.0) || !(s.mass > 0.0))
    return;
  const double h = read.time.step;
  const std::string key = in_table(time_keys::table, time_keys::step);
  const double touch = std::numbers::pi / std::sqrt(s.wall.stiffness * mobility_of_ring(s));
  if (touch < steps_per_touch * h)
    warnings.push_back(warning(
        c, key,
        fmt::format(
            "the bit's impact on the wall lasts {:.2g} ms, {:.2g} steps; resolve it with {} "
            "steps or more: {:.2g} ms",
            1e3 * touch, touch / h, steps_per_touch, 1e3 * touch / steps_per_touch)));
  if (s.wall.friction == 0.0 || s.wall.clearance == 0.0) return;
  const double rolling = read.motion.rotary_speed * s.wall.ring_radius / s.wall.clearance;
  if (h * rolling > largest_turn)
    warnings.push_back(warning(
        c, key,
        fmt::format("a bit that rolls around this wall whirls at {:.3g} Hz, {:.2g} rad in a step; "
                    "rates of a whirling bit are accurate with at most {} rad: {:.2g} ms",
                    rolling / (2.0 * std::numbers::pi), h * rolling, largest_turn,
                    1e3 * largest_turn / rolling)));
}

/// How often the blades of the bit pass at its fastest, Hz; 0 without blades.
double passing_frequency(const Case& read) {
  int blades = 0;
  for (const bit::Cutter& cutter : read.bit.cutters) blades = std::max(blades, cutter.blade);
  const std::vector<double>& speeds = read.drilling.system.top.speed.values;
  const double fastest = speeds.empty() ? 0.0 : std::ranges::max(speeds);
  return blades * fastest / (2.0 * std::numbers::pi);
}

/// The weight on bit of sections as they are ahead leads the bit's axial motion (reports/studies/chatter-onset).
void doubt_sections(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  const bool of_chain = read.motion.kind == MotionKind::drilling && read.drilling.system.chained;
  if (!of_chain || read.bit.cutters.empty() || read.measure.section == SectionMeasure::off ||
      read.measure.section_at_face == rock::SectionAtFace::extrapolated)
    return;
  warnings.push_back(warning(c, in_table(measure_keys::table, measure_keys::section_at_face.name),
                             "\"as_ahead\" damps axial vibrations of the bit, since the weight on "
                             "bit leads its motion: \"extrapolated\" hardly does"));
}

/// Of a string on a chain; where the case gives no hole, it is the one that the bit drills.
void doubt_chain(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  const dynamics::DrillingSystem& s = read.drilling.system;
  if (read.motion.kind != MotionKind::drilling || !s.chained) return;
  const StringPlan& string = read.drilling.string;
  const string::Chain& chain = s.chained->chain;
  const double hole =
      string.hole_diameter > 0.0 ? string.hole_diameter : 2.0 * read.bit.gage_radius;
  std::ranges::move(
      chain_warnings(
          c, {string, chain, static_loads(chain, s.mass * s.gravity, read.drilling.start_motion),
              hole, passing_frequency(read)}),
      std::back_inserter(warnings));
}

}  // namespace

double narrowest_width(const bit::Bit& bit) {
  double narrowest = std::numeric_limits<double>::infinity();
  for (const bit::Part& part : bit.parts) {
    if (part.cutting != bit::Cutting::cuts || part.mesh_P.positions.empty()) continue;
    narrowest = std::min(narrowest, width_of(part));
  }
  return narrowest < std::numeric_limits<double>::infinity() ? narrowest : 0.0;
}

std::vector<CaseWarning> doubtful_values(const Config& c, const Case& read) {
  std::vector<CaseWarning> warnings;
  doubt_edges(c, read, warnings);
  doubt_tooth_forces(c, read, warnings);
  doubt_section_lead(c, read, warnings);
  doubt_weight(c, read, warnings);
  doubt_attachment(c, read, warnings);
  doubt_wall_step(c, read, warnings);
  doubt_chain(c, read, warnings);
  doubt_sections(c, read, warnings);
  return warnings;
}

}  // namespace tdbd::simulation
