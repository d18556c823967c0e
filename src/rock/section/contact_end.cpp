#include "rock/section/contact_end.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/search/triangle_tree.hpp"
#include "rock/cut/plane_strip.hpp"

namespace tdbd::rock {
namespace {

TDBD_WIDE void fill_rows(const Vec3& x, Shadow& w) {
  const Vec3 &U = w.U, &e = w.e, &u = w.u;
  for (std::size_t i = 0; i < w.solid.b.size(); i += lanes) {
    WidePlanes p;
    load(w.solid, i, p);
    const Wide a = p.x * e.x() + p.y * e.y() + p.z * e.z();
    const Wide c = p.x * u.x() + p.y * u.y() + p.z * u.z();
    const Wide out = p.x * x.x() + p.y * x.y() + p.z * x.z();
    const Wide at_U = p.x * U.x() + p.y * U.y() + p.z * U.z();
    const Wide r = (out > p.b ? out : p.b) - at_U;
    TDBD_STORE(a, &w.a[i]);
    TDBD_STORE(c, &w.c[i]);
    TDBD_STORE(r, &w.r[i]);
  }
}

TDBD_WIDE void find_exit(const mesh::ConvexSolid& s, const Vec3& U, const Vec3& e, const Vec3& x,
                         Exit& exit) {
  for (std::size_t i = 0; i < s.b.size(); i += lanes) {
    WidePlanes p;
    load(s, i, p);
    const Wide a = p.x * e.x() + p.y * e.y() + p.z * e.z();
    const Wide at_U = p.x * U.x() + p.y * U.y() + p.z * U.z();
    const auto may_leave = (a > 0.0) & (p.b - at_U < a * exit.t);
    if ((may_leave[0] | may_leave[1] | may_leave[2] | may_leave[3]) == 0) continue;
    const Wide out = p.x * x.x() + p.y * x.y() + p.z * x.z();
    const Wide r = (out > p.b ? out : p.b) - at_U;
    for (std::size_t l = 0; l < lanes; ++l)
      if (a[l] > 0.0 && r[l] < a[l] * exit.t) exit = {std::max(r[l], 0.0) / a[l], i + l};
  }
}

/// Four rows, one per lane. For loops that are TDBD_WIDE.
struct WideRows {
  Wide a, c, r;
};

void load(const Shadow& w, std::size_t i, WideRows& rows) {
  TDBD_LOAD(rows.a, &w.a[i]);
  TDBD_LOAD(rows.c, &w.c[i]);
  TDBD_LOAD(rows.r, &w.r[i]);
}

/// The interval of s in which the line at t is inside, and the planes that bound it. Without a
/// plane below, s >= 0. Planes parallel to u are ignored.
struct Span {
  double lo = 0.0, hi = std::numeric_limits<double>::infinity();
  std::size_t below = mesh::most_planes, above = mesh::most_planes;
};

TDBD_WIDE void find_span(const Shadow& w, double t, Span& span) {
  for (std::size_t i = 0; i < w.columns(); i += lanes) {
    WideRows rows;
    load(w, i, rows);
    const Wide s = (rows.r - rows.a * t) / rows.c;
    const auto is_above = (rows.c > least_cosine) & (s < span.hi);
    const auto is_below = (rows.c < -least_cosine) & (s > span.lo);
    const auto bounds = is_above | is_below;
    if ((bounds[0] | bounds[1] | bounds[2] | bounds[3]) == 0) continue;
    for (std::size_t l = 0; l < lanes; ++l) {
      if (is_above[l] && s[l] < span.hi) {
        span.hi = s[l];
        span.above = i + l;
      }
      if (is_below[l] && s[l] > span.lo) {
        span.lo = s[l];
        span.below = i + l;
      }
    }
  }
}

Span span_at(const Shadow& w, double t) {
  Span span;
  find_span(w, t, span);
  return span;
}

/// The end of a stretch: at the next plane below it, at a side, or where the surface above meets
/// it.
TDBD_WIDE void find_end(const Shadow& w, Stretch& stretch) {
  const double t = stretch.from, s = w.height(stretch.plane, t);
  const double falls = w.a[stretch.plane] / w.c[stretch.plane];
  for (std::size_t i = 0; i < w.columns(); i += lanes) {
    WideRows rows;
    load(w, i, rows);
    const auto is_up = rows.c > least_cosine;
    const auto is_side = (rows.c <= least_cosine) & (rows.c >= -least_cosine);
    const Wide one = Wide{} + 1.0;
    const Wide c = is_side ? one : rows.c;
    const Wide more = rows.a / c - falls, apart = (rows.r - rows.a * t) / c - s;
    const Wide closes = is_side ? rows.a : is_up ? more : -more;
    const Wide margin = is_up ? apart : -apart;
    const auto ends = closes > 0.0;
    const Wide at_side = rows.r / (ends ? closes : one);
    const Wide at_plane = t + (margin > 0.0 ? margin : Wide{}) / (ends ? closes : one);
    const Wide to = is_side ? at_side : at_plane;
    const auto is_first = ends & (to < stretch.to);
    if ((is_first[0] | is_first[1] | is_first[2] | is_first[3]) == 0) continue;
    for (std::size_t l = 0; l < lanes; ++l) {
      if (!is_first[l] || !(to[l] < stretch.to) || i + l == stretch.plane) continue;
      stretch.to = to[l];
      stretch.next = is_up[l] ? i + l : mesh::most_planes;
    }
  }
}

/// Value at t = 0 of a bound of s, and its decrease per unit of t. The bound s >= 0 has no plane.
struct Bound {
  double s = 0.0, falls = 0.0;
};

Bound bound_of(const Shadow& w, std::size_t plane) {
  if (plane == mesh::most_planes) return {};
  return {w.r[plane] / w.c[plane], w.a[plane] / w.c[plane]};
}

}  // namespace

Shadow::Shadow(const mesh::ConvexSolid& convex, const Vec3& start, const Vec3& way,
               const Vec3& direction, const Vec3& x_P)
    : solid(convex), U(start), e(way), u(direction) {
  fill_rows(x_P, *this);
}

Shadow::Shadow(const mesh::ConvexSolid& convex, const Vec3& start, const Vec3& way, const Vec3& x_P)
    : Shadow(convex, start, way, Vec3::Zero(), x_P) {
  std::fill_n(c.begin(), planes(), 1.0);
}

Exit exit_of_line(const mesh::ConvexSolid& solid, const Vec3& U, const Vec3& e, const Vec3& x_P) {
  Exit exit;
  find_exit(solid, U, e, x_P, exit);
  return exit;
}

double reach_at(const Shadow& w, double t) { return std::max(span_at(w, t).hi, 0.0); }

/// Newton's method from above on the concave function hi - lo, whose tangents never end before the
/// root.
Vec3 end_of_shadow(const Shadow& w) {
  constexpr int most_rounds = 100;
  double t = 1.0;
  for (std::size_t i = 0; i < w.planes(); ++i)
    if (facing(w, i) == Facing::parallel && w.a[i] > 0.0)
      t = std::min(t, std::max(w.r[i], 0.0) / w.a[i]);
  Span span = span_at(w, t);
  for (int i = 0; i < most_rounds && span.lo > span.hi && t > 0.0; ++i) {
    const Bound above = bound_of(w, span.above), below = bound_of(w, span.below);
    const double level = above.s - below.s, falls = above.falls - below.falls;
    const double next = falls > 0.0 ? std::max(level / falls, 0.0) : 0.0;
    if (!(next < t)) break;
    t = next;
    span = span_at(w, t);
  }
  return w.point(t, std::clamp(span.lo, 0.0, std::max(span.hi, 0.0)));
}

Stretch first_stretch(const Shadow& w) {
  const Span span = span_at(w, 0.0);
  return stretch_from(w, span.above == mesh::most_planes ? 0 : span.above, 0.0);
}

Stretch stretch_from(const Shadow& w, std::size_t plane, double t) {
  Stretch stretch{plane, t, 1.0};
  find_end(w, stretch);
  stretch.to = std::max(stretch.to, t);
  return stretch;
}

namespace {

ContactEnd end_at(const Vec3& x_P, int side = -1) { return {x_P, side, x_P}; }

/// The end on the line U + t e of undisturbed rock, for a vertex now at x_P that was displaced
/// along u. A side that pressed is in contact up to the undisturbed surface; any other side only at
/// its lower edge.
ContactEnd end_on_line(const PressingPart& part, const Vec3& U, const Vec3& e, const Vec3& u,
                       const Vec3& x_P) {
  const mesh::ConvexSolid& solid = *convex(part);
  const Exit exit = exit_of_line(solid, U, e, x_P);
  const Vec3 end = U + exit.t * e, n_P = mesh::normal(solid, exit.plane);
  const Facing side_faces = facing(n_P.dot(u));
  if (exit.t >= 1.0 || side_faces == Facing::up) return end_at(end);
  const bool pressed = presses(part, displacement_P(part, end), n_P);
  const Shadow w(solid, U, e, u, x_P);
  if (side_faces == Facing::down)
    return pressed ? ContactEnd{end, -1, end_of_shadow(w)} : end_at(end_of_shadow(w));
  const int side = static_cast<int>(exit.plane);
  const Vec3 foot = w.point(exit.t, reach_at(w, exit.t));
  return pressed ? ContactEnd{end, side, foot} : end_at(foot, side);
}

/// The side parallel to u on which x lies, or -1.
int side_at(const PressingPart& part, const Shadow& w, const Vec3& x_P) {
  constexpr double near = 1e-3;  // times the gap
  for (std::size_t i = 0; i < w.planes(); ++i)
    if (facing(w, i) == Facing::parallel &&
        std::abs(mesh::normal(w.solid, i).dot(x_P) - w.solid.b[i]) <= near * part.gap)
      return static_cast<int>(i);
  return -1;
}

/// The last t in [lo, hi] up to which `holds` is true, by bisection.
template <class Holds>
double last_that(double lo, double hi, const Holds& holds) {
  constexpr int halvings = 24;
  for (int i = 0; i < halvings; ++i) {
    const double t = 0.5 * (lo + hi);
    (holds(t) ? lo : hi) = t;
  }
  return lo;
}

/// The last point of a line at which the surface presses or slides. If the line has a direction,
/// that is the surface below the line, otherwise the nearest surface.
struct LastPressed {
  double t = 0.0;
  Vec3 x_P;
};

LastPressed last_pressed(const PressingPart& part, const Shadow& w) {
  Stretch s = first_stretch(w);
  const auto point = [&](double t) { return w.point(t, w.height(s.plane, t)); };
  for (std::size_t i = 0; i < w.planes(); ++i) {
    if (s.to > s.from) {
      const Vec3 n_P = mesh::normal(w.solid, s.plane);
      const Vec3 move_P = displacement_P(part, point(s.from));
      if (!presses_or_slides(part, move_P, n_P)) return {s.from, point(s.from)};
      const Vec3 change_P = displacement_P(part, point(s.to)) - move_P;
      const auto holds = [&](double share) {
        return presses_or_slides(part, move_P + share * change_P, n_P);
      };
      if (!holds(1.0)) {
        const double t = s.from + last_that(0.0, 1.0, holds) * (s.to - s.from);
        return {t, point(t)};
      }
    }
    if (s.next == mesh::most_planes) break;
    s = stretch_from(w, s.next, s.to);
  }
  return {s.to, point(s.to)};
}

/// The last t at which the surface nearest to x + t e presses or slides. Exact if the same solid is
/// nearest at both ends of the line.
double last_pressed_near(const PressingPart& part, const Vec3& x_P, const Vec3& e) {
  std::size_t nearest_solid = 0;
  const auto holds = [&](double t) { return !is_on_lee_side(part, x_P + t * e, nearest_solid); };
  std::size_t at_start = 0;
  if (part.solids.size() > 1) {
    holds(0.0);
    at_start = nearest_solid;
    holds(1.0);
  }
  const CuttingPart& solid = part.solids[at_start];
  if (nearest_solid == at_start && !solid.tree_P)
    return last_pressed(part, Shadow(solid.solid_P, x_P, e, x_P)).t;
  return last_that(0.0, 1.0, holds);
}

/// Whether the part has pressed a vertex by more than rounding, so that lines from it have a
/// direction.
bool has_direction(const PressingPart& part, const Vec3& d_P) {
  constexpr double pressed = 1e-3;  // times the gap
  return d_P.norm() > pressed * part.gap;
}

/// Where a line leaves a convex solid, as a fraction of its length. It may begin outside by up to
/// the gap; if it begins farther outside, the result is 0.
TDBD_WIDE double leave(const mesh::ConvexSolid& s, const Vec3& from, const Vec3& e, double gap) {
  Wide least = Wide{} + 1.0;
  for (std::size_t i = 0; i < s.b.size(); i += lanes) {
    WidePlanes p;
    load(s, i, p);
    const Wide out = p.x * from.x() + p.y * from.y() + p.z * from.z() - p.b;
    const auto is_outside = out > gap;
    if ((is_outside[0] | is_outside[1] | is_outside[2] | is_outside[3]) != 0) return 0.0;
    const Wide across = p.x * e.x() + p.y * e.y() + p.z * e.z();
    const auto is_left = out + across > gap;
    const Wide margin = out < 0.0 ? -out : Wide{};
    const Wide t = margin / (is_left & (across > 0.0) ? across : Wide{} + 1.0);
    least = is_left & (t < least) ? t : least;
  }
  return std::min({least[0], least[1], least[2], least[3]});
}

/// The same for a solid of any shape: the first outward crossing. A line without crossings is
/// inside or, from a vertex that the part only touches, outside.
double leave(const mesh::TriangleTree& tree, const Vec3& from, const Vec3& e) {
  constexpr double rim = 1e-9;
  mesh::Box way;
  way.add(from);
  way.add(from + e);
  double t = std::numeric_limits<double>::infinity();
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

/// Follows the line from solid to solid of a part, as long as it is inside one.
double leave(const PressingPart& part, const Vec3& from, const Vec3& e) {
  double t = 0.0;
  for (std::size_t round = 0; round < part.solids.size(); ++round) {
    const double before = t;
    for (const CuttingPart& s : part.solids) {
      const Vec3 start = from + t * e, rest = (1.0 - t) * e;
      t += (1.0 - t) *
           (s.tree_P ? leave(*s.tree_P, start, rest) : leave(s.solid_P, start, rest, part.gap));
    }
    if (t == before || t >= 1.0) break;
  }
  return t;
}

}  // namespace

ContactEnd end_on_undisturbed_rock(const PressingPart& part, const PressedPlace& from,
                                   const Vec3& q_P) {
  const Vec3 U_P = from.x_P - from.d_P, e = q_P - U_P;
  const mesh::ConvexSolid* solid = convex(part);
  if (solid != nullptr && has_direction(part, from.d_P))
    return end_on_line(part, U_P, e, from.d_P.normalized(), from.x_P);
  return end_at(U_P + leave(part, U_P, e) * e);
}

ContactEnd end_beside_lee_side(const PressingPart& part, const PressedPlace& from,
                               const Vec3& q_P) {
  const Vec3 U_P = from.x_P - from.d_P;
  return end_on_line(part, U_P, q_P - U_P, from.d_P.normalized(), U_P);
}

ContactEnd end_at_lee_side(const PressingPart& part, const PressedPlace& from, const Vec3& q_P,
                           const Vec3& undisturbed_q_P) {
  const Vec3 e = q_P - from.x_P, U_P = from.x_P - from.d_P, e_U = undisturbed_q_P - U_P;
  const mesh::ConvexSolid* solid = convex(part);
  if (solid == nullptr || !has_direction(part, from.d_P)) {
    const double t = last_pressed_near(part, from.x_P, e);
    const double t_U = leave(part, U_P, e_U);
    return t_U < t ? end_at(U_P + t_U * e_U) : end_at(from.x_P + t * e);
  }
  const Vec3 u = from.d_P.normalized();
  const Shadow w(*solid, from.x_P, e, u, from.x_P);
  const LastPressed last = last_pressed(part, w);
  if (exit_of_line(*solid, U_P, e_U, from.x_P).t < last.t)
    return end_on_line(part, U_P, e_U, u, from.x_P);
  return end_at(last.x_P, side_at(part, w, last.x_P));
}

bool edge_between(const PressingPart& part, const ContactEnd& a, const ContactEnd& b,
                  const Vec3& d_P, std::array<Vec3, 2>& points_P) {
  if (a.side < 0 || b.side < 0 || a.side == b.side) return false;
  const mesh::ConvexSolid& solid = *convex(part);
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
