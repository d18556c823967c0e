#include "rock/start/borehole.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/random.hpp"

namespace tdbd::rock {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
const double row_spacing = std::sqrt(0.75);  // height of an equilateral triangle

double distance(const MeridianPoint& a, const MeridianPoint& b) {
  return std::hypot(b.r - a.r, b.z - a.z);
}

/// Points at equal arc length, including both ends.
std::vector<MeridianPoint> resampled(const std::vector<MeridianPoint>& curve, double spacing) {
  double length = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i) length += distance(curve[i - 1], curve[i]);
  const int n = std::max(1, static_cast<int>(std::lround(length / spacing)));
  std::vector<MeridianPoint> points{curve.front()};
  double passed = 0.0;
  std::size_t i = 1;
  for (int k = 1; k < n; ++k) {
    const double target = length * k / n;
    while (passed + distance(curve[i - 1], curve[i]) < target)
      passed += distance(curve[i - 1], curve[i]), ++i;
    const double f = (target - passed) / distance(curve[i - 1], curve[i]);
    points.push_back(
        {std::lerp(curve[i - 1].r, curve[i].r, f), std::lerp(curve[i - 1].z, curve[i].z, f)});
  }
  points.push_back(curve.back());
  return points;
}

struct Ring {
  int first, count;
  double phase;  ///< azimuth of the first point divided by the spacing: 0 or 1/2
};

double azimuth(const Ring& ring, int k) { return two_pi * (k + ring.phase) / ring.count; }

Ring add_ring(mesh::TriangleMesh& m, const MeridianPoint& p, double edge_length, double phase) {
  const int n = std::max(6, static_cast<int>(std::lround(two_pi * p.r / edge_length)));
  const Ring ring{static_cast<int>(m.positions.size()), n, phase};
  for (int k = 0; k < n; ++k) {
    const double a = azimuth(ring, k);
    m.positions.emplace_back(p.r * std::cos(a), p.r * std::sin(a), p.z);
  }
  return ring;
}

/// Triangulates the strip between two rings. The ring whose next point has the smaller azimuth
/// advances.
void stitch(mesh::TriangleMesh& m, const Ring& inner, const Ring& outer) {
  int i = 0, j = 0;
  const auto in = [&](int k) { return inner.first + k % inner.count; };
  const auto out = [&](int k) { return outer.first + k % outer.count; };
  while (i < inner.count || j < outer.count) {
    const bool advance_inner =
        j == outer.count || (i < inner.count && azimuth(inner, i + 1) < azimuth(outer, j + 1));
    if (advance_inner) {
      m.triangles.push_back({in(i), in(i + 1), out(j)});
      ++i;
    } else {
      m.triangles.push_back({in(i), out(j + 1), out(j)});
      ++j;
    }
  }
}

}  // namespace

mesh::TriangleMesh borehole(const std::vector<MeridianPoint>& curve, double edge_length) {
  const std::vector<MeridianPoint> rows = resampled(curve, row_spacing * edge_length);
  mesh::TriangleMesh m;
  m.positions.emplace_back(0.0, 0.0, rows.front().z);
  Ring inner = add_ring(m, rows[1], edge_length, 0.0);
  for (int k = 0; k < inner.count; ++k)
    m.triangles.push_back({0, inner.first + (k + 1) % inner.count, inner.first + k});
  for (std::size_t i = 2; i < rows.size(); ++i) {
    const Ring outer = add_ring(m, rows[i], edge_length, i % 2 == 0 ? 0.5 : 0.0);
    stitch(m, inner, outer);
    inner = outer;
  }
  return m;
}

std::vector<MeridianPoint> with_wall(std::vector<MeridianPoint> bottom, double wall) {
  if (wall > 0.0) bottom.push_back({bottom.back().r, bottom.back().z - wall});
  return bottom;
}

std::vector<MeridianPoint> flat_bottom(double radius, double z, double wall) {
  return with_wall({{0.0, z}, {radius, z}}, wall);
}

namespace {

struct Depths {
  double top, bottom;
};

Depths depths_of(const mesh::TriangleMesh& m) {
  Depths d{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Vec3& x : m.positions) d = {std::min(d.top, x.z()), std::max(d.bottom, x.z())};
  return d;
}

}  // namespace

std::vector<Wave> rough_waves(const Roughness& r) {
  constexpr std::size_t count = 200;
  constexpr double full_turn = 2.0 * std::numbers::pi;
  Random random{r.seed};
  std::vector<Wave> waves(count);
  for (Wave& w : waves) {
    const double k = std::sqrt(-2.0 * std::log(1.0 - random.uniform())) / r.correlation_length;
    const double azimuth = full_turn * random.uniform();
    w = {k * std::cos(azimuth), k * std::sin(azimuth), full_turn * random.uniform()};
  }
  return waves;
}

double roughness_at(const Roughness& r, const std::vector<Wave>& waves, double x, double y) {
  double sum = 0.0;
  for (const Wave& w : waves) sum += std::cos(w.kx * x + w.ky * y + w.phase);
  return r.amplitude * std::sqrt(2.0 / static_cast<double>(waves.size())) * sum;
}

void roughen_bottom(mesh::TriangleMesh& m, const Roughness& r) {
  const std::vector<Wave> waves = rough_waves(r);
  const Depths depth = depths_of(m);
  const double wall = depth.bottom - depth.top;
  std::vector<double> down;
  down.reserve(m.positions.size());
  for (const Vec3& x : m.positions) down.push_back(roughness_at(r, waves, x.x(), x.y()));
  const double highest = *std::ranges::min_element(down);
  for (std::size_t v = 0; v < down.size(); ++v) {
    const double share = wall > 0.0 ? (m.positions[v].z() - depth.top) / wall : 1.0;
    m.positions[v].z() += share * (down[v] - highest);
  }
}

}  // namespace tdbd::rock
