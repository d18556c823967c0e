#include "reference/literature/drag/spokes/langeveld_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace tdbd::reference {

double tip_depth(const LangeveldRock& rock, int spoke, double radius, double z) {
  const Spokes& bottom = rock.bottom;
  const auto node = static_cast<int>(radius / bottom.node_spacing() - 0.5);
  if (node >= bottom.nodes) return 0.0;
  const auto depth_of = [&](int i) {
    return bottom
        .depth[static_cast<std::size_t>(spoke) * static_cast<std::size_t>(bottom.nodes) + at(i)];
  };
  const int outer = std::max(node, 1), inner = outer - 1;
  const double share = (radius - bottom.node_radius(inner)) / bottom.node_spacing();
  return std::max(0.0, z - std::lerp(depth_of(inner), depth_of(outer), share));
}

std::vector<double> tip_widths(const std::vector<SpokeCutter>& cutters) {
  constexpr double same = 1e-6;  // m
  std::vector<double> radii, distinct, widths;
  for (const SpokeCutter& c : cutters) radii.push_back(std::hypot(c.tip_B.x(), c.tip_B.y()));
  distinct = radii;
  std::ranges::sort(distinct);
  distinct.erase(std::unique(distinct.begin(), distinct.end(),
                             [](double a, double b) { return b - a < same; }),
                 distinct.end());
  for (const double r : radii) {
    const auto next = std::ranges::upper_bound(distinct, r + same);
    const auto own = next - 1;
    const double lo = own == distinct.begin() ? 0.0 : (*own + *(own - 1)) / 2.0,
                 hi = next == distinct.end() ? *own : (*own + *next) / 2.0;
    widths.push_back(hi - lo);
  }
  return widths;
}

void require_widths(std::size_t found, std::size_t cutters) {
  if (found != cutters)
    throw InputError("Langeveld: found " + std::to_string(found) +
                     " widths of cutters; the law of tips needs one for each of " +
                     std::to_string(cutters));
}

PathRun langeveld_path(const std::vector<SpokeCutter>& cutters, const DragRock& rock,
                       LangeveldRock& bottom, const BitPath& path, const PathOptions& options,
                       const LangeveldContact& contact) {
  const bool by_tip = contact.law == LangeveldLaw::tip;
  if (by_tip) require_widths(contact.widths.size(), cutters.size());
  const PathModel model{bottom.bottom.spokes,
                        [&](std::size_t, int spoke, const PlacedCutter& c) {
                          const double depth = tip_depth(bottom, spoke, c.radius, c.tip_W.z());
                          CrossingCut cut = cut_rock(bottom, spoke, c.rim, contact.counted);
                          cut.depth = depth;
                          return cut;
                        },
                        [&](std::size_t i, const CrossingCut& cut, const Vec3& normal_W,
                            const Vec3&, const Vec3& v_W) {
                          const double felt = by_tip ? contact.widths[i] * cut.depth : cut.area;
                          return area_force(rock, felt, normal_W, v_W);
                        },
                        by_tip ? ForceAt::tip : ForceAt::middle_of_area};
  return follow(path, cutters, model, options);
}

PathRun langeveld_steady(const std::vector<bit::Cutter>& cutters, const DragRock& rock,
                         const LangeveldDrilling& d) {
  check_drilling({d.rotary_speed, d.advance, d.revolutions, d.step, d.layout.spokes}, "Langeveld");
  const std::vector<SpokeCutter> rims = spoke_cutters(cutters, "Langeveld");
  double highest = 0.0;
  for (const SpokeCutter& c : rims) highest = std::max(highest, -c.centre_B.z());
  LangeveldRock bottom = fitting_rock(rims, 0.0, -highest, d.layout.spokes, d.layout.nodes);
  PathOptions options;
  options.step = d.step;
  options.duration = d.revolutions * 2.0 * std::numbers::pi / std::abs(d.rotary_speed);
  return langeveld_path(rims, rock, bottom, steady_path(d.rotary_speed, d.advance), options,
                        {d.layout.counted});
}

}  // namespace tdbd::reference
