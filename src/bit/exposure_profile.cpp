#include "bit/exposure_profile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/error.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit {
namespace {

constexpr double sample_spacing = 5e-5;  ///< m, along the parts' edges
constexpr int ray_count = 2048;

/// The farthest sample near one ray; distance 0: none yet.
struct Ray {
  double distance2 = 0.0;
  ProfilePoint farthest;
};

/// Rays in a quarter circle about the axis point at height z0, first straight down, last
/// horizontal.
struct Fan {
  double z0;
  std::vector<Ray> rays = std::vector<Ray>(ray_count);

  void add(const Vec3& x_B) {
    const double r = std::hypot(x_B.x(), x_B.y()), down = x_B.z() - z0;
    if (down < 0.0) return;
    const double fraction = std::atan2(r, down) / (0.5 * std::numbers::pi);
    Ray& ray = rays[std::min(ray_count - 1, static_cast<int>(fraction * ray_count))];
    const double distance2 = r * r + down * down;
    if (distance2 > ray.distance2) ray = {distance2, {r, x_B.z()}};
  }
};

double topmost_centre(const std::vector<Part>& parts) {
  double z0 = std::numeric_limits<double>::infinity();
  for (const Part& part : parts) {
    if (part.cutting == Cutting::never) continue;
    const mesh::Box box = mesh::bounding_box(part.mesh_P);
    z0 = std::min(z0, (part.X_BP * Vec3(0.5 * (box.lo + box.hi))).z());
  }
  return z0;
}

void add_edge(const Vec3& a_B, const Vec3& b_B, Fan& fan) {
  const int steps = 1 + static_cast<int>((b_B - a_B).norm() / sample_spacing);
  for (int k = 0; k < steps; ++k) fan.add(a_B + (b_B - a_B) * (static_cast<double>(k) / steps));
}

/// Every edge once: of a closed mesh, the direction in which its first index is the smaller.
void add_part(const Part& part, Fan& fan) {
  std::vector<Vec3> x_B;
  for (const Vec3& x_P : part.mesh_P.positions) x_B.push_back(part.X_BP * x_P);
  for (const mesh::Triangle& t : part.mesh_P.triangles)
    for (int k = 0; k < 3; ++k)
      if (t[k] < t[(k + 1) % 3]) add_edge(x_B[t[k]], x_B[t[(k + 1) % 3]], fan);
}

/// From the axis to the gage, without the empty rays, r monotone.
std::vector<ProfilePoint> outline(const Fan& fan) {
  std::vector<ProfilePoint> points;
  for (const Ray& ray : fan.rays) {
    if (ray.distance2 == 0.0) continue;
    if (points.empty()) points.push_back({0.0, ray.farthest.z});
    points.push_back({std::max(points.back().r, ray.farthest.r), ray.farthest.z});
  }
  return points;
}

double distance(const ProfilePoint& a, const ProfilePoint& b) {
  return std::hypot(b.r - a.r, b.z - a.z);
}

/// Points at equal arc lengths along a polyline, both its ends among them.
std::vector<ProfilePoint> resampled(const std::vector<ProfilePoint>& line, double spacing) {
  std::vector<double> arc{0.0};
  for (std::size_t k = 1; k < line.size(); ++k)
    arc.push_back(arc.back() + distance(line[k - 1], line[k]));
  const int count = std::max(1, static_cast<int>(std::lround(arc.back() / spacing)));
  std::vector<ProfilePoint> points;
  std::size_t segment = 1;
  for (int k = 0; k < count; ++k) {
    const double s = arc.back() * k / count;
    while (arc[segment] <= s) ++segment;
    const ProfilePoint &a = line[segment - 1], &b = line[segment];
    const double w = (s - arc[segment - 1]) / (arc[segment] - arc[segment - 1]);
    points.push_back({(1 - w) * a.r + w * b.r, (1 - w) * a.z + w * b.z});
  }
  points.push_back(line.back());
  return points;
}

}  // namespace

std::vector<ProfilePoint> exposure_profile(const std::vector<Part>& parts, double spacing) {
  Fan fan{topmost_centre(parts)};
  for (const Part& part : parts)
    if (part.cutting == Cutting::cuts) add_part(part, fan);
  const std::vector<ProfilePoint> line = outline(fan);
  if (line.size() < 2) throw InputError("exposure profile: found no cutting part, expected one");
  return resampled(line, spacing);
}

}  // namespace tdbd::bit
