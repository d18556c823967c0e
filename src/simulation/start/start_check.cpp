#include "simulation/start/start_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

double cross(const Vec3& a, const Vec3& b) { return a.x() * b.y() - a.y() * b.x(); }

Vec3 centre_W(const bit::Part& part, const Pose& X_WB) {
  Vec3 sum = Vec3::Zero();
  for (const Vec3& x_P : part.mesh_P.positions) sum += x_P;
  return X_WB * (part.X_BP * (sum / static_cast<double>(part.mesh_P.positions.size())));
}

/// Tolerance in x, m, within which a face may be directly above a point.
constexpr double slack = 1e-6;

/// A point, and the result for the faces above it so far.
struct Column {
  Vec3 p;  ///< in W
  std::size_t number;
  int up_minus_down = 0;
  double cover = 0.0;
};

/// Columns sorted by x. Points are shifted off the vertices, which are often directly above one
/// another, by far less than an edge length.
std::vector<Column> columns_through(std::span<const Vec3> points_W) {
  std::vector<Column> columns;
  for (const Vec3& x_W : points_W)
    columns.push_back({x_W + Vec3(1.37e-8, 2.11e-8, 0.0), columns.size()});
  std::ranges::sort(columns, {}, [](const Column& k) { return k.p.x(); });
  return columns;
}

void cross_face(const Vec3& a_W, const Vec3& b_W, const Vec3& c_W, Column& column) {
  const Vec3 a = a_W - column.p, b = b_W - column.p, c = c_W - column.p;
  const double wa = cross(b, c), wb = cross(c, a), wc = cross(a, b), sum = wa + wb + wc;
  if (std::min({wa, wb, wc}) < 0.0 && std::max({wa, wb, wc}) > 0.0) return;
  const double height = sum == 0.0 ? 0.0 : -(wa * a.z() + wb * b.z() + wc * c.z()) / sum;
  if (height <= 0.0) return;
  column.up_minus_down +=
      sum < 0.0 ? 1 : -1;  // z points down: a face that points up has a negative area
  column.cover = std::max(column.cover, height);
}

}  // namespace

std::vector<double> rock_heights_above(const mesh::Surface& rock, std::span<const Vec3> points_W) {
  std::vector<Column> columns = columns_through(points_W);
  for (const mesh::Triangle& t : rock.triangles) {
    if (t[0] < 0) continue;
    const Vec3 &a = rock.position(t[0]), &b = rock.position(t[1]), &c = rock.position(t[2]);
    const double lo = std::min({a.x(), b.x(), c.x()}) - slack,
                 hi = std::max({a.x(), b.x(), c.x()}) + slack;
    auto column =
        std::ranges::lower_bound(columns, lo, {}, [](const Column& k) { return k.p.x(); });
    for (; column != columns.end() && column->p.x() <= hi; ++column) cross_face(a, b, c, *column);
  }
  std::vector<double> covers(points_W.size());
  for (const Column& k : columns) covers[k.number] = k.up_minus_down > 0 ? k.cover : 0.0;
  return covers;
}

double rock_height_above(const mesh::Surface& rock, const Vec3& x_W) {
  return rock_heights_above(rock, std::span(&x_W, 1)).front();
}

void require_start_outside_rock(const Case& c, const mesh::Surface& rock) {
  const Pose X_WB = pose_at(c.motion, time_at(c.time, c.time.first));
  std::vector<const bit::Part*> cutting;
  std::vector<Vec3> centres_W;
  for (const bit::Part& part : c.bit.parts) {
    if (part.cutting != bit::Cutting::cuts) continue;
    cutting.push_back(&part);
    centres_W.push_back(centre_W(part, X_WB));
  }
  const std::vector<double> covers = rock_heights_above(rock, centres_W);
  for (std::size_t i = 0; i < covers.size(); ++i)
    if (covers[i] > 0.0)
      throw InputError(
          fmt::format("{}: found the middle of {} {:.3f} mm below the rock's surface at the start, "
                      "expected a bit that starts inside the rock by at most a cutter's radius",
                      c.places.motion, cutting[i]->name, 1e3 * covers[i]));
}

}  // namespace tdbd::simulation
