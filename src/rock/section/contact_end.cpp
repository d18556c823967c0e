#include "rock/section/contact_end.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/search/inside.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A displacement along the normal above minus this counts as none, m. It is nearly an angle: a
/// share of the gap would let contacts grow as the step shrinks.
double neither(const PressingPart& part, const Vec3& move_P) {
  constexpr double angle = 1e-4;  // rad
  return angle * move_P.norm() + standing(part);
}

/// How far outside x_P is of the planes that moved away and of all others; the farther of the two
/// is the nearest surface.
struct Sides {
  double pressing = -infinite, lee = -infinite;  // m
};

TDBD_WIDE Sides sides_of(const mesh::ConvexSolid& s, const Vec3& x, const Vec3& move,
                         double tolerance) {
  Wide pressing = Wide{} - infinite, lee = pressing;
  for (std::size_t i = 0; i < s.b.size(); i += lanes) {
    WidePlanes p;
    load(s, i, p);
    const Wide out = p.x * x.x() + p.y * x.y() + p.z * x.z() - p.b;
    const Wide into = p.x * move.x() + p.y * move.y() + p.z * move.z();
    const Wide none = Wide{} - infinite;
    const Wide kept = into >= -tolerance ? out : none, left = into >= -tolerance ? none : out;
    pressing = kept > pressing ? kept : pressing;
    lee = left > lee ? left : lee;
  }
  Sides sides;
  for (std::size_t l = 0; l < lanes; ++l) {
    sides.pressing = std::max(sides.pressing, pressing[l]);
    sides.lee = std::max(sides.lee, lee[l]);
  }
  return sides;
}

/// The same of the nearest facets of a solid of any shape: negative distances.
Sides sides_of(const mesh::TriangleTree& tree, const Vec3& x, const Vec3& move, double tolerance) {
  double pressing2 = infinite, lee2 = infinite;
  tree.visit(
      [&](const mesh::Box& box) {
        const Vec3 beside = x - x.cwiseMax(box.lo).cwiseMin(box.hi);
        return beside.squaredNorm() <= std::min(pressing2, lee2);
      },
      [&](const mesh::Facet& f) {
        const Vec3 n = (f.b - f.a).cross(f.c - f.a).normalized();
        double& least = n.dot(move) >= -tolerance ? pressing2 : lee2;
        least = std::min(least, mesh::squared_distance(f, x));
        return true;
      });
  return {-std::sqrt(pressing2), -std::sqrt(lee2)};
}

Sides sides_of(const PressingPart& part, const Vec3& x_P) {
  const Vec3 move_P = displacement_P(part, x_P);
  const double tolerance = neither(part, move_P);
  Sides nearest;
  double least = infinite;
  for (const CuttingPart& solid : part.solids) {
    const Sides s = solid.tree_P ? sides_of(*solid.tree_P, x_P, move_P, tolerance)
                                 : sides_of(solid.solid_P, x_P, move_P, tolerance);
    const double out = std::abs(std::max(s.pressing, s.lee));
    if (out >= least) continue;
    least = out;
    nearest = s;
  }
  return nearest;
}

/// The half-planes a t + c s <= r that the planes of a solid cut out of the points
/// U + t (q - U) + s u, and the way through them.
struct Shadow {
  struct Row {
    double a, c, r;
  };

  const mesh::ConvexSolid& solid;
  Vec3 U, e, u, x;
  std::array<Row, mesh::most_planes> rows;  // of the solid's planes only

  /// A pressed vertex that only touches lies outside of its planes by up to the gap: they are moved
  /// out to it.
  Shadow(const mesh::ConvexSolid& s, const Vec3& from, const Vec3& way, const Vec3& along,
         const Vec3& pressed)
      : solid(s), U(from), e(way), u(along), x(pressed) {
    for (std::size_t i = 0; i < solid.planes; ++i) {
      const Vec3 n = mesh::normal(solid, i);
      rows[i] = {n.dot(e), n.dot(u), std::max(solid.b[i], n.dot(x)) - n.dot(U)};
    }
  }

  const Row& row(std::size_t i) const { return rows[i]; }
};

constexpr double parallel = 1e-9;  // cosine

/// Between which s the line at t is inside, and the planes that bound it; below, s >= 0 unless a
/// plane does. Planes parallel to u are left out.
struct Span {
  double lo = 0.0, hi = infinite;
  Shadow::Row below{0.0, -1.0, 0.0}, above{};
};

Span span_at(const Shadow& w, double t) {
  Span span;
  for (std::size_t i = 0; i < w.solid.planes; ++i) {
    const Shadow::Row row = w.row(i);
    if (std::abs(row.c) <= parallel) continue;
    const double s = (row.r - row.a * t) / row.c;
    if (row.c > 0.0 && s < span.hi) {
      span.hi = s;
      span.above = row;
    }
    if (row.c < 0.0 && s > span.lo) {
      span.lo = s;
      span.below = row;
    }
  }
  return span;
}

/// Where the way leaves the solid on the undisturbed surface, s = 0, and through which plane.
struct Exit {
  double t = 1.0;
  std::size_t plane = 0;
  bool is_parallel = false, recedes = false;
};

Exit exit_on_surface(const Shadow& w) {
  Exit exit;
  for (std::size_t i = 0; i < w.solid.planes; ++i) {
    const Shadow::Row row = w.row(i);
    if (!(row.a > 0.0) || row.r >= row.a * exit.t) continue;
    exit = {std::max(row.r, 0.0) / row.a, i, std::abs(row.c) <= parallel, row.c < -parallel};
  }
  return exit;
}

/// The largest t, up to that of the planes parallel to u, at which the line is inside for some
/// s >= 0, by Newton's method from above on the concave function hi - lo: its tangent never ends
/// before it.
Vec3 end_of_shadow(const Shadow& w) {
  constexpr int most_rounds = 100;
  double t = 1.0;
  for (std::size_t i = 0; i < w.solid.planes; ++i)
    if (const Shadow::Row row = w.row(i); std::abs(row.c) <= parallel && row.a > 0.0)
      t = std::min(t, std::max(row.r, 0.0) / row.a);
  Span span = span_at(w, t);
  for (int i = 0; i < most_rounds && span.lo > span.hi && t > 0.0; ++i) {
    const double level = span.above.r / span.above.c - span.below.r / span.below.c;
    const double falls = span.above.a / span.above.c - span.below.a / span.below.c;
    const double next = falls > 0.0 ? std::max(level / falls, 0.0) : 0.0;
    if (!(next < t)) break;
    t = next;
    span = span_at(w, t);
  }
  return w.U + t * w.e + std::clamp(span.lo, 0.0, std::max(span.hi, 0.0)) * w.u;
}

ContactEnd end_at(const Vec3& x_P, int side = -1) { return {x_P, side, x_P}; }

/// A side that pressed is in contact up to the undisturbed surface; one that did not, only at its
/// lower edge.
ContactEnd end_of(const PressingPart& part, const Shadow& w) {
  const Exit exit = exit_on_surface(w);
  const Vec3 end = w.U + exit.t * w.e;
  const int side = exit.is_parallel ? static_cast<int>(exit.plane) : -1;
  if (!exit.is_parallel && !exit.recedes) return end_at(end);
  const Vec3 move_P = displacement_P(part, end);
  const bool pressed = mesh::normal(w.solid, exit.plane).dot(move_P) > neither(part, move_P);
  if (exit.recedes)
    return pressed ? ContactEnd{end, -1, end_of_shadow(w)} : end_at(end_of_shadow(w));
  const Vec3 foot = end + std::max(span_at(w, exit.t).hi, 0.0) * w.u;
  return pressed ? ContactEnd{end, side, foot} : end_at(foot, side);
}

/// The surface below a point of the straight way, seen along u.
struct Below {
  bool presses = false;
  double s = 0.0;  ///< m, how far
};

Below below(const PressingPart& part, const Shadow& w, double t) {
  double lo = -infinite, hi = infinite;
  std::size_t plane = 0;
  for (std::size_t i = 0; i < w.solid.planes; ++i) {
    const Shadow::Row row = w.row(i);
    if (std::abs(row.c) <= parallel) {
      if (row.a * t > row.r) return {};
      continue;
    }
    const double s = (row.r - row.a * t) / row.c;
    if (row.c > 0.0 && s < hi) {
      hi = s;
      plane = i;
    }
    if (row.c < 0.0) lo = std::max(lo, s);
  }
  if (lo > hi) return {};
  const Vec3 x_P = w.U + t * w.e + hi * w.u, move_P = displacement_P(part, x_P);
  return {mesh::normal(w.solid, plane).dot(move_P) >= -neither(part, move_P), hi};
}

/// The side parallel to u on which x lies, or -1.
int side_at(const PressingPart& part, const Shadow& w, const Vec3& x_P) {
  constexpr double near = 1e-3;  // of the gap
  for (std::size_t i = 0; i < w.solid.planes; ++i)
    if (std::abs(w.row(i).c) <= parallel &&
        std::abs(mesh::normal(w.solid, i).dot(x_P) - w.solid.b[i]) <= near * part.gap)
      return static_cast<int>(i);
  return -1;
}

/// The last t of a straight way up to which `holds` does.
template <class Holds>
double last_that(const Holds& holds) {
  constexpr int halvings = 24;
  double lo = 0.0, hi = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double t = 0.5 * (lo + hi);
    (holds(t) ? lo : hi) = t;
  }
  return lo;
}

/// Whether the exact ways to an end can be taken: one convex solid, and a direction.
bool is_simple(const PressingPart& part, const Vec3& d_P) {
  constexpr double pressed = 1e-3;  // of the gap
  return part.solids.size() == 1 && !part.solids[0].tree_P && d_P.norm() > pressed * part.gap;
}

/// Where a way leaves a convex solid, as a share of the way; it may begin outside by the gap.
double leave(const mesh::ConvexSolid& solid, const Vec3& from, const Vec3& e, double gap) {
  double t = 1.0;
  for (std::size_t i = 0; i < solid.planes; ++i) {
    const Vec3 n = mesh::normal(solid, i);
    const double out = n.dot(from) - solid.b[i], across = n.dot(e);
    if (out + across > gap) t = std::min(t, std::max(-out, 0.0) / across);
  }
  return t;
}

/// The same of a solid of any shape: the first crossing outwards. A way that crosses nothing is inside
/// or, from a vertex that only touches, outside.
double leave(const mesh::TriangleTree& tree, const Vec3& from, const Vec3& e) {
  constexpr double rim = 1e-9;
  mesh::Box way;
  way.add(from);
  way.add(from + e);
  double t = infinite;
  tree.visit([&](const mesh::Box& box) { return box.overlaps(way); },
             [&](const mesh::Facet& f) {
               const auto hit = mesh::meet(f, from, e);
               const bool is_outwards = (f.b - f.a).cross(f.c - f.a).dot(e) > 0.0;
               if (hit && is_outwards && hit->margin >= -rim && hit->s >= 0.0)
                 t = std::min(t, hit->s);
               return true;
             });
  if (t <= 1.0) return t;
  return mesh::inside(tree, from) ? 1.0 : 0.0;
}

/// Follows the way from solid to solid of a part, as long as it is inside one.
double leave(const PressingPart& part, const Vec3& from, const Vec3& e) {
  double t = 0.0;
  for (std::size_t round = 0; round < part.solids.size(); ++round) {
    const double before = t;
    for (const CuttingPart& s : part.solids) {
      const Vec3 start = from + t * e, rest = (1.0 - t) * e;
      const bool is_inside =
          s.tree_P || sides_of(s.solid_P, start, Vec3::Zero(), 0.0).pressing <= part.gap;
      if (!is_inside) continue;
      t += (1.0 - t) *
           (s.tree_P ? leave(*s.tree_P, start, rest) : leave(s.solid_P, start, rest, part.gap));
    }
    if (t == before || t >= 1.0) break;
  }
  return t;
}

}  // namespace

bool is_on_lee_side(const PressingPart& part, const Vec3& x_P) {
  constexpr double ridge = 1e-6;  // of the gap
  const Sides s = sides_of(part, x_P);
  return s.lee > s.pressing + ridge * part.gap;
}

TouchedPoint on_surface(const PressingPart& part, const Vec3& x_P) {
  if (part.solids.size() != 1 || part.solids[0].tree_P) return {x_P};
  const mesh::ConvexSolid& s = part.solids[0].solid_P;
  double nearest = -infinite;
  std::size_t plane = 0;
  for (std::size_t i = 0; i < s.planes; ++i) {
    const double out = mesh::normal(s, i).dot(x_P) - s.b[i];
    if (out <= nearest) continue;
    nearest = out;
    plane = i;
  }
  if (std::abs(nearest) > part.gap) return {x_P};
  return {x_P - nearest * mesh::normal(s, plane), std::max(nearest, 0.0)};
}

ContactEnd end_on_undisturbed_rock(const PressingPart& part, const PressedPlace& from,
                                   const Vec3& q_P) {
  const Vec3 U_P = from.x_P - from.d_P, e = q_P - U_P;
  if (is_simple(part, from.d_P))
    return end_of(part, {part.solids[0].solid_P, U_P, e, from.d_P.normalized(), from.x_P});
  return end_at(U_P + leave(part, U_P, e) * e);
}

bool is_inside(const PressingPart& part, const Vec3& U_P) {
  if (part.solids.size() != 1 || part.solids[0].tree_P) return false;
  return sides_of(part.solids[0].solid_P, U_P, Vec3::Zero(), 0.0).pressing <= 0.0;
}

ContactEnd end_beside_lee_side(const PressingPart& part, const PressedPlace& from,
                               const Vec3& q_P) {
  const Vec3 U_P = from.x_P - from.d_P;
  return end_of(part, {part.solids[0].solid_P, U_P, q_P - U_P, from.d_P.normalized(), U_P});
}

ContactEnd end_at_lee_side(const PressingPart& part, const PressedPlace& from, const Vec3& q_P,
                           const Vec3& undisturbed_q_P) {
  const Vec3 e = q_P - from.x_P, U_P = from.x_P - from.d_P, e_U = undisturbed_q_P - U_P;
  if (!is_simple(part, from.d_P)) {
    const double t = last_that([&](double s) { return !is_on_lee_side(part, from.x_P + s * e); });
    const double t_U = leave(part, U_P, e_U);
    return t_U < t ? end_at(U_P + t_U * e_U) : end_at(from.x_P + t * e);
  }
  const mesh::ConvexSolid& solid = part.solids[0].solid_P;
  const Vec3 u = from.d_P.normalized();
  const Shadow w{solid, from.x_P, e, u, from.x_P}, undisturbed{solid, U_P, e_U, u, from.x_P};
  const double t = last_that([&](double s) { return below(part, w, s).presses; });
  if (exit_on_surface(undisturbed).t < t) return end_of(part, undisturbed);
  const Vec3 end = w.U + t * w.e + below(part, w, t).s * w.u;
  return end_at(end, side_at(part, w, end));
}

bool edge_between(const PressingPart& part, const ContactEnd& a, const ContactEnd& b,
                  const Vec3& d_P, std::array<Vec3, 2>& points_P) {
  if (a.side < 0 || b.side < 0 || a.side == b.side || !is_simple(part, d_P)) return false;
  const mesh::ConvexSolid& solid = part.solids[0].solid_P;
  const Vec3 u = d_P.normalized();
  const Vec3 n1 = mesh::normal(solid, at(a.side)), n2 = mesh::normal(solid, at(b.side));
  Mat3 rows;
  rows << n1.transpose(), n2.transpose(), u.transpose();
  constexpr double least_angle = 1e-3;
  if (std::abs(rows.determinant()) < least_angle) return false;
  const Eigen::PartialPivLU<Mat3> lu(rows);
  const Vec3 planes(solid.b[at(a.side)], solid.b[at(b.side)], 0.0);
  points_P = {lu.solve(planes + u.dot(a.x_P) * Vec3::UnitZ()),
              lu.solve(planes + u.dot(b.x_P) * Vec3::UnitZ())};
  const auto across = [&](const Vec3& x) { return (x - x.dot(u) * u).norm(); };
  const double way = across(b.x_P - a.x_P);
  return across(points_P[0] - a.x_P) <= way && across(points_P[0] - b.x_P) <= way;
}

}  // namespace tdbd::rock
