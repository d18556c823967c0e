#include "bit/cone/tracking.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bit/cone/cone_parts.hpp"
#include "core/types.hpp"

namespace tdbd::bit {
namespace {

/// A ring whose prints may be close enough to those of the current ring.
struct Neighbour {
  const std::vector<Print>* prints;
  double near;  ///< rad: prints closer in azimuth are close enough
};

double wrapped(double angle) { return std::remainder(angle, full_turn); }

/// Half the angle (rad) over which a ring is closer than `distance` to a point of another ring; 0
/// if it is nowhere.
double near_angle(const PrintRing& ring, const PrintRing& other, double distance) {
  const double a = ring.radius, b = other.radius;
  if (std::abs(a - b) >= distance) return 0.0;
  if (a + b <= distance) return pi;
  return 2.0 * std::asin(0.5 * std::sqrt((distance * distance - (a - b) * (a - b)) / (a * b)));
}

/// Visits the azimuths of the prints that a ring made between `most` and `least` (rad) before
/// `turned`.
template <class Visit>
void visit_earlier(const Neighbour& n, double turned, double least, double most, Visit visit) {
  const auto begin = std::ranges::lower_bound(*n.prints, turned - most, {}, &Print::turned);
  const auto end = std::ranges::lower_bound(*n.prints, turned - least, {}, &Print::turned);
  for (auto p = begin; p < end; ++p) visit(p->azimuth);
}

bool tracks(const Print& print, const std::vector<Neighbour>& near, int lag) {
  bool found = false;
  for (const Neighbour& n : near) {
    const double least = lag == 1 ? 0.0 : full_turn * (lag - 1) + n.near;
    visit_earlier(n, print.turned, least, full_turn * lag + n.near, [&](double azimuth) {
      found = found || std::abs(wrapped(print.azimuth - azimuth)) < n.near;
    });
  }
  return found;
}

/// Fraction of the circle within reach of the prints of the last revolution.
double covered_share(const Print& print, const std::vector<Neighbour>& near,
                     std::vector<std::pair<double, double>>& arcs) {
  arcs.clear();
  for (const Neighbour& n : near)
    visit_earlier(n, print.turned, 0.0, full_turn + n.near, [&](double azimuth) {
      const double begin = wrapped(azimuth - n.near) + pi, end = begin + 2.0 * n.near;
      arcs.emplace_back(begin, std::min(end, full_turn));
      if (end > full_turn) arcs.emplace_back(0.0, end - full_turn);
    });
  std::ranges::sort(arcs);
  double covered = 0.0, reached = 0.0;
  for (const auto& [begin, end] : arcs) {
    covered += std::max(0.0, end - std::max(begin, reached));
    reached = std::max(reached, end);
  }
  return covered / full_turn;
}

TrackingShare judge(const std::vector<Print>& own, const std::vector<Neighbour>& near, int lags) {
  TrackingShare t;
  t.share.assign(static_cast<std::size_t>(lags), 0.0);
  std::vector<std::pair<double, double>> arcs;
  for (const Print& print : own) {
    if (print.turned < 0.0) continue;
    ++t.prints;
    for (int lag = 1; lag <= lags; ++lag)
      t.share[static_cast<std::size_t>(lag - 1)] += tracks(print, near, lag) ? 1.0 : 0.0;
    t.random_phase += covered_share(print, near, arcs);
  }
  const double count = static_cast<double>(std::max(1L, t.prints));
  for (double& share : t.share) share /= count;
  t.random_phase /= count;
  return t;
}

/// The angle about the cone's Z at which a point of the cone is deepest.
double deepest_angle_of(const Cone& cone) {
  const Vec3 down_K = cone.X_BK.R.transpose() * Vec3::UnitZ();
  return std::atan2(down_K.y(), down_K.x());
}

Vec3 tip_B(const Cone& cone, const ToothRow& row, double angle) {
  return cone.X_BK * (tooth_pose(cone.layout, row, angle) * Vec3(0.0, 0.0, row.shape.protrusion));
}

/// Extent along a direction of the part of a convex mesh that is deeper than `depth` (z).
struct Extent {
  double depth;
  Vec3 along;
  double lo = std::numeric_limits<double>::infinity(), hi = -lo;

  void add(const Vec3& x) {
    lo = std::min(lo, along.dot(x));
    hi = std::max(hi, along.dot(x));
  }
  void add_edge(const Vec3& a, const Vec3& b) {
    if (a.z() >= depth) add(a);
    if ((a.z() >= depth) != (b.z() >= depth)) add(a + (depth - a.z()) / (b.z() - a.z()) * (b - a));
  }
};

}  // namespace

std::vector<TrackingShare> tracking(const std::vector<PrintRing>& rings,
                                    const std::vector<double>& speed_ratios,
                                    const TrackingOptions& options) {
  const double past = -full_turn * (options.lags + 1), end = full_turn * options.revolutions;
  std::vector<std::vector<Print>> all;
  all.reserve(rings.size());
  for (std::size_t i = 0; i < rings.size(); ++i)
    all.push_back(prints(rings[i], speed_ratios[i], past, end));
  std::vector<TrackingShare> shares;
  for (std::size_t i = 0; i < rings.size(); ++i) {
    std::vector<Neighbour> near;
    for (std::size_t j = 0; j < rings.size(); ++j)
      if (const double angle =
              near_angle(rings[i], rings[j], options.share_of_width * rings[i].width);
          angle > 0.0)
        near.push_back({&all[j], angle});
    shares.push_back(judge(all[i], near, options.lags));
  }
  return shares;
}

TrackingShare combined(const std::vector<TrackingShare>& rings) {
  TrackingShare sum;
  for (const TrackingShare& r : rings) {
    const double n = static_cast<double>(r.prints);
    sum.prints += r.prints;
    sum.share.resize(std::max(sum.share.size(), r.share.size()), 0.0);
    for (std::size_t k = 0; k < r.share.size(); ++k) sum.share[k] += n * r.share[k];
    sum.random_phase += n * r.random_phase;
  }
  const double count = static_cast<double>(std::max(1L, sum.prints));
  for (double& share : sum.share) share /= count;
  sum.random_phase /= count;
  return sum;
}

std::vector<BitRow> bit_rows(const Bit& bit, double penetration) {
  std::vector<BitRow> rows;
  for (std::size_t k = 0; k < bit.cones.size(); ++k)
    for (std::size_t j = 0; j < bit.cones[k].layout.rows.size(); ++j) {
      const ToothRow& row = bit.cones[k].layout.rows[j];
      const double teeth = static_cast<double>(row.angles.size());
      if (tooth_contact_ratio(bit.cones[k], row, penetration) < teeth)
        rows.push_back(
            {static_cast<int>(k), static_cast<int>(j), print_ring(bit.cones[k], row, penetration)});
    }
  return rows;
}

std::vector<TrackingShare> tracking(const std::vector<BitRow>& rows,
                                    const std::vector<double>& cone_speeds,
                                    const TrackingOptions& options) {
  std::vector<PrintRing> rings;
  std::vector<double> ratios;
  for (const BitRow& row : rows) {
    rings.push_back(row.ring);
    ratios.push_back(cone_speeds[static_cast<std::size_t>(row.cone)]);
  }
  return tracking(rings, ratios, options);
}

double print_width(const Cone& cone, const ToothRow& row, double penetration) {
  const double angle = deepest_angle_of(cone);
  const Pose X_BT = cone.X_BK * tooth_pose(cone.layout, row, angle);
  const mesh::TriangleMesh mesh_T = tooth_mesh(row.shape, cone.layout.facets);
  std::vector<Vec3> x_B;
  x_B.reserve(mesh_T.positions.size());
  double deepest = -std::numeric_limits<double>::infinity();
  for (const Vec3& x_T : mesh_T.positions)
    deepest = std::max(deepest, x_B.emplace_back(X_BT * x_T).z());
  const Vec3 tip = tip_B(cone, row, angle);
  const Vec3 across = Vec3::UnitZ().cross(Vec3(tip.x(), tip.y(), 0.0));
  if (across.norm() == 0.0) return 0.0;
  Extent extent{deepest - penetration, across.normalized()};
  for (const mesh::Triangle& t : mesh_T.triangles)
    for (std::size_t k = 0; k < 3; ++k)
      extent.add_edge(x_B[static_cast<std::size_t>(t[k])],
                      x_B[static_cast<std::size_t>(t[(k + 1) % 3])]);
  return extent.hi - extent.lo;
}

PrintRing print_ring(const Cone& cone, const ToothRow& row, double penetration) {
  PrintRing ring;
  ring.deepest_angle = deepest_angle_of(cone);
  const Vec3 tip = tip_B(cone, row, ring.deepest_angle);
  ring.radius = tip.head<2>().norm();
  ring.azimuth_B = std::atan2(tip.y(), tip.x());
  ring.angles = row.angles;
  ring.width = print_width(cone, row, penetration);
  return ring;
}

std::vector<Print> prints(const PrintRing& ring, double speed_ratio, double from, double to) {
  std::vector<Print> all;
  for (const double angle : ring.angles) {
    const double first = (angle - ring.deepest_angle) / speed_ratio;
    const double pitch = full_turn / speed_ratio;
    const auto begin = static_cast<long>(std::ceil((from - first) / pitch));
    const auto end = static_cast<long>(std::ceil((to - first) / pitch));
    for (long m = begin; m < end; ++m) {
      const double turned = first + pitch * static_cast<double>(m);
      all.push_back({turned, turned + ring.azimuth_B});
    }
  }
  std::ranges::sort(all, {}, &Print::turned);
  return all;
}

double tooth_contact_ratio(const Cone& cone, const ToothRow& row, double penetration) {
  const Vec3 tip_K = tooth_pose(cone.layout, row, 0.0) * Vec3(0.0, 0.0, row.shape.protrusion);
  const double height = std::abs(tip_K.x()) * cone.X_BK.R.row(2).head<2>().norm();
  const double cosine = height > 0.0 ? std::max(-1.0, 1.0 - penetration / height) : -1.0;
  return static_cast<double>(row.angles.size()) * std::acos(cosine) / pi;
}

}  // namespace tdbd::bit
