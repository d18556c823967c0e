#include "simulation/start/reach.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mesh/measures.hpp"
#include "simulation/start/rock_memory.hpp"

namespace tdbd::simulation {
namespace {

/// Distance from the origin of the bit to the farthest cutting point, m.
double cutting_radius(const bit::Bit& bit) {
  double farthest = 0.0;
  for (const bit::Part& part : bit.parts)
    if (part.cutting == bit::Cutting::cuts)
      for (const Vec3& x_P : part.mesh_P.positions)
        farthest = std::max(farthest, (part.X_BP * x_P).norm());
  return farthest;
}

mesh::Box box_of(const mesh::Surface& rock) {
  mesh::Box box;
  for (const mesh::Triangle& t : rock.triangles)
    if (t[0] >= 0)
      for (const int v : t) box.add(rock.position(v));
  return box;
}

}  // namespace

double gap_on_the_way(const Case& c, const mesh::Surface& rock) {
  const Vec3 around = Vec3::Constant(cutting_radius(c.bit));
  const mesh::Box way = reach_W(c), there = box_of(rock);
  const Vec3 below = there.lo - (way.hi + around), above = (way.lo - around) - there.hi;
  return below.cwiseMax(above).cwiseMax(0.0).norm();
}

std::vector<CaseWarning> reach_warnings(const Case& c, const mesh::Surface& rock) {
  const double gap = gap_on_the_way(c, rock);
  if (gap == 0.0) return {};
  return {{c.places.motion, std::string(motion_keys::table.name),
           fmt::format("the bit stays {:.3g} m or more from the rock and cuts nothing", gap)}};
}

}  // namespace tdbd::simulation
