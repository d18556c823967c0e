#include "simulation/rock_start.hpp"

#include "bit/exposure_profile.hpp"
#include "core/error.hpp"
#include "mesh/check.hpp"
#include "mesh/files.hpp"
#include "mesh/measures.hpp"
#include "rock/borehole.hpp"

namespace tdbd::simulation {
namespace {

mesh::TriangleMesh conforming(const Case& c) {
  std::vector<rock::MeridianPoint> curve;
  for (const bit::ProfilePoint& p : bit::exposure_profile(c.bit.parts, 0.25 * c.rock.edge_length))
    curve.push_back({p.r, p.z});
  return rock::borehole(rock::with_wall(std::move(curve), c.rock.wall), c.rock.edge_length);
}

/// A flat bottom at the depth of the bit's lowest cutting point.
mesh::TriangleMesh flat(const Case& c) {
  double lowest = -1e300;
  for (const bit::Part& p : c.bit.parts)
    if (p.cutting == bit::Cutting::cuts)
      for (const Vec3& x_P : p.mesh_P.positions) lowest = std::max(lowest, (p.X_BP * x_P).z());
  const double radius = c.rock.radius > 0.0 ? c.rock.radius : c.bit.gage_radius;
  return rock::borehole(rock::flat_bottom(radius, lowest, c.rock.wall), c.rock.edge_length);
}

mesh::TriangleMesh from_file(const Case& c) {
  mesh::TriangleMesh m = mesh::read_mesh(c.rock.file, c.rock.unit);
  const auto defects = mesh::check_surface(m);
  if (!defects.empty())
    throw InputError(c.rock.file + ": found " + mesh::describe(defects, 8) +
                     "; expected one open, consistently oriented surface");
  return m;
}

mesh::TriangleMesh start_mesh(const Case& c) {
  switch (c.rock.shape) {
    case RockShape::conforming:
      return conforming(c);
    case RockShape::flat:
      return flat(c);
    case RockShape::file:
      return from_file(c);
  }
  return {};
}

/// Where the bit's cutting parts go during the run: start and end poses and the path between.
mesh::Box reach_W(const Case& c) {
  mesh::Box box;
  const double r = c.bit.gage_radius + c.motion.whirl.radius;
  for (const double t : {0.0, c.time.step * static_cast<double>(c.time.steps)}) {
    const Vec3 p = pose_at(c.motion, t).p;
    box.add(p - Vec3(r, r, 0.0));
    box.add(p + Vec3(r, r, 0.0));
  }
  return box;
}

}  // namespace

rock::Rock start_rock(const Case& c) {
  constexpr double cell_over_edge = 2.0;
  return rock::make_rock(mesh::make_surface(start_mesh(c)), cell_over_edge * c.rock.edge_length,
                         reach_W(c));
}

}  // namespace tdbd::simulation
