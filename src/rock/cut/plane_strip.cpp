#include "rock/cut/plane_strip.hpp"

#include <algorithm>
#include <bit>
#include <stdexcept>

namespace tdbd::rock {
namespace {

using Lanes = std::array<double, lanes>;

/// The bounds of tau, per lane.
struct Bounds {
  Lanes lo, hi;
};

/// Stops early if the interval becomes empty.
TDBD_WIDE void fill_path(const mesh::ConvexSolid& s, const RelativePath& p, double depth,
                         PlaneStrip& w, Bounds& bounds) {
  const Vec3 q = p.q0_P, d = p.q1_P - p.q0_P;
  const std::size_t n = s.b.size();
  Wide first{}, last = first + 1.0;
  for (std::size_t i = 0; i < n; i += lanes) {
    WidePlanes planes;
    load(s, i, planes);
    const auto& [x, y, z, b] = planes;
    const Wide rest = b - (x * q.x() + y * q.y() + z * q.z());
    const Wide along = x * d.x() + y * d.y() + z * d.z();
    TDBD_STORE(rest, &w.rest[i]);
    TDBD_STORE(along, &w.along[i]);
    narrow_interval(rest - depth, along, first, last);
    const auto none = first >= last;
    if ((none[0] | none[1] | none[2] | none[3]) != 0) break;
  }
  TDBD_STORE(first, bounds.lo.data());
  TDBD_STORE(last, bounds.hi.data());
}

TDBD_WIDE std::size_t first_beside(const mesh::ConvexSolid& s, const Vec3& q, const Vec3& d,
                                   double depth) {
  const std::size_t n = s.b.size();
  for (std::size_t i = 0; i < n; i += lanes) {
    WidePlanes planes;
    load(s, i, planes);
    const auto& [x, y, z, b] = planes;
    const Wide room = b - (x * q.x() + y * q.y() + z * q.z()) - depth;
    const Wide along = x * d.x() + y * d.y() + z * d.z();
    const unsigned beside = lane_bits((room <= 0.0) & (room <= along));
    if (beside != 0) return i + static_cast<std::size_t>(std::countr_zero(beside));
  }
  return n;
}

TDBD_WIDE void fill_direction(const mesh::ConvexSolid& s, const RelativePath& p, PlaneStrip& w) {
  const Vec3 &u = p.u0_P, e = p.u1_P - p.u0_P;
  const std::size_t n = s.b.size();
  for (std::size_t i = 0; i < n; i += lanes) {
    WidePlanes planes;
    load(s, i, planes);
    const auto& [x, y, z, b] = planes;
    const Wide up = x * u.x() + y * u.y() + z * u.z();
    const Wide twist = x * e.x() + y * e.y() + z * e.z();
    TDBD_STORE(up, &w.up[i]);
    TDBD_STORE(twist, &w.twist[i]);
  }
}

/// A value and its plane, per lane.
struct Found {
  Lanes value, plane;
};

/// Four planes relative to the ray at tau.
struct WideRay {
  Wide cosine, room, t;
};

inline void meet(const PlaneStrip& w, std::size_t i, double tau, WideRay& ray) {
  Wide rest, along, up, twist;
  TDBD_LOAD(rest, &w.rest[i]);
  TDBD_LOAD(along, &w.along[i]);
  TDBD_LOAD(up, &w.up[i]);
  TDBD_LOAD(twist, &w.twist[i]);
  const Wide c = up + tau * twist;
  ray.cosine = c;
  ray.room = rest - tau * along;
  ray.t = ray.room / ((c > grazing_cosine) | (c < -grazing_cosine) ? c : Wide{} + 1.0);
}

/// The smallest t of the planes that the ray leaves, per lane.
TDBD_WIDE void first_left(const PlaneStrip& w, double tau, Found& found) {
  Wide least = Wide{} + unbounded, plane = {0.0, 1.0, 2.0, 3.0}, which = plane;
  for (std::size_t i = 0; i < w.columns; i += lanes, plane += 4.0) {
    WideRay ray;
    meet(w, i, tau, ray);
    const auto nearer = (ray.cosine > grazing_cosine) & (ray.t < least);
    which = nearer ? plane : which;
    least = nearer ? ray.t : least;
  }
  TDBD_STORE(least, found.value.data());
  TDBD_STORE(which, found.plane.data());
}

/// Minus the largest t of the planes that the ray enters, per lane. A plane that has the whole ray
/// outside is never entered.
TDBD_WIDE void last_entered(const PlaneStrip& w, double tau, Found& found) {
  Wide least = Wide{} + unbounded, plane = {0.0, 1.0, 2.0, 3.0}, which = plane;
  for (std::size_t i = 0; i < w.columns; i += lanes, plane += 4.0) {
    WideRay ray;
    meet(w, i, tau, ray);
    const auto never =
        (ray.cosine <= grazing_cosine) & (ray.cosine >= -grazing_cosine) & (ray.room < 0.0);
    const Wide t = never ? Wide{} - unbounded : -ray.t;
    const auto farther = ((ray.cosine < -grazing_cosine) | never) & (t < least);
    which = farther ? plane : which;
    least = farther ? t : least;
  }
  TDBD_STORE(least, found.value.data());
  TDBD_STORE(which, found.plane.data());
}

/// The lane with the smallest value; among equal values the one with the first plane. So planes
/// that are not near can be omitted without changing the result.
std::size_t first_lane(const Found& f) {
  std::size_t first = 0;
  for (std::size_t l = 1; l < lanes; ++l)
    if (f.value[l] < f.value[first] ||
        (f.value[l] == f.value[first] && f.plane[l] < f.plane[first]))
      first = l;
  return first;
}

}  // namespace

Interval put_path_on_strip(const mesh::ConvexSolid& s, const RelativePath& p, double depth,
                           PlaneStrip& w) {
  if (s.b.size() > w.rest.size()) throw std::invalid_argument("a strip for too many planes");
  w.columns = s.b.size();
  Bounds bounds;
  fill_path(s, p, depth, w, bounds);
  return {*std::ranges::max_element(bounds.lo), *std::ranges::min_element(bounds.hi)};
}

std::size_t plane_beside_path(const mesh::ConvexSolid& s, const Vec3& q0_P, const Vec3& q1_P,
                              double depth) {
  return first_beside(s, q0_P, q1_P - q0_P, depth);
}

bool is_beside_path(const mesh::ConvexSolid& s, std::size_t i, const Vec3& q0_P, const Vec3& q1_P,
                    double depth) {
  const Vec3 d = q1_P - q0_P;
  const double room =
      s.b[i] - (s.nx[i] * q0_P.x() + s.ny[i] * q0_P.y() + s.nz[i] * q0_P.z()) - depth;
  return room <= 0.0 && room <= s.nx[i] * d.x() + s.ny[i] * d.y() + s.nz[i] * d.z();
}

void put_direction_on_strip(const mesh::ConvexSolid& s, const RelativePath& p, PlaneStrip& w) {
  fill_direction(s, p, w);
}

Crossing leave_at(const PlaneStrip& w, double tau) {
  Found found;
  first_left(w, tau, found);
  const std::size_t l = first_lane(found);
  return {tau, found.value[l], static_cast<std::size_t>(found.plane[l])};
}

Crossing enter_at(const PlaneStrip& w, double tau) {
  Found found;
  last_entered(w, tau, found);
  const std::size_t l = first_lane(found);
  return {tau, -found.value[l], static_cast<std::size_t>(found.plane[l])};
}

namespace {

/// A box as centre and half size.
struct CentredBox {
  Vec3 centre, half;
};

CentredBox centred(const mesh::Box& box) { return {0.5 * (box.lo + box.hi), 0.5 * box.size()}; }

/// Copies the planes that x + t u may meet, with x in a box, u in another and 0 <= t <= t_max:
/// those where n . x - b reaches `least`. `near` needs room for all planes and one more. Returns
/// the number of copied planes.
TDBD_WIDE std::size_t copy_near(const mesh::ConvexSolid& s, const CentredBox& q,
                                const CentredBox& u, double t_max, double least, NearPlanes& n) {
  mesh::ConvexSolid& near = n.solid_P;
  std::size_t count = 0;
  for (std::size_t i = 0; i < s.b.size(); i += lanes) {
    WidePlanes planes;
    load(s, i, planes);
    const auto& [x, y, z, b] = planes;
    const Wide ax = x < 0.0 ? -x : x, ay = y < 0.0 ? -y : y, az = z < 0.0 ? -z : z;
    const Wide at_start = x * q.centre.x() + y * q.centre.y() + z * q.centre.z() + ax * q.half.x() +
                          ay * q.half.y() + az * q.half.z() - b;
    const Wide speed = x * u.centre.x() + y * u.centre.y() + z * u.centre.z() + ax * u.half.x() +
                       ay * u.half.y() + az * u.half.z();
    const Wide farthest = at_start + t_max * (speed > 0.0 ? speed : Wide{});
    for (std::size_t l = 0; l < lanes; ++l) {
      near.nx[count] = x[l], near.ny[count] = y[l], near.nz[count] = z[l], near.b[count] = b[l];
      n.plane[count] = i + l;
      count += farthest[l] >= least ? 1 : 0;
    }
  }
  return count;
}

void resize(NearPlanes& near, std::size_t n) {
  mesh::ConvexSolid& s = near.solid_P;
  for (auto* column : {&s.nx, &s.ny, &s.nz, &s.b}) column->resize(n);
  near.plane.resize(n);
  s.planes = n;
}

bool is_within(const mesh::Box& box, const mesh::Box& outer) {
  return (box.lo.array() >= outer.lo.array()).all() && (box.hi.array() <= outer.hi.array()).all();
}

mesh::Box widened(const mesh::Box& box, double margin) {
  const Vec3 more = 0.1 * box.size() + Vec3::Constant(margin);
  return {box.lo - more, box.hi + more};
}

}  // namespace

PathBoxes boxes_around(const std::vector<RelativePath>& paths,
                       const std::vector<std::size_t>& which) {
  PathBoxes boxes;
  for (const std::size_t i : which) {
    const RelativePath& p = paths[i];
    boxes.q_P.add(p.q0_P);
    boxes.q_P.add(p.q1_P);
    boxes.u_P.add(p.u0_P);
    boxes.u_P.add(p.u1_P);
  }
  return boxes;
}

double checksum(const mesh::ConvexSolid& s) {
  double sum = 0.0;
  for (std::size_t i = 0; i < s.planes; ++i)
    sum = 0.5 * sum + 3.0 * s.nx[i] + 5.0 * s.ny[i] + 7.0 * s.nz[i] + s.b[i];
  return sum;
}

void find_near_planes(const mesh::ConvexSolid& solid, const PathBoxes& boxes, double depth,
                      double t_max, NearPlanes& near) {
  near.hold_for = boxes;
  near.t_max = t_max;
  near.uses = 0;
  resize(near, solid.b.size() + 1);
  const CentredBox q = centred(boxes.q_P), u = centred(boxes.u_P);
  resize(near, copy_near(solid, q, u, t_max, -2.0 * depth, near));
  mesh::pad(near.solid_P);
}

void update_near_planes(const mesh::ConvexSolid& solid, double sum, const PathBoxes& boxes,
                        double depth, double t_max, NearPlanes& near) {
  constexpr int most_uses = 64;  // limits how long boxes that were wide once are kept
  if (sum == near.checksum && t_max == near.t_max && ++near.uses < most_uses &&
      is_within(boxes.q_P, near.hold_for.q_P) && is_within(boxes.u_P, near.hold_for.u_P))
    return;
  near.checksum = sum;
  find_near_planes(solid, {widened(boxes.q_P, 0.05 * t_max), widened(boxes.u_P, 0.01)}, depth,
                   t_max, near);
}

}  // namespace tdbd::rock
