#include "bit/profile/exposure_profile.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "mesh/measures.hpp"

namespace tdbd::bit {
namespace {

/// m; the curve of an edge in (r, z) is approximated by chords. Dimensions of drawings are not
/// multiples of this length, so rounding a coordinate to single precision does not change the
/// number of chords.
constexpr double chord = 1.93e-4;
constexpr int ray_count = 2048;
constexpr double on_axis = 1e-12;  ///< m; a point closer to the axis is on it

/// The farthest point on one ray; distance 0: none yet.
struct Ray {
  double distance2 = 0.0;
  ProfilePoint farthest;
};

/// Rays in a quarter circle about the axis point at height z0, from straight down to horizontal.
/// They are equally spaced in r / (r + depth), which increases with the angle and is fast to
/// compute.
struct Fan {
  double z0;
  std::vector<Ray> rays = std::vector<Ray>(ray_count);

  /// Index of the ray through a point, with its fraction. Larger than the last index above the
  /// horizontal.
  double at(const ProfilePoint& p) const {
    const double sum = p.r + p.z - z0;
    return sum > 0.0 ? p.r / sum * (ray_count - 1) : 2.0 * ray_count;
  }
  void add(const ProfilePoint& p, Ray& ray) const {
    const double distance2 = p.r * p.r + (p.z - z0) * (p.z - z0);
    if (distance2 > ray.distance2) ray = {distance2, p};
  }
  /// Adds the crossings of the chord ab, whose ends are at the ray indices at_a and at_b.
  void add(const ProfilePoint& a, double at_a, const ProfilePoint& b, double at_b) {
    const double first = std::ceil(std::min(at_a, at_b)),
                 last = std::min(std::max(at_a, at_b), ray_count - 1.0);
    if (first > last) return;  // points just above the horizontal have indices beyond any int
    for (int k = static_cast<int>(first); k <= last; ++k) {
      const double w = at_a == at_b ? 0.0 : (k - at_a) / (at_b - at_a);
      add({a.r + w * (b.r - a.r), a.z + w * (b.z - a.z)}, rays[k]);
    }
  }
};

double topmost_centre(const std::vector<Part>& parts) {
  double z0 = std::numeric_limits<double>::infinity();
  for (const Part& part : parts) {
    if (part.cutting != Cutting::cuts) continue;
    const mesh::Box box = mesh::bounding_box(part.mesh_P);
    z0 = std::min(z0, (part.X_BP * Vec3(0.5 * (box.lo + box.hi))).z());
  }
  return z0;
}

ProfilePoint in_half_plane(const Vec3& x_B) {
  return {std::sqrt(x_B.x() * x_B.x() + x_B.y() * x_B.y()), x_B.z()};
}

/// Adds chords of a curve one by one; the next one begins at `last`.
struct Pen {
  ProfilePoint last;
  double at_last;

  void draw_to(const ProfilePoint& next, Fan& fan) {
    const double at_next = fan.at(next);
    fan.add(last, at_last, next, at_next);
    last = next;
    at_last = at_next;
  }
};

/// The point of an edge that is nearest to the axis.
struct Nearest {
  double share;  ///< of the way from a to b; outside (0, 1) if the edge has no such interior point
  ProfilePoint point;
};

Nearest nearest_to_axis(const Vec3& a_B, const Vec3& b_B) {
  const Vec3 d = b_B - a_B;
  const double across2 = d.x() * d.x() + d.y() * d.y();
  if (across2 == 0.0) return {-1.0, {}};
  const double share = -(a_B.x() * d.x() + a_B.y() * d.y()) / across2;
  ProfilePoint p = in_half_plane(a_B + share * d);
  if (p.r < on_axis) p.r = 0.0;
  return {share, p};
}

/// In (r, z), an edge that passes the axis has a bend at its nearest point. If the bend is narrower
/// than a chord, a chord would skip it and miss the rays near the axis.
void add_edge(const Vec3& a_B, const Vec3& b_B, Fan& fan) {
  const int steps = 1 + static_cast<int>((b_B - a_B).norm() / chord);
  const Nearest nearest = nearest_to_axis(a_B, b_B);
  const bool has_bend = nearest.share > 0.0 && nearest.share < 1.0 && nearest.point.r < chord;
  Pen pen{in_half_plane(a_B), 0.0};
  pen.at_last = fan.at(pen.last);
  for (int k = 1; k <= steps; ++k) {
    const double before = static_cast<double>(k - 1) / steps,
                 share = static_cast<double>(k) / steps;
    if (has_bend && nearest.share > before && nearest.share <= share)
      pen.draw_to(nearest.point, fan);
    pen.draw_to(in_half_plane(a_B + (b_B - a_B) * share), fan);
  }
}

/// A flat triangle folds in (r, z) where it passes the axis: at each height the point nearest to
/// the axis lies in the vertical plane through the axis and the triangle's normal. There the border
/// of its image is not the image of an edge. For a horizontal triangle, any such plane contains its
/// point on the axis.
void add_fold(const std::array<Vec3, 3>& x_B, Fan& fan) {
  Vec3 across = Vec3::UnitZ().cross(mesh::area_vector(x_B[0], x_B[1], x_B[2]));
  if (across.isZero(0.0)) across = Vec3::UnitX();
  std::vector<Vec3> ends;
  for (int k = 0; k < 3; ++k) {
    const Vec3 &a = x_B[k], &b = x_B[(k + 1) % 3];
    const double from = across.dot(a), to = across.dot(b);
    if ((from < 0.0) != (to < 0.0)) ends.push_back(a + from / (from - to) * (b - a));
  }
  if (ends.size() == 2) add_edge(ends[0], ends[1], fan);
}

/// Adds every edge of a closed mesh once: in the direction in which its first index is the smaller
/// one.
void add_part(const Part& part, Fan& fan) {
  std::vector<Vec3> x_B;
  for (const Vec3& x_P : part.mesh_P.positions) x_B.push_back(part.X_BP * x_P);
  for (const mesh::Triangle& t : part.mesh_P.triangles) {
    for (int k = 0; k < 3; ++k)
      if (t[k] < t[(k + 1) % 3]) add_edge(x_B[t[k]], x_B[t[(k + 1) % 3]], fan);
    add_fold({x_B[t[0]], x_B[t[1]], x_B[t[2]]}, fan);
  }
}

/// The profile from the axis to the gage, without empty rays and with monotonic r.
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

/// Points at equal arc lengths along a polyline, including both ends.
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
    points.push_back({std::lerp(a.r, b.r, w), std::lerp(a.z, b.z, w)});
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

namespace {

/// Bounding box of the parts in the (r, z) half-plane, as (r, 0, z).
mesh::Box box_in_half_plane(const std::vector<Part>& parts) {
  mesh::Box box;
  for (const Part& part : parts)
    for (const Vec3& x_P : part.mesh_P.positions) {
      const Vec3 x_B = part.X_BP * x_P;
      box.add({std::hypot(x_B.x(), x_B.y()), 0.0, x_B.z()});
    }
  return box;
}

double distance(const ProfilePoint& p, const Vec3& x) {
  return std::hypot(p.r - x.x(), p.z - x.z());
}

}  // namespace

Vec3 profile_direction(const std::vector<ProfilePoint>& profile, const std::vector<Part>& parts,
                       DirectionRule rule, InsideRule inside) {
  const mesh::Box box = box_in_half_plane(parts);
  const Vec3 middle = 0.5 * (box.lo + box.hi);
  const auto nearest = std::min_element(profile.begin(), profile.end(),
                                        [&](const ProfilePoint& a, const ProfilePoint& b) {
                                          return distance(a, middle) < distance(b, middle);
                                        });
  const double half_chord = 0.5 * box.size().maxCoeff();
  auto first = nearest, last = nearest;
  while (first != profile.begin() && distance(*first, {nearest->r, 0.0, nearest->z}) < half_chord)
    --first;
  while (last + 1 != profile.end() && distance(*last, {nearest->r, 0.0, nearest->z}) < half_chord)
    ++last;
  return update_direction(Vec3(first->z - last->z, 0.0, last->r - first->r), rule, inside);
}

}  // namespace tdbd::bit
