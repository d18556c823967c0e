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

void doubt_edges(const Config& c, const Case& read, std::vector<CaseWarning>& warnings) {
  const double width = narrowest_width(read.bit), edge = read.rock.edge_length;
  if (width == 0.0 || edge <= 0.5 * width) return;
  warnings.push_back(warning(
      c, in_table(rock_keys::table, rock_keys::edge_length),
      fmt::format("edges of {:.3g} mm do not show what a part {:.3g} mm wide cuts; volumes and "
                  "forces mean something with at most half of that",
                  1e3 * edge, 1e3 * width)));
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
    const Vec3 size = mesh::bounding_box(part.mesh_P).size();
    std::array<double, 3> sizes{size.x(), size.y(), size.z()};
    std::ranges::sort(sizes);
    narrowest = std::min(narrowest, sizes[1]);
  }
  return narrowest < std::numeric_limits<double>::infinity() ? narrowest : 0.0;
}

std::vector<CaseWarning> doubtful_values(const Config& c, const Case& read) {
  std::vector<CaseWarning> warnings;
  doubt_edges(c, read, warnings);
  doubt_weight(c, read, warnings);
  return warnings;
}

}  // namespace tdbd::simulation
