#include "mesh/repair/sheet.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <utility>

#include "mesh/check/check.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/measures.hpp"
#include "mesh/repair/repair_steps.hpp"

namespace tdbd::mesh {

std::vector<Opening> openings(const TriangleMesh& m) {
  std::vector<Opening> found;
  for (std::vector<int>& loop : boundary_loops(m)) {
    Opening o;
    Box box;
    for (const int v : loop) {
      box.add(position(m, v));
      o.centre += position(m, v) / static_cast<double>(loop.size());
    }
    o.across = box.size().norm();
    o.loop = std::move(loop);
    found.push_back(std::move(o));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Opening& a, const Opening& b) { return a.across > b.across; });
  return found;
}

std::string describe(const Opening& opening, const std::string& what) {
  return fmt::format("{} of {} edges, {:.4g} mm across, at {}", what, opening.loop.size(),
                     1e3 * opening.across, in_mm(opening.centre));
}

std::size_t fill_sheet_holes(TriangleMesh& m, std::string& refusal) {
  drop_unused_points(m);
  std::vector<std::vector<int>> holes;
  const std::vector<Opening> all = openings(m);
  for (std::size_t i = 1; i < all.size(); ++i) holes.push_back(all[i].loop);
  return fill_loops(m, holes, refusal);
}

void flip(TriangleMesh& m) {
  for (Triangle& t : m.triangles) std::swap(t[1], t[2]);
}

void turn_about_x(TriangleMesh& m) {
  for (Vec3& x : m.positions) x = Vec3(x.x(), -x.y(), -x.z());
}

bool faces_down(const TriangleMesh& m) {
  double down = 0.0;
  for (std::size_t i = 0; i < m.triangles.size(); ++i) {
    const auto [a, b, c] = corners(m, i);
    down += area_vector(a, b, c).z();
  }
  return down >= 0.0;
}

std::vector<std::string> sheet_faults(const TriangleMesh& m) {
  std::vector<std::string> lines;
  std::istringstream text(summarize(check_surface(m)));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  if (!lines.empty()) return lines;
  if (faces_down(m))
    lines.push_back(fmt::format("the facets face down, into the rock (z points down): {}",
                                upside_down_question));
  const auto pairs = self_intersections(m);
  if (!pairs.empty())
    lines.push_back(fmt::format("intersecting pairs of facets: {}, the first {} and triangle {}",
                                pairs.size(), place_of_triangle(m, pairs.front().first),
                                pairs.front().second));
  return lines;
}

}  // namespace tdbd::mesh
