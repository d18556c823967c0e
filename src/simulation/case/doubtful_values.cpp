#include "simulation/case/doubtful_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>

#include "mesh/measures.hpp"

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

/// The narrowest tooth that bears load, m; 0: none.
double narrowest_bearing_tooth(const Case& read) {
  double narrowest = 0.0;
  for (const bit::Part& part : read.bit.parts) {
    if (part.kind != bit::PartKind::tooth || part.cutting != bit::Cutting::cuts) continue;
    const double width = width_of(part);
    if (width > 0.0 && (narrowest == 0.0 || width < narrowest)) narrowest = width;
  }
  return narrowest;
}

/// Errors of tooth forces are of second order in the edge length (reports/studies/contact-forces).
void doubt_tooth_forces(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  constexpr double edges_per_width = 6.0;
  const ForcePlan& forces = read.forces;
  if (forces.forces == Forces::off || !has_law(forces, bit::PartKind::tooth)) return;
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
  return warnings;
}

}  // namespace tdbd::simulation
