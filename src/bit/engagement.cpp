#include "bit/engagement.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "bit/cutter_frame.hpp"

namespace tdbd::bit {
namespace {

constexpr double turn = 2.0 * std::numbers::pi;
constexpr int rim_points = 1440;
constexpr double never = -std::numeric_limits<double>::infinity();

/// Where a cutter's rim is deepest at one radius.
struct Reach {
  double z = never;
  double azimuth = 0.0;
};

double widest(const std::vector<std::vector<Vec3>>& outlines) {
  double r = 0.0;
  for (const auto& outline : outlines)
    for (const Vec3& p : outline) r = std::max(r, p.x());
  return r;
}

/// The deepest points of a closed outline at the columns' centres.
std::vector<Reach> reaches(const std::vector<Vec3>& outline, std::size_t columns, double width) {
  std::vector<Reach> deepest(columns);
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

/// By which share of a revolution `earlier` passes before `c`; the bit turns about +z, so larger
/// azimuths pass first. Those at one azimuth pass in the order of the table.
double share_before(const Reach& earlier, const Reach& c, bool is_listed_before) {
  const double share = (earlier.azimuth - c.azimuth) / turn;
  const double fraction = share - std::floor(share);
  return fraction == 0.0 && !is_listed_before ? 1.0 : fraction;
}

/// Height that cutter c removes in column i.
double height(const std::vector<std::vector<Reach>>& reach, std::size_t c, std::size_t i,
              double advance) {
  const Reach& own = reach[c][i];
  if (own.z == never) return 0.0;
  double h = advance;
  for (std::size_t k = 0; k < reach.size() && h > 0.0; ++k)
    if (k != c && reach[k][i].z != never)
      h = std::min(h, own.z - reach[k][i].z + advance * share_before(reach[k][i], own, k < c));
  return std::max(0.0, h);
}

}  // namespace

std::vector<Vec3> turned_outline(const Cutter& c, int points) {
  const Vec3 tip = tip_C(c), n_B = profile_normal_B(c);
  std::vector<Vec3> outline;
  for (int k = 0; k < points; ++k) {
    const double a = turn * k / points;
    Vec3 x_B = c.X_BC * Vec3(tip.x(), tip.z() * std::sin(a), tip.z() * std::cos(a));
    const double beyond = n_B.dot(x_B - tip_B(c)) + c.wear;
    if (beyond > 0.0) x_B -= beyond * n_B;
    const double azimuth = std::remainder(std::atan2(x_B.y(), x_B.x()) - c.azimuth, turn);
    outline.emplace_back(std::hypot(x_B.x(), x_B.y()), c.azimuth + azimuth, x_B.z());
  }
  return outline;
}

Engagement engagement(const std::vector<Cutter>& cutters, double advance, double column_width) {
  if (cutters.empty()) return {};
  std::vector<std::vector<Vec3>> outlines;
  outlines.reserve(cutters.size());
  for (const Cutter& c : cutters) outlines.push_back(turned_outline(c, rim_points));
  const double end = widest(outlines);
  const auto columns = static_cast<std::size_t>(std::ceil(end / column_width));
  const double width = end / static_cast<double>(columns);
  std::vector<std::vector<Reach>> reach;
  reach.reserve(outlines.size());
  for (const auto& outline : outlines) reach.push_back(reaches(outline, columns, width));
  Engagement e{std::vector<double>(cutters.size()), std::vector<double>(cutters.size()),
               std::vector<int>(columns), width};
  for (std::size_t i = 0; i < columns; ++i)
    for (std::size_t c = 0; c < cutters.size(); ++c) {
      const double h = height(reach, c, i, advance);
      e.area[c] += h * width;
      e.volume[c] += h * width * turn * (static_cast<double>(i) + 0.5) * width;
      e.cutting[i] += h > 0.0;
    }
  return e;
}

}  // namespace tdbd::bit
