#include "reference/rock/contact_polygon.hpp"

namespace tdbd::reference {

Vec3 contact_area_vector(const mesh::TriangleMesh& part_W, double plane_z, const Vec3& move_W,
                         double ramp) {
  Vec3 sum = Vec3::Zero();
  for (const mesh::Triangle& t : part_W.triangles) {
    const Vec3 &a = part_W.positions[at(t[0])], &b = part_W.positions[at(t[1])],
               &c = part_W.positions[at(t[2])];
    const Vec3 n = (b - a).cross(c - a).normalized();
    const double into = n.dot(move_W), along = n.cross(move_W).norm();
    if (into < 0.0) continue;
    const double share = into >= ramp * along ? 1.0 : into / (ramp * along);
    std::vector<Vec3> below;
    for (int i = 0; i < 3; ++i) {
      const Vec3 &x = part_W.positions[at(t[at(i)])], &y = part_W.positions[at(t[at((i + 1) % 3)])];
      const double from = x.z() - plane_z, to = y.z() - plane_z;
      if (from >= 0.0) below.push_back(x);
      if ((from >= 0.0) != (to >= 0.0)) below.push_back(x + from / (from - to) * (y - x));
    }
    for (std::size_t i = 2; i < below.size(); ++i)
      sum -= share * 0.5 * (below[i - 1] - below[0]).cross(below[i] - below[0]);
  }
  return sum;
}

}  // namespace tdbd::reference
