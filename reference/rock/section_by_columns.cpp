#include "reference/rock/section_by_columns.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace tdbd::reference {
namespace {

using Vec2 = Eigen::Vector2d;

struct Span {
  double lo = INFINITY, hi = -INFINITY;

  void add(double x) {
    lo = std::min(lo, x);
    hi = std::max(hi, x);
  }
};

/// The outline's extent along the line y.
Span column(const std::vector<Vec2>& outline, double y) {
  Span z;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec2 &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if ((a.x() < y) != (b.x() < y)) z.add(std::lerp(a.y(), b.y(), (y - a.x()) / (b.x() - a.x())));
  }
  return z;
}

double doubled_area(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x();
}

/// Whether the edge from a to b of a counter-clockwise triangle belongs to it: exactly one of the
/// two triangles at an edge owns it.
bool owns(const Vec2& a, const Vec2& b) {
  return b.y() < a.y() || (b.y() == a.y() && b.x() < a.x());
}

/// Whether p is in a counter-clockwise triangle; on its edges only if the triangle owns them. The
/// sign for each edge is that of doubled_area with p first, which is exactly opposite for the
/// triangle beyond it.
bool contains(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  const auto inside = [&](const Vec2& from, const Vec2& to) {
    const double beside = doubled_area(p, from, to);
    return beside > 0.0 || (beside == 0.0 && owns(from, to));
  };
  return inside(a, b) && inside(b, c) && inside(c, a);
}

/// The crossing of a line along Z through (0, y) with a triangle: its place, and the sign of the
/// triangle's orientation.
struct Crossing {
  double z, sign;
};

std::optional<Crossing> crossing(const Vec3& a, const Vec3& b, const Vec3& c, double y) {
  const Vec2 p(0.0, y), pa = a.head<2>(), pb = b.head<2>(), pc = c.head<2>();
  const double whole = doubled_area(pa, pb, pc);
  if (whole == 0.0) return {};
  if (!(whole > 0.0 ? contains(pa, pb, pc, p) : contains(pa, pc, pb, p))) return {};
  const double wa = doubled_area(p, pb, pc), wb = doubled_area(pa, p, pc),
               wc = doubled_area(pa, pb, p);
  return Crossing{(wa * a.z() + wb * b.z() + wc * c.z()) / whole, whole > 0.0 ? 1.0 : -1.0};
}

}  // namespace

ColumnSection section_by_columns(const mesh::TriangleMesh& rock_W, const Pose& X_WF,
                                 const std::vector<Vec2>& outline_F, int columns) {
  std::vector<Vec3> x_F;
  for (const Vec3& x_W : rock_W.positions) x_F.push_back(inverse(X_WF) * x_W);
  Span wide;
  for (const Vec2& p : outline_F) wide.add(p.x());
  const double width = (wide.hi - wide.lo) / columns;
  ColumnSection sum;
  for (int k = 0; k < columns; ++k) {
    const double y = wide.lo + (k + 0.5) * width;
    const Span z = column(outline_F, y);
    for (const auto& [a, b, c] : rock_W.triangles) {
      const auto found =
          crossing(x_F[static_cast<std::size_t>(a)], x_F[static_cast<std::size_t>(b)],
                   x_F[static_cast<std::size_t>(c)], y);
      if (!found || found->z <= z.lo) continue;
      const double top = std::min(found->z, z.hi), area = found->sign * (top - z.lo) * width;
      sum.area += area;
      sum.moment += area * Vec2(y, 0.5 * (top + z.lo));
    }
  }
  return sum;
}

}  // namespace tdbd::reference
