#include "bit/profile/profile_direction.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/measures.hpp"

namespace tdbd::bit {
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
