#include "rock/start/rough_bottom.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/random.hpp"

namespace tdbd::rock {
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
