#include "simulation/rock_start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "bit/exposure_profile.hpp"
#include "bit/swept_parts.hpp"
#include "core/error.hpp"
#include "mesh/check.hpp"
#include "mesh/files.hpp"
#include "mesh/measures.hpp"
#include "rock/borehole.hpp"

namespace tdbd::simulation {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

[[noreturn]] void refuse(const Case& c, const std::string& found, const std::string& expected) {
  throw InputError(fmt::format("{}: found {}, expected {}", c.rock.file, found, expected));
}

/// Edges far from edge_length speak for a wrong unit.
void demand_like_edges(const Case& c, const mesh::TriangleMesh& m) {
  constexpr double factor = 20.0;
  const double triangles = static_cast<double>(m.triangles.size());
  const double edge = std::sqrt(mesh::area(m) / triangles * 4.0 / std::numbers::sqrt3);
  if (edge * factor < c.rock.edge_length || edge > factor * c.rock.edge_length)
    refuse(c,
           fmt::format("edges of about {:.3g} mm with rock.unit = {} m", 1e3 * edge, c.rock.unit),
           fmt::format("edges near rock.edge_length, {:.3g} mm", 1e3 * c.rock.edge_length));
}

/// Its normals point out of the rock: up, on the whole.
void demand_facing_up(const Case& c, const mesh::TriangleMesh& m) {
  double down = 0.0;
  for (const mesh::Triangle& t : m.triangles)
    down +=
        mesh::area_vector(m.positions[at(t[0])], m.positions[at(t[1])], m.positions[at(t[2])]).z();
  if (down >= 0.0)
    refuse(c, "all facets flipped (they face down, into the rock)", "facets that face up (z down)");
}

mesh::TriangleMesh from_file(const Case& c) {
  mesh::TriangleMesh m = mesh::read_mesh(c.rock.file, c.rock.unit);
  const auto defects = mesh::check_surface(m);
  if (!defects.empty())
    refuse(c, mesh::describe(defects, 8), "one open, consistently oriented surface");
  demand_facing_up(c, m);
  demand_like_edges(c, m);
  return m;
}

/// A borehole of so many triangles that memory or patience would end first is a slip of the pen.
void demand_bearable(const Case& c, const std::vector<rock::MeridianPoint>& curve) {
  constexpr double most_triangles = 5e7;
  double area = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i)
    area += std::numbers::pi * (curve[i - 1].r + curve[i].r) *
            std::hypot(curve[i].r - curve[i - 1].r, curve[i].z - curve[i - 1].z);
  const double triangles = area * 4.0 / std::numbers::sqrt3 / std::pow(c.rock.edge_length, 2);
  if (triangles > most_triangles)
    throw InputError(fmt::format(
        "{}: rock.edge_length: found {} m, which makes {:.1e} triangles, expected at most {:.0e}",
        c.path, c.rock.edge_length, triangles, most_triangles));
}

mesh::TriangleMesh make_borehole(const Case& c, const std::vector<rock::MeridianPoint>& curve) {
  demand_bearable(c, curve);
  return rock::borehole(curve, c.rock.edge_length);
}

mesh::TriangleMesh conforming(const Case& c) {
  const double spacing = 0.25 * c.rock.edge_length;
  std::vector<rock::MeridianPoint> curve;
  for (const bit::ProfilePoint& p : bit::exposure_profile(bit::swept_parts(c.bit), spacing))
    curve.push_back({p.r, p.z});
  return make_borehole(c, rock::with_wall(std::move(curve), c.rock.wall));
}

/// A flat bottom at the depth of the bit's lowest cutting point in a turn of its cones.
mesh::TriangleMesh flat(const Case& c) {
  double lowest = -1e300;
  for (const bit::Part& p : bit::swept_parts(c.bit))
    for (const Vec3& x_P : p.mesh_P.positions) lowest = std::max(lowest, (p.X_BP * x_P).z());
  const double radius = c.rock.radius > 0.0 ? c.rock.radius : c.bit.gage_radius;
  return make_borehole(c, rock::flat_bottom(radius, lowest, c.rock.wall));
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

/// Where the bit's axis goes during the run, widened by the bit: start, end and a path's rows.
mesh::Box reach_W(const Case& c) {
  mesh::Box box;
  const double r = c.bit.gage_radius + c.motion.whirl.radius;
  const auto add = [&](const Vec3& p) {
    box.add(p - Vec3(r, r, 0.0));
    box.add(p + Vec3(r, r, 0.0));
  };
  for (const double t : {0.0, c.time.step * static_cast<double>(c.time.steps)})
    add(pose_at(c.motion, t).p);
  for (const PathPoint& p : c.motion.path) add(p.p_WB);
  return box;
}

/// The index has a cell for every place that the bit may come to.
void demand_near(const Case& c, const mesh::Box& reach, double cell) {
  constexpr double most_cells = 2e8;
  const double cells = (reach.size().array() / cell + 1.0).prod();
  if (cells > most_cells)
    throw InputError(fmt::format(
        "{}: motion: found a way of {:.3g} m, {:.0e} cells of rock, expected at most {:.0e} cells",
        c.path, reach.size().norm(), cells, most_cells));
}

}  // namespace

rock::Rock start_rock(const Case& c) {
  constexpr double cell_over_edge = 2.0;
  const double cell = cell_over_edge * c.rock.edge_length;
  const mesh::Box reach = reach_W(c);
  mesh::Surface surface = mesh::make_surface(start_mesh(c));
  demand_near(c, reach, cell);
  return rock::make_rock(std::move(surface), cell, reach);
}

}  // namespace tdbd::simulation
