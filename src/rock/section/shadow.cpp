#include "rock/section/shadow.hpp"

#include <algorithm>
#include <limits>

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
    const Wide room = is_up ? apart : -apart;
    const auto ends = closes > 0.0;
    const Wide at_side = rows.r / (ends ? closes : one);
    const Wide at_plane = t + (room > 0.0 ? room : Wide{}) / (ends ? closes : one);
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

Exit exit_of_way(const mesh::ConvexSolid& solid, const Vec3& U, const Vec3& e, const Vec3& x_P) {
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

}  // namespace tdbd::rock
