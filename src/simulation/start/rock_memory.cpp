#include "simulation/start/rock_memory.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

constexpr double bytes_per_triangle = 250.0;
constexpr double bytes_per_cell = 4.2;
constexpr double most_triangles = 7e8;  // three corners each, indexed by int
constexpr double most_cells = 2e9;      // indexed by int

double memory_of_machine() {
  return static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

bool fits_machine(const RockNeed& need) {
  return need.triangles <= most_triangles && need.cells <= most_cells &&
         need.bytes <= memory_of_machine();
}

/// Area of the cylinder that the gage of the bit sweeps on its way down.
double area_of_new_wall(const Case& c, const mesh::Box& reach) {
  return 2.0 * std::numbers::pi * c.bit.gage_radius * reach.size().z();
}

}  // namespace

RockNeed need_of(double area, const mesh::Box& box_W, double edge_length) {
  constexpr double cell_over_edge = 2.0;
  RockNeed need;
  need.triangles = area * 4.0 / std::numbers::sqrt3 / (edge_length * edge_length);
  need.cells = (box_W.size().array() / (cell_over_edge * edge_length) + 1.0).prod();
  need.bytes = bytes_per_triangle * need.triangles + bytes_per_cell * need.cells;
  return need;
}

double bytes_of_triangles(double triangles) { return bytes_per_triangle * triangles; }

RockNeed need_of_new_wall(const Case& c) {
  const mesh::Box reach = reach_W(c);
  return need_of(area_of_new_wall(c, reach), reach, c.rock.edge_length);
}

mesh::Box reach_W(const Case& c) {
  mesh::Box box;
  const double r = c.bit.gage_radius + c.motion.whirl.radius;
  const auto add = [&](const Vec3& p) {
    box.add(p - Vec3(r, r, 0.0));
    box.add(p + Vec3(r, r, 0.0));
  };
  for (const long steps : {c.time.first, c.time.steps})
    add(pose_at(c.motion, time_at(c.time, steps)).p);
  for (const PathPoint& p : c.motion.path) add(p.p_WB);
  return box;
}

void require_memory(const Case& c, double area, mesh::Box box_W) {
  const mesh::Box reach = reach_W(c);
  box_W.add(reach.lo);
  box_W.add(reach.hi);
  area += area_of_new_wall(c, reach);
  const RockNeed need = need_of(area, box_W, c.rock.edge_length);
  if (fits_machine(need)) return;
  double edge = c.rock.edge_length;
  constexpr double finest_step = 1.1;
  for (int k = 0; k < 400 && !fits_machine(need_of(area, box_W, edge)); ++k) edge *= finest_step;
  throw InputError(fmt::format(
      "{}: found {} m, which makes {:.1e} triangles and {:.1e} cells of rock on a way of {:.3g} m "
      "and needs {:.3g} GB, expected at most {:.3g} GB (this machine's memory), {:.0e} triangles "
      "and {:.0e} cells: {:.2g} m is enough",
      c.places.edge_length, c.rock.edge_length, need.triangles, need.cells, reach.size().norm(),
      1e-9 * need.bytes, 1e-9 * memory_of_machine(), most_triangles, most_cells, edge));
}

}  // namespace tdbd::simulation
