#include "reference/literature/drag/spokes/hanson_hansen_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "reference/literature/drag/spokes/langeveld_rock.hpp"
#include "reference/literature/drag/spokes/outline_cut.hpp"
#include "reference/literature/drag/spokes/rim_polygon.hpp"
#include "reference/literature/surface/planar_boolean.hpp"

namespace tdbd::reference {
namespace {

constexpr double sliver = 1e-12;       // m2
constexpr double deepest_rock = 1.95;  // m: planar_boolean is limited to 2 m

/// The rock below a bottom that is given by depths in fine columns.
PlanarFace face_below(const Spokes& bottom, double top, const SpokeFrame& frame) {
  PlanarFace face;
  Outline& border = face.border;
  border.push_back(on_grid({0.0, bottom.depth.front()}));
  for (int j = 0; j < bottom.nodes; ++j)
    border.push_back(on_grid({bottom.node_radius(j), bottom.depth[at(j)]}));
  border.push_back(on_grid({bottom.radius, bottom.depth.back()}));
  border.push_back(on_grid({bottom.radius, top}));
  border.push_back(on_grid({frame.radius, top}));
  border.push_back({frame.radius, frame.floor});
  border.push_back({0.0, frame.floor});
  return face;
}

double highest_centre(const std::vector<SpokeCutter>& cutters) {
  double highest = 0.0;
  for (const SpokeCutter& c : cutters) highest = std::max(highest, -c.centre_B.z());
  return highest;
}

}  // namespace

OutlineSpokes fitting_outline_rock(const std::vector<SpokeCutter>& cutters, double depth,
                                   const HansonHansenLayout& layout, double around) {
  constexpr int columns = 1000;
  constexpr double below = 30e-3;  // m of rock below the final bottom
  const double top = -highest_centre(cutters);
  const LangeveldRock fine = fitting_rock(cutters, 0.0, top, 1, columns);
  if (!(depth + below < deepest_rock))
    throw InputError("Hanson and Hansen: found " + std::to_string(depth) +
                     " m to drill; spokes with several z reach 1.9 m");
  const Vec2 corner = on_grid({fine.bottom.radius + around, depth + below});
  const SpokeFrame frame{corner.x(), corner.y()};
  const PlanarFace face = respaced(face_below(fine.bottom, top, frame), frame, layout.spacing);
  return {frame, layout.spacing, std::vector<PlanarFace>(at(layout.spokes), face)};
}

CrossingCut cut_outline(OutlineSpokes& rock, int spoke, const RimEllipse& rim) {
  const RimPolygon polygon = rim_polygon(rim);
  const CrossingCut cut = rim_in_face(polygon, rock.rock[at(spoke)]);
  if (cut.area <= sliver) return cut;
  thread_local Outline tool;  // reused to avoid allocations
  outline_of(polygon, tool);
  for (Vec2& x : tool) x = on_grid(x);
  cut_convex(rock, spoke, tool);
  return cut;
}

PathRun hanson_hansen_path(const std::vector<SpokeCutter>& cutters, const HansonHansenRock& rock,
                           OutlineSpokes& bottom, const BitPath& path, const PathOptions& options) {
  const PathModel model{bottom.spokes(),
                        [&](std::size_t, int spoke, const PlacedCutter& c) {
                          return cut_outline(bottom, spoke, c.rim);
                        },
                        [&](std::size_t i, const CrossingCut& cut, const Vec3& normal_W,
                            const Vec3& face_W, const Vec3& v_W) {
                          return hanson_hansen_force(rock, cutters[i], cut, normal_W, face_W, v_W);
                        }};
  return follow(path, cutters, model, options);
}

PathRun hanson_hansen_steady(const std::vector<bit::Cutter>& cutters, const HansonHansenRock& rock,
                             const HansonHansenDrilling& d) {
  check_drilling({d.rotary_speed, d.advance, d.revolutions, d.step, d.layout.spokes},
                 "Hanson and Hansen");
  const std::vector<SpokeCutter> rims = spoke_cutters(cutters, "Hanson and Hansen");
  OutlineSpokes bottom = fitting_outline_rock(rims, d.advance * d.revolutions, d.layout);
  PathOptions options;
  options.step = d.step;
  options.duration = d.revolutions * 2.0 * std::numbers::pi / std::abs(d.rotary_speed);
  return hanson_hansen_path(rims, rock, bottom, steady_path(d.rotary_speed, d.advance), options);
}

}  // namespace tdbd::reference
