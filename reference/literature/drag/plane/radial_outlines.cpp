#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "reference/literature/drag/drag_input.hpp"
#include "reference/literature/drag/plane/cutter_rim.hpp"
#include "reference/literature/drag/plane/planar_outline.hpp"

namespace tdbd::reference {
namespace {

/// Points of a rotated rim; its sagitta is below 2e-6 of a cutter's radius.
constexpr int turned_points = 1600;

double share_of_turn(double azimuth) {
  const double turns = azimuth / (2 * std::numbers::pi);
  return turns - std::floor(turns);
}

/// (r, z) of the rim's points rotated about the axis, moved back to the flat along the normal.
std::vector<Eigen::Vector2d> turned_rim(const CutterRim& rim) {
  std::vector<Eigen::Vector2d> points;
  points.reserve(turned_points);
  for (int k = 0; k < turned_points; ++k) {
    const double s = 2 * std::numbers::pi * k / turned_points;
    Vec3 x_B = rim.centre_B + std::cos(s) * rim.down_B + std::sin(s) * rim.side_B;
    const double beyond = rim.normal_B.dot(x_B - rim.tip_B) + rim.wear;
    if (rim.wear > 0.0 && beyond > 0.0) x_B -= beyond * rim.normal_B;
    points.emplace_back(std::hypot(x_B.x(), x_B.y()), x_B.z());
  }
  return points;
}

/// Columns with centres in lo <= r <= hi, without depths.
CutterColumns columns_between(const RadialOutlines& all, double lo, double hi) {
  const auto first = static_cast<std::size_t>(std::ceil(std::max(0.0, lo / all.width - 0.5)));
  const auto end = static_cast<std::size_t>(std::floor(std::max(0.0, hi / all.width + 0.5)));
  CutterColumns c;
  c.first = first;
  c.depth.resize(std::min(end, all.columns) - std::min({first, end, all.columns}), no_depth);
  return c;
}

double centre(const RadialOutlines& all, std::size_t column) {
  return (static_cast<double>(column) + 0.5) * all.width;
}

CutterColumns planar_columns(const RadialOutlines& all, const RimEllipse& e) {
  CutterColumns c = columns_between(all, e.x0 - e.half_width, e.reach());
  for (std::size_t k = 0; k < c.depth.size(); ++k)
    c.depth[k] = depth_at(e, centre(all, c.first + k));
  return c;
}

CutterColumns turned_columns(const RadialOutlines& all, const std::vector<Eigen::Vector2d>& rim) {
  const auto [low, high] = std::minmax_element(
      rim.begin(), rim.end(), [](const auto& p, const auto& q) { return p.x() < q.x(); });
  CutterColumns c = columns_between(all, low->x(), high->x());
  for (std::size_t k = 0; k < rim.size(); ++k) {
    Eigen::Vector2d a = rim[k], b = rim[(k + 1) % rim.size()];
    if (a.x() > b.x()) std::swap(a, b);
    const CutterColumns edge = columns_between(all, a.x(), b.x());
    for (std::size_t i = 0; i < edge.depth.size(); ++i) {
      const double z =
          a.y() + (centre(all, edge.first + i) - a.x()) / (b.x() - a.x()) * (b.y() - a.y());
      double& depth = c.depth[edge.first + i - c.first];
      depth = std::max(depth, z);
    }
  }
  return c;
}

/// The columns end at the widest rim.
void divide(RadialOutlines& all, double reach, double column) {
  all.reach = reach;
  all.columns = static_cast<std::size_t>(std::ceil(reach / column * (1.0 - 1e-12)));
  all.width = reach / static_cast<double>(all.columns);
}

void add_planar(RadialOutlines& all, const std::vector<bit::Cutter>& cutters, double column) {
  std::vector<RimEllipse> ellipses;
  ellipses.reserve(cutters.size());
  for (const bit::Cutter& c : cutters)
    ellipses.push_back(
        rim_ellipse(cutter_rim(c, 0.0), Vec3(std::cos(c.azimuth), std::sin(c.azimuth), 0.0)));
  double reach = 0.0;
  for (const RimEllipse& e : ellipses) reach = std::max(reach, e.reach());
  divide(all, reach, column);
  for (const RimEllipse& e : ellipses) all.of_cutter.push_back(planar_columns(all, e));
}

void add_turned(RadialOutlines& all, const std::vector<bit::Cutter>& cutters, double column) {
  std::vector<std::vector<Eigen::Vector2d>> rims;
  rims.reserve(cutters.size());
  for (const bit::Cutter& c : cutters) rims.push_back(turned_rim(cutter_rim(c, c.side_rake)));
  double reach = 0.0;
  for (const auto& rim : rims)
    for (const auto& point : rim) reach = std::max(reach, point.x());
  divide(all, reach, column);
  for (const auto& rim : rims) all.of_cutter.push_back(turned_columns(all, rim));
}

}  // namespace

RadialOutlines radial_outlines(const std::vector<bit::Cutter>& cutters, OutlineForm form,
                               double column) {
  require_cutters("Warren and Sinor", cutters);
  require_positive("Warren and Sinor", "width of columns (m)", column);
  RadialOutlines all;
  form == OutlineForm::planar ? add_planar(all, cutters, column) : add_turned(all, cutters, column);
  for (std::size_t i = 0; i < cutters.size(); ++i)
    all.of_cutter[i].share = share_of_turn(cutters[i].azimuth);
  all.order.resize(cutters.size());
  std::iota(all.order.begin(), all.order.end(), 0);
  std::stable_sort(all.order.begin(), all.order.end(), [&](std::size_t i, std::size_t j) {
    return all.of_cutter[i].share > all.of_cutter[j].share;
  });
  return all;
}

}  // namespace tdbd::reference
