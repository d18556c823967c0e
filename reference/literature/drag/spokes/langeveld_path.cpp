#include "reference/literature/drag/spokes/langeveld_path.hpp"

#include <cmath>
#include <numbers>

namespace tdbd::reference {

PathRun langeveld_path(const std::vector<SpokeCutter>& cutters, const DragRock& rock,
                       LangeveldRock& bottom, const BitPath& path, const PathOptions& options,
                       CountedRock counted) {
  const PathModel model{bottom.bottom.spokes,
                        [&](std::size_t, int spoke, const PlacedCutter& c) {
                          return cut_rock(bottom, spoke, c.rim, counted);
                        },
                        [&](std::size_t, const CrossingCut& cut, const Vec3& normal_W, const Vec3&,
                            const Vec3& v_W) { return area_force(rock, cut.area, normal_W, v_W); }};
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
                        d.layout.counted);
}

}  // namespace tdbd::reference
