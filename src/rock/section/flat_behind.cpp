#include "rock/section/flat_behind.hpp"

#include <algorithm>
#include <cmath>

#include "bit/cutter/cutter_frame.hpp"

namespace tdbd::rock {
namespace {

/// Relative to the cutter's diameter. Far above rounding, far below a mesh's edge length.
constexpr double same_plane = 1e-9;

}  // namespace

FlatBehind flat_behind(const bit::Cutter& c, int index, const FaceOutline& outline,
                       const std::vector<bit::Part>& parts) {
  FlatBehind flat;
  if (!(c.wear > 0.0)) return flat;
  const Mat3 R_FB = outline.X_BF.R.transpose();
  const Vec3 n_B = bit::profile_normal_B(c), n_F = R_FB * n_B;
  const double level = n_B.dot(bit::tip_B(c) - outline.X_BF.p) - c.wear;
  flat.motion_F = R_FB * bit::direction_of_motion_B(c);
  flat.edge_F = Vec2(level, -n_F.y()) / n_F.z();
  const double slack = same_plane * c.diameter;
  std::vector<Vec2> points;
  for (const bit::Part& part : parts) {
    if (part.cutter != index) continue;
    const Pose X_FP = inverse(outline.X_BF) * part.X_BP;
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_F = X_FP * x_P;
      const double behind = -x_F.x() / flat.motion_F.x();
      if (std::abs(n_F.dot(x_F) - level) <= slack && behind >= -slack)
        points.emplace_back(x_F.y() + behind * flat.motion_F.y(), std::max(0.0, behind));
    }
  }
  if (points.size() < 3) return flat;
  flat.width = Vec3(0.0, 1.0, flat.edge_F.y()).cross(flat.motion_F).norm();
  make_columns(convex_hull(std::move(points), slack), nullptr, flat.columns);
  return flat;
}

FlatPiece flat_between(const FlatBehind& flat, double y0, double y1) {
  FlatPiece piece;
  for (const FaceColumn& c : flat.columns.columns) {
    const double from = std::max(y0, c.y0), to = std::min(y1, c.y1);
    if (!(from < to)) continue;
    const auto lower = [&](double y) { return c.lower + c.lower_slope * (y - c.y0); };
    const auto upper = [&](double y) { return c.upper + c.upper_slope * (y - c.y0); };
    const PolygonMoments above = below_line(0.0, {from, upper(from)}, {to, upper(to)}),
                         below = below_line(0.0, {from, lower(from)}, {to, lower(to)});
    const double area = above.area - below.area;
    const Vec2 moment = above.moment - below.moment;  // in y, and in the distance behind the edge
    piece.area += flat.width * area;
    piece.moment_F +=
        flat.width * (area * Vec3(0.0, 0.0, flat.edge_F.x()) +
                      moment.x() * Vec3(0.0, 1.0, flat.edge_F.y()) - moment.y() * flat.motion_F);
  }
  return piece;
}

}  // namespace tdbd::rock
