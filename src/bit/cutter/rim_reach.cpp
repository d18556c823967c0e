#include "bit/cutter/rim_reach.hpp"

#include <algorithm>
#include <cmath>

#include "bit/cutter/cutter_frame.hpp"
#include "core/angles.hpp"

namespace tdbd::bit {
namespace {

double widest(const std::vector<std::vector<Vec3>>& outlines) {
  double r = 0.0;
  for (const auto& outline : outlines)
    for (const Vec3& p : outline) r = std::max(r, p.x());
  return r;
}

/// The deepest points of a closed outline at the columns' centres.
std::vector<RimReach> reaches(const std::vector<Vec3>& outline, std::size_t columns, double width) {
  std::vector<RimReach> deepest(columns);
  for (std::size_t k = 0; k < outline.size(); ++k) {
    Vec3 a = outline[k], b = outline[(k + 1) % outline.size()];
    if (a.x() > b.x()) std::swap(a, b);
    const auto first = static_cast<std::size_t>(std::ceil(std::max(0.0, a.x() / width - 0.5)));
    for (std::size_t i = first; i < columns; ++i) {
      const double r = (static_cast<double>(i) + 0.5) * width;
      if (r >= b.x()) break;
      const Vec3 p = a + (r - a.x()) / (b.x() - a.x()) * (b - a);
      if (p.z() > deepest[i].z) deepest[i] = {p.z(), p.y()};
    }
  }
  return deepest;
}

}  // namespace

std::vector<Vec3> turned_outline(const Cutter& c, int points) {
  const Vec3 tip = tip_C(c), n_B = profile_normal_B(c);
  std::vector<Vec3> outline;
  for (int k = 0; k < points; ++k) {
    const double a = full_turn * k / points;
    Vec3 x_B = c.X_BC * Vec3(tip.x(), tip.z() * std::sin(a), tip.z() * std::cos(a));
    const double beyond = n_B.dot(x_B - tip_B(c)) + c.wear;
    if (beyond > 0.0) x_B -= beyond * n_B;
    const double azimuth = std::remainder(std::atan2(x_B.y(), x_B.x()) - c.azimuth, full_turn);
    outline.emplace_back(std::hypot(x_B.x(), x_B.y()), c.azimuth + azimuth, x_B.z());
  }
  return outline;
}

RimReaches rim_reaches(const std::vector<Cutter>& cutters, double column_width) {
  std::vector<std::vector<Vec3>> outlines;
  outlines.reserve(cutters.size());
  for (const Cutter& c : cutters) outlines.push_back(turned_outline(c, rim_points));
  const double end = widest(outlines);
  const auto columns = static_cast<std::size_t>(std::ceil(end / column_width));
  RimReaches rims{{}, end / static_cast<double>(columns)};
  rims.of_cutter.reserve(outlines.size());
  for (const auto& outline : outlines)
    rims.of_cutter.push_back(reaches(outline, columns, rims.width));
  return rims;
}

}  // namespace tdbd::bit
