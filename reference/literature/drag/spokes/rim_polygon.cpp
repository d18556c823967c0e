#include "reference/literature/drag/spokes/rim_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tdbd::reference {
namespace {

struct UnitRim {
  std::array<double, rim_slabs + 1> x, height;
};

UnitRim unit_rim() {
  UnitRim u{};
  for (int m = 0; m <= rim_slabs; ++m) {
    const double t = std::numbers::pi * m / rim_slabs;
    u.x[at(m)] = -std::cos(t);
    u.height[at(m)] = m == 0 || m == rim_slabs ? 0.0 : std::sin(t);
  }
  return u;
}

const UnitRim unit = unit_rim();

/// Sums over one outline, with the sign of its orientation.
struct RimSum {
  double area = 0.0, moment = 0.0, edge = 0.0;
};

/// One edge of the rock over a part of one slab: depth below the upper branch, and height of the
/// rim, at both ends.
struct SlabPart {
  double r0, r1, w0, w1, h0, h1;
};

/// Adds the integral of a linear function from f0 to f1. Simpson's rule is exact for its product
/// with r.
void add_linear(RimSum& sum, double r0, double r1, double f0, double f1) {
  const double width = r1 - r0;
  sum.area += width * (f0 + f1) / 2.0;
  sum.moment += width / 6.0 * (r0 * f0 + (r0 + r1) * (f0 + f1) + r1 * f1);
}

/// Adds the integral of w clamped between 0 and h.
void add_clamped(RimSum& sum, const SlabPart& p) {
  if (p.w0 <= 0.0 && p.w1 <= 0.0) return;
  const double d0 = p.w0 - p.h0, d1 = p.w1 - p.h1;
  if (d0 >= 0.0 && d1 >= 0.0) return add_linear(sum, p.r0, p.r1, p.h0, p.h1);
  std::array<double, 4> cuts{0.0, 1.0, 1.0, 1.0};
  int n = 1;
  if ((p.w0 < 0.0) != (p.w1 < 0.0)) cuts[at(n++)] = p.w0 / (p.w0 - p.w1);
  if ((d0 < 0.0) != (d1 < 0.0)) cuts[at(n++)] = d0 / (d0 - d1);
  if (n == 3 && cuts[1] > cuts[2]) std::swap(cuts[1], cuts[2]);
  cuts[at(n)] = 1.0;
  const auto value = [&](double s) {
    return std::clamp(std::lerp(p.w0, p.w1, s), 0.0, std::max(0.0, std::lerp(p.h0, p.h1, s)));
  };
  for (int i = 0; i < n; ++i)
    add_linear(sum, std::lerp(p.r0, p.r1, cuts[at(i)]), std::lerp(p.r0, p.r1, cuts[at(i + 1)]),
               value(cuts[at(i)]), value(cuts[at(i + 1)]));
}

/// Fraction of the part in which the rock's edge is above the lower branch.
double share_above(const SlabPart& p) {
  const double d0 = p.w0 - p.h0, d1 = p.w1 - p.h1;
  if (d0 < 0.0 && d1 < 0.0) return 1.0;
  if (d0 >= 0.0 && d1 >= 0.0) return 0.0;
  return d0 < 0.0 ? d0 / (d0 - d1) : d1 / (d1 - d0);
}

void add_slab(RimSum& sum, const RimPolygon& rim, std::size_t m, const SlabPart& p) {
  add_clamped(sum, p);
  const double width = rim.r[m + 1] - rim.r[m];
  sum.edge +=
      share_above(p) * (p.r1 - p.r0) / width * std::hypot(width, rim.lower[m + 1] - rim.lower[m]);
}

/// The sum over the edge from a to b, a.x() < b.x().
RimSum over_edge(const RimPolygon& rim, const Vec2& a, const Vec2& b) {
  RimSum sum;
  const double first = std::max(a.x(), rim.r.front()), last = std::min(b.x(), rim.r.back());
  auto m = static_cast<std::size_t>(std::upper_bound(rim.r.begin(), rim.r.end(), first) -
                                    rim.r.begin() - 1);
  const double slope = (b.y() - a.y()) / (b.x() - a.x());
  for (; m < rim_slabs && rim.r[m] < last; ++m) {
    const double r0 = std::max(first, rim.r[m]), r1 = std::min(last, rim.r[m + 1]);
    const double width = rim.r[m + 1] - rim.r[m], s0 = (r0 - rim.r[m]) / width,
                 s1 = (r1 - rim.r[m]) / width;
    const auto on = [&](const auto& branch, double s) {
      return std::lerp(branch[m], branch[m + 1], s);
    };
    const double u0 = on(rim.upper, s0), u1 = on(rim.upper, s1);
    add_slab(sum, rim, m,
             {r0, r1, a.y() + slope * (r0 - a.x()) - u0, a.y() + slope * (r1 - a.x()) - u1,
              on(rim.lower, s0) - u0, on(rim.lower, s1) - u1});
  }
  return sum;
}

RimSum over_outline(const RimPolygon& rim, const Outline& outline) {
  RimSum sum;
  const double lo = rim.r.front(), hi = rim.r.back();
  for (std::size_t i = 0, n = outline.size(); i < n; ++i) {
    const Vec2 &a = outline[i], &b = outline[i + 1 < n ? i + 1 : 0];
    if ((a.x() <= lo && b.x() <= lo) || (a.x() >= hi && b.x() >= hi) || a.x() == b.x()) continue;
    const bool forward = a.x() < b.x();
    const RimSum part = forward ? over_edge(rim, a, b) : over_edge(rim, b, a);
    const double sign = forward ? 1.0 : -1.0;
    sum.area += sign * part.area;
    sum.moment += sign * part.moment;
    sum.edge += sign * part.edge;
  }
  return {std::abs(sum.area), std::abs(sum.moment), std::abs(sum.edge)};
}

}  // namespace

RimPolygon rim_polygon(const RimEllipse& rim) {
  RimPolygon p;
  for (std::size_t m = 0; m <= rim_slabs; ++m) {
    const double x = rim.half_width * unit.x[m], line = rim.z0 + rim.slope * x,
                 height = rim.bulge * unit.height[m];
    p.r[m] = rim.x0 + x;
    p.lower[m] = line + height;
    p.upper[m] = line - height;
  }
  return p;
}

void outline_of(const RimPolygon& rim, Outline& out) {
  out.clear();
  for (std::size_t m = 0; m <= rim_slabs; ++m) out.emplace_back(rim.r[m], rim.upper[m]);
  for (std::size_t m = rim_slabs - 1; m > 0; --m) out.emplace_back(rim.r[m], rim.lower[m]);
}

CrossingCut rim_in_face(const RimPolygon& rim, const PlanarFace& rock) {
  RimSum sum = over_outline(rim, rock.border);
  for (const Outline& cavity : rock.cavities) {
    const RimSum hole = over_outline(rim, cavity);
    sum.area -= hole.area, sum.moment -= hole.moment, sum.edge -= hole.edge;
  }
  return {sum.area, sum.moment, sum.area, sum.edge};
}

}  // namespace tdbd::reference
