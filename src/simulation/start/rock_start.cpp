#include "simulation/start/rock_start.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <utility>

#include "bit/cone/swept_parts.hpp"
#include "bit/profile/exposure_profile.hpp"
#include "core/error.hpp"
#include "mesh/check/check.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/files/files.hpp"
#include "mesh/measures.hpp"
#include "rock/start/borehole.hpp"
#include "rock/start/space_order.hpp"
#include "simulation/start/rock_memory.hpp"
#include "simulation/start/rock_stamp.hpp"

namespace tdbd::simulation {
namespace {

[[noreturn]] void refuse(const Case& c, const std::string& found, const std::string& expected) {
  throw InputError(fmt::format("{}: found {}, expected {}", c.rock.file, found, expected));
}

/// A surface that intersects itself does not say which side is rock. Checked once; takes some
/// seconds for a million triangles.
void require_no_intersections(const Case& c, const std::string& place,
                              const mesh::TriangleMesh& m) {
  if (c.rock.intersections == IntersectionCheck::none) return;
  const auto pairs = mesh::self_intersections(m);
  if (pairs.empty()) return;
  throw InputError(fmt::format(
      "{}: found {} pairs of triangles that intersect, the first {} and triangle {}, expected a "
      "surface that does not intersect itself (rock.intersection_check = \"off\" admits it)",
      place, pairs.size(), mesh::place_of_triangle(m, pairs.front().first), pairs.front().second));
}

/// Edges far from edge_length suggest a wrong unit.
void require_plausible_edges(const Case& c, const mesh::TriangleMesh& m) {
  constexpr double factor = 20.0;
  const double triangles = static_cast<double>(m.triangles.size());
  const double edge = std::sqrt(mesh::area(m) / triangles * 4.0 / std::numbers::sqrt3);
  if (edge * factor < c.rock.edge_length || edge > factor * c.rock.edge_length)
    refuse(c,
           fmt::format("edges of about {:.3g} mm with rock.unit = {} m", 1e3 * edge, c.rock.unit),
           fmt::format("edges near rock.edge_length, {:.3g} mm", 1e3 * c.rock.edge_length));
}

/// Its normals point out of the rock: up, on the whole.
void require_facing_up(const Case& c, const mesh::TriangleMesh& m) {
  double down = 0.0;
  for (const mesh::Triangle& t : m.triangles)
    down +=
        mesh::area_vector(m.positions[at(t[0])], m.positions[at(t[1])], m.positions[at(t[2])]).z();
  if (down >= 0.0)
    refuse(c, "all facets flipped (they face down, into the rock)", "facets that face up (z down)");
}

/// "a; b" of "a\nb\n".
std::string in_one_line(const std::string& lines) {
  std::string text;
  for (std::size_t i = 0; i < lines.size(); ++i)
    text += lines[i] != '\n' ? std::string(1, lines[i]) : i + 1 < lines.size() ? "; " : "";
  return text;
}

mesh::TriangleMesh from_file(const Case& c) {
  require_same_time(c);
  mesh::TriangleMesh m = mesh::read_mesh(c.rock.file, c.rock.unit);
  const auto defects = mesh::check_surface(m);
  if (!defects.empty())
    refuse(c, in_one_line(mesh::describe(defects, 8)), "one open, consistently oriented surface");
  require_facing_up(c, m);
  require_plausible_edges(c, m);
  require_memory(c, mesh::area(m), mesh::bounding_box(m));
  require_no_intersections(c, c.rock.file, m);
  return m;
}

mesh::Box box_of(const std::vector<rock::MeridianPoint>& curve) {
  mesh::Box box;
  for (const rock::MeridianPoint& p : curve) {
    box.add({-p.r, -p.r, p.z});
    box.add({p.r, p.r, p.z});
  }
  return box;
}

mesh::TriangleMesh make_borehole(const Case& c, const std::vector<rock::MeridianPoint>& curve) {
  double area = 0.0;
  for (std::size_t i = 1; i < curve.size(); ++i)
    area += std::numbers::pi * (curve[i - 1].r + curve[i].r) *
            std::hypot(curve[i].r - curve[i - 1].r, curve[i].z - curve[i - 1].z);
  require_memory(c, area, box_of(curve));
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

mesh::TriangleMesh rough(const Case& c) {
  mesh::TriangleMesh m = flat(c);
  rock::roughen_bottom(m, c.rock.roughness);
  return m;
}

/// Any meridian: one that crosses itself makes no rock.
mesh::TriangleMesh of_profile(const Case& c) {
  mesh::TriangleMesh m = make_borehole(c, c.rock.profile);
  require_no_intersections(c, c.places.profile, m);
  return m;
}

mesh::TriangleMesh start_mesh(const Case& c) {
  switch (c.rock.shape) {
    case RockShape::conforming:
      return conforming(c);
    case RockShape::flat:
      return flat(c);
    case RockShape::rough:
      return rough(c);
    case RockShape::profile:
      return of_profile(c);
    case RockShape::file:
      return from_file(c);
  }
  return {};
}

}  // namespace

/// A file keeps its numbers, so that a run goes on from it as it would have without.
rock::Rock start_rock(const Case& c) {
  constexpr double cube_over_edge = 8.0;
  mesh::TriangleMesh m = start_mesh(c);
  if (c.rock.shape != RockShape::file)
    m = rock::in_order_of_space(m, cube_over_edge * c.rock.edge_length);
  return indexed_rock(c, mesh::make_surface(m));
}

rock::Rock indexed_rock(const Case& c, mesh::Surface surface) {
  constexpr double cell_over_edge = 2.0;
  return rock::make_rock(std::move(surface), cell_over_edge * c.rock.edge_length, reach_W(c));
}

}  // namespace tdbd::simulation
