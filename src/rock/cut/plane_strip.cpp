#include "rock/cut/plane_strip.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace tdbd::rock {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Cosine below which a plane is parallel to a way up to rounding, and does not block it.
constexpr double grazing = 1e-14;
using Lanes = std::array<double, lanes>;

/// Bounds of tau, lane by lane, until the interval is empty. A plane parallel to the path excludes
/// all or nothing.
TDBD_WIDE void bound_tau(const mesh::ConvexSolid& s, const RelativePath& p, double depth, Lanes& lo,
                         Lanes& hi) {
  const Vec3 q = p.q0_P, d = p.q1_P - p.q0_P;
  Wide first{}, last = first + 1.0;
  for (std::size_t i = 0; i < s.b.size(); i += lanes) {
    WidePlanes planes;
    load(s, i, planes);
    const auto& [x, y, z, b] = planes;
    const Wide room = b - depth - (x * q.x() + y * q.y() + z * q.z());
    const Wide speed = x * d.x() + y * d.y() + z * d.z();
    const Wide when = room / (speed == 0.0 ? Wide{} + 1.0 : speed);
    const Wide at_rest = room <= 0.0 ? Wide{} - 1.0 : Wide{} + infinity;
    const Wide until = speed > 0.0 ? when : (speed < 0.0 ? Wide{} + infinity : at_rest);
    const Wide from = speed < 0.0 ? when : Wide{};
    last = until < last ? until : last;
    first = from > first ? from : first;
    const auto none = first >= last;
    if ((none[0] | none[1] | none[2] | none[3]) != 0) break;
  }
  TDBD_STORE(first, lo.data());
  TDBD_STORE(last, hi.data());
}

TDBD_WIDE void fill(const mesh::ConvexSolid& s, const RelativePath& p, PlaneStrip& w) {
  const Vec3 &q = p.q0_P, &u = p.u0_P, d = p.q1_P - p.q0_P, e = p.u1_P - p.u0_P;
  for (std::size_t i = 0; i < s.b.size(); i += lanes) {
    WidePlanes planes;
    load(s, i, planes);
    const auto& [x, y, z, b] = planes;
    const Wide rest = b - (x * q.x() + y * q.y() + z * q.z());
    const Wide along = x * d.x() + y * d.y() + z * d.z();
    const Wide up = x * u.x() + y * u.y() + z * u.z();
    const Wide twist = x * e.x() + y * e.y() + z * e.z();
    TDBD_STORE(rest, &w.rest[i]);
    TDBD_STORE(along, &w.along[i]);
    TDBD_STORE(up, &w.up[i]);
    TDBD_STORE(twist, &w.twist[i]);
  }
}

/// Four planes as a strip sees them.
struct WideStrip {
  Wide rest, along, up, twist;
};

inline void load(const PlaneStrip& w, std::size_t i, WideStrip& four) {
  TDBD_LOAD(four.rest, &w.rest[i]);
  TDBD_LOAD(four.along, &w.along[i]);
  TDBD_LOAD(four.up, &w.up[i]);
  TDBD_LOAD(four.twist, &w.twist[i]);
}

/// The least number in each lane and its plane, the first of equals.
struct Least {
  Lanes value, plane;
};

/// Where the ray at tau first leaves a plane (infinite if it does not) and where it last enters
/// one, by lanes.
TDBD_WIDE void cross_planes(const PlaneStrip& w, double tau, Least& exit, Lanes& entry) {
  Wide first_exit = Wide{} + infinity, last_entry = Wide{} - infinity;
  Wide plane = {0.0, 1.0, 2.0, 3.0}, first_plane = plane;
  for (std::size_t i = 0; i < w.rest.size(); i += lanes, plane += 4.0) {
    WideStrip four;
    load(w, i, four);
    const auto& [rest, along, up, twist] = four;
    const Wide c = up + tau * twist;
    const Wide t = (rest - tau * along) / ((c > grazing) | (c < -grazing) ? c : Wide{} + 1.0);
    const Wide leaves = c > grazing ? t : Wide{} + infinity;
    const Wide enters = c < -grazing ? t : Wide{} - infinity;
    first_plane = leaves < first_exit ? plane : first_plane;
    first_exit = leaves < first_exit ? leaves : first_exit;
    last_entry = enters > last_entry ? enters : last_entry;
  }
  TDBD_STORE(first_exit, exit.value.data());
  TDBD_STORE(first_plane, exit.plane.data());
  TDBD_STORE(last_entry, entry.data());
}

/// The least distance along the way to a plane other than `on`, infinite if none is met, by lanes.
TDBD_WIDE void block(const PlaneStrip& w, const Way& way, std::size_t on, Least& least) {
  Wide smallest = Wide{} + infinity, plane = {0.0, 1.0, 2.0, 3.0}, first_plane = plane;
  const Wide underfoot = Wide{} + static_cast<double>(on);
  for (std::size_t i = 0; i < w.rest.size(); i += lanes, plane += 4.0) {
    WideStrip four;
    load(w, i, four);
    const auto& [rest, along, up, twist] = four;
    const Wide a = along + way.t0 * twist, c = up + way.tau0 * twist;
    const Wide speed = a * way.side + c * way.climb;
    const Wide left = rest + (way.tau0 * way.t0) * twist - a * way.tau - c * way.t;
    const Wide room = left > 0.0 ? left : Wide{};
    const Wide reach = room / (speed > grazing ? speed : Wide{} + 1.0);
    const Wide bounded = (speed > grazing) & (plane != underfoot) ? reach : Wide{} + infinity;
    first_plane = bounded < smallest ? plane : first_plane;
    smallest = bounded < smallest ? bounded : smallest;
  }
  TDBD_STORE(smallest, least.value.data());
  TDBD_STORE(first_plane, least.plane.data());
}

/// The lane of the least value; of equals the one with the first plane.
std::size_t first_lane(const Least& least) {
  std::size_t first = 0;
  for (std::size_t l = 1; l < lanes; ++l)
    if (least.value[l] < least.value[first] ||
        (least.value[l] == least.value[first] && least.plane[l] < least.plane[first]))
      first = l;
  return first;
}

}  // namespace

Interval when_inside(const mesh::ConvexSolid& s, const RelativePath& p, double depth) {
  Lanes lo, hi;
  bound_tau(s, p, depth, lo, hi);
  return {*std::ranges::max_element(lo), *std::ranges::min_element(hi)};
}

void put_on_strip(const mesh::ConvexSolid& s, const RelativePath& p, PlaneStrip& w) {
  for (auto* column : {&w.rest, &w.along, &w.up, &w.twist}) column->resize(s.b.size());
  fill(s, p, w);
}

Exit leave_at(const PlaneStrip& w, double tau) {
  Least exit;
  Lanes entry;
  cross_planes(w, tau, exit, entry);
  const std::size_t l = first_lane(exit);
  return {tau, exit.value[l], static_cast<std::size_t>(exit.plane[l]),
          *std::ranges::max_element(entry)};
}

std::size_t last_entered(const PlaneStrip& w, double tau) {
  std::size_t plane = 0;
  double last = -infinity;
  for (std::size_t i = 0; i < w.rest.size(); ++i) {
    const double c = w.up[i] + tau * w.twist[i];
    if (c >= -grazing || w.rest[i] - tau * w.along[i] >= last * c) continue;
    last = (w.rest[i] - tau * w.along[i]) / c;
    plane = i;
  }
  return plane;
}

std::size_t first_plane_on_way(const PlaneStrip& w, const Way& way, std::size_t on, double& reach) {
  Least least;
  block(w, way, on, least);
  const std::size_t l = first_lane(least);
  if (least.value[l] >= reach) return w.rest.size();
  reach = least.value[l];
  return static_cast<std::size_t>(least.plane[l]);
}

}  // namespace tdbd::rock
