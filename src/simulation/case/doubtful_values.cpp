#include "simulation/case/doubtful_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <optional>

#include "mesh/measures.hpp"
#include "rotation/screw.hpp"
#include "simulation/case/read_chain.hpp"

namespace tdbd::simulation {
namespace {

/// Something that a step must not jump over.
struct Obstacle {
  const bit::Part* part;
  Vec3 middle_B;
  double size;  ///< m
};

std::vector<Obstacle> cutting_parts(const bit::Bit& bit) {
  std::vector<Obstacle> parts;
  for (const bit::Part& part : bit.parts) {
    if (final_cutting(part) != bit::Cutting::cuts || part.mesh_P.positions.empty()) continue;
    const mesh::Box box_P = mesh::bounding_box(part.mesh_P);
    parts.push_back({&part, part.X_BP * (0.5 * (box_P.lo + box_P.hi)), box_P.size().norm()});
  }
  return parts;
}

/// The largest distance (m) that the middle of the part moves in a step.
double jump(const Speeds& s, const Obstacle& o, double dt) {
  return dt * (s.shift + s.w_B.cross(o.middle_B).norm() + s.swing * o.middle_B.norm());
}

/// Describes a step that is too long for one piece of the motion: found and expected.
std::optional<std::pair<std::string, std::string>> fault(const Speeds& s, double dt,
                                                         const std::vector<Obstacle>& parts) {
  constexpr double largest_turn = 0.5;  // rad
  if (s.w_B.norm() * dt > largest_turn)
    return std::pair(fmt::format("a turn of {:.3g} rad in one step", s.w_B.norm() * dt),
                     fmt::format("at most {} rad", largest_turn));
  for (const Obstacle& o : parts)
    if (const double far = jump(s, o, dt); far > o.size)
      return std::pair(
          fmt::format("a jump of {:.3g} mm of {} in one step of {} s", 1e3 * far, o.part->name, dt),
          fmt::format("at most the part's size, {:.3g} mm: a shorter time.step or a slower motion",
                      1e3 * o.size));
  return std::nullopt;
}

double over(double x, double ramp) { return ramp > 0.0 ? x / ramp : 0.0; }

std::vector<Speeds> speeds_on(const std::vector<PathPoint>& path) {
  std::vector<Speeds> speeds;
  for (std::size_t i = 1; i < path.size(); ++i) {
    const PathPoint &a = path[i - 1], &b = path[i];
    const double dt = b.time - a.time;
    const Vec3 turn =
        rotation::log(rotation::exp(a.rotation_WB).transpose() * rotation::exp(b.rotation_WB));
    speeds.push_back({(b.p_WB - a.p_WB).norm() / dt, turn / dt, 0.0, b.line});
  }
  return speeds;
}

CaseWarning warning(const Config& c, const std::string& key, const std::string& text) {
  return {c.place(key), key, text};
}

/// The middle one of the three sizes of a part's box, m; 0 without a mesh.
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
  warnings.push_back(
      warning(c, "rock.edge_length",
              fmt::format("edges of {:.3g} mm do not resolve the cuts of a part {:.3g} mm wide; "
                          "for meaningful volumes and forces use at most half of that",
                          1e3 * edge, 1e3 * width)));
}

/// The width (m) of the narrowest tooth with a law; 0 without one.
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
      c, "rock.edge_length",
      fmt::format("edges of {:.3g} mm are coarse for the forces on a tooth {:.3g} mm wide; for "
                  "errors of at most about 5 % use {:.2g} mm",
                  1e3 * edge, 1e3 * width, 1e3 * width / edges_per_width)));
}

/// A section closer than the longest edge crosses triangles that the face has already reached.
void doubt_section_lead(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  const double lead = read.measure.section_lead, longest = read.maintenance.longest_edge;
  const bool has_faces = std::ranges::any_of(read.bit.parts, [](const bit::Part& part) {
    return part.kind == bit::PartKind::face && part.cutting == bit::Cutting::cuts;
  });
  if (!has_faces || read.measure.section == SectionMeasure::off) return;
  if (read.maintenance.every == 0 || lead >= longest) return;
  warnings.push_back(warning(
      c, "measure.section_lead",
      fmt::format("sections {:.3g} edge lengths ahead are too small where edges are up to {:.3g} "
                  "edge lengths long (maintenance.longest_edge): found {:.3g}, expected at least "
                  "{:.3g}",
                  lead, longest, lead, longest)));
}

/// A mean over no steps has no value. The last step counts if it ends after means_from.
void doubt_means(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  constexpr double rounding = 1e-9;
  const double end = read.time.step * static_cast<double>(read.time.steps);
  const double from = read.output.means_from;
  if (from < end * (1.0 - rounding)) return;
  warnings.push_back(warning(
      c, "output.means_from",
      fmt::format(
          "means begin at {:.6g} s and the run ends at {:.6g} s: all means will have no value "
          "(null); use less than {:.6g} s, or a longer run",
          from, end, end)));
}

void doubt_rate(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  if (!(read.motion.rate_of_penetration < 0.0)) return;
  warnings.push_back(warning(c, "motion.rate_of_penetration",
                             "a negative rate moves the bit up, away from the bottom of the hole"));
}

void doubt_weight(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  if (read.motion.kind != MotionKind::drilling) return;
  const double most = most_weight_per_diameter * 2.0 * read.bit.gage_radius;
  const std::vector<double>& weights = read.drilling.system.top.load.values;
  const double heaviest = weights.empty() ? 0.0 : std::ranges::max(weights);
  if (heaviest <= most) return;
  warnings.push_back(
      warning(c, "motion.weight_on_bit",
              fmt::format("{:.4g} kN on a bit of {:.4g} mm: teeth break at {:.3g} kN (10 klbf per "
                          "inch of diameter)",
                          1e-3 * heaviest, 2e3 * read.bit.gage_radius, 1e-3 * most)));
}

/// The forces along +z (N) with which the string holds a bit off bottom: each load minus the weight
/// that the hook carries, or only the weight if an axial spring carries it.
std::vector<double> holding_forces(const dynamics::DrillingSystem& s) {
  const double weight = s.mass * s.gravity;
  if (s.top.axial == dynamics::AxialMode::rate)
    return {s.string.stiffness(2, 2) > 0.0 ? -weight : 0.0};
  std::vector<double> forces = s.top.load.values;
  for (double& f : forces) f -= weight;
  return forces;
}

/// A downward force F at a height H above the centre of mass turns a bit that leans by a small
/// angle a with the moment F H a. Bending stiffness turns it back. Lateral springs do not: off
/// bottom the centre of mass moves sideways instead.
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
      c, "string.attachment_height",
      fmt::format(
          "off bottom the bit topples: the string {} it with {:.4g} N at a point {:.4g} mm "
          "{} its centre of mass; found a bending stiffness of {:.4g} N m/rad, expected more "
          "than {:.4g} N m/rad, or the default height",
          worst < 0.0 ? "holds" : "pushes", std::abs(worst), 1e3 * std::abs(height),
          height < 0.0 ? "below" : "above", bending, worst * height)));
}

/// 1/kg: change of speed by a unit impulse along the radius at the ring.
double mobility_of_ring(const dynamics::DrillingSystem& s) {
  const double arm = s.wall.ring_z_B - s.centre_B.z();
  const Mat3& turning = s.gyrostat.carrier_inverse_B;
  return 1.0 / s.mass + arm * arm * std::max(turning(0, 0), turning(1, 1));
}

/// If the bit touches its wall for only a few steps, or rolls around it in a few, the step does not
/// resolve the contact. Within both limits, the whirling bit of the study whirl-climb advances
/// within 5 % of its limit.
void doubt_wall_step(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  constexpr double steps_per_touch = 10.0, largest_turn = 0.25;  // rad
  const dynamics::DrillingSystem& s = read.drilling.system;
  if (read.motion.kind != MotionKind::drilling || !(s.wall.stiffness > 0.0) || !(s.mass > 0.0))
    return;
  const double h = read.time.step;
  const std::string key = "time.step";
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

/// The frequency (Hz) at which the blades of the bit pass at its highest speed; 0 without blades.
double passing_frequency(const Case& read) {
  int blades = 0;
  for (const bit::Cutter& cutter : read.bit.cutters) blades = std::max(blades, cutter.blade);
  const std::vector<double>& speeds = read.drilling.system.top.speed.values;
  const double fastest = speeds.empty() ? 0.0 : std::ranges::max(speeds);
  return blades * fastest / (2.0 * std::numbers::pi);
}

/// The weight on bit that follows from sections ahead of the faces leads the bit's axial motion
/// (reports/studies/chatter-onset).
void doubt_sections(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  const bool of_chain = read.motion.kind == MotionKind::drilling && read.drilling.system.chained;
  if (!of_chain || read.bit.cutters.empty() || read.measure.section == SectionMeasure::off ||
      read.measure.section_at_face == rock::SectionAtFace::extrapolated)
    return;
  warnings.push_back(warning(c, "measure.section_at_face",
                             "\"as_ahead\" damps axial vibrations of the bit, because the weight "
                             "on bit leads its motion; \"extrapolated\" hardly does"));
}

/// For a string on a chain. If the case gives no hole, it is the hole that the bit drills.
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

std::vector<Speeds> speeds_of(const Motion& m) {
  if (has_path(m)) return speeds_on(m.path);
  return {{std::abs(m.rate_of_penetration) +
               m.whirl.radius * (m.whirl.frequency + over(1.0, m.whirl.ramp)),
           m.rotary_speed * Vec3::UnitZ(),
           m.tilt.angle * (m.tilt.frequency + over(1.0, m.tilt.ramp)), 0}};
}

void check_step_length(Config& c, const Case& read) {
  if (c.problem_count() > 0) return;
  const std::vector<Obstacle> parts = cutting_parts(read.bit);
  for (const Speeds& s : speeds_of(read.motion)) {
    const auto wrong = fault(s, read.time.step, parts);
    if (!wrong) continue;
    const auto& [found, expected] = *wrong;
    if (s.line == 0) return c.table(TimeSettings::table).problem("step", found, expected);
    return c.other_file(fmt::format("{}:{}: time_s: found {}, expected {}", read.motion.path_file,
                                    s.line, found, expected));
  }
}

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
  doubt_means(c, read, warnings);
  doubt_rate(c, read, warnings);
  doubt_weight(c, read, warnings);
  doubt_attachment(c, read, warnings);
  doubt_wall_step(c, read, warnings);
  doubt_chain(c, read, warnings);
  doubt_sections(c, read, warnings);
  return warnings;
}

}  // namespace tdbd::simulation
