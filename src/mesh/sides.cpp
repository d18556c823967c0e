#include "mesh/sides.hpp"

#include <algorithm>
#include <tuple>

namespace tdbd::mesh {
namespace {

Side side_of(const std::vector<Triangle>& triangles, int corner) {
  const Triangle& c = triangles[at(corner / 3)];
  const int from = c[at((corner + 1) % 3)], to = c[at((corner + 2) % 3)];
  return {std::min(from, to), std::max(from, to), corner / 3, from < to, corner};
}

template <class Visit>
void visit_sides(const std::vector<Triangle>& triangles, Visit visit) {
  for (int corner = 0; corner < 3 * static_cast<int>(triangles.size()); ++corner)
    if (triangles[at(corner / 3)][0] >= 0) visit(side_of(triangles, corner));
}

/// Start index of the sides of each lower vertex, followed by the total number of sides.
std::vector<std::size_t> starts_by_lower_vertex(const std::vector<Triangle>& triangles) {
  std::vector<std::size_t> starts;
  visit_sides(triangles, [&](const Side& s) {
    if (at(s.lo) + 2 > starts.size()) starts.resize(at(s.lo) + 2, 0);
    ++starts[at(s.lo) + 1];
  });
  for (std::size_t v = 1; v < starts.size(); ++v) starts[v] += starts[v - 1];
  return starts;
}

}  // namespace

std::vector<Side> sorted_sides(const std::vector<Triangle>& triangles) {
  const std::vector<std::size_t> starts = starts_by_lower_vertex(triangles);
  if (starts.empty()) return {};
  std::vector<std::size_t> next = starts;
  std::vector<Side> sides(starts.back());
  visit_sides(triangles, [&](const Side& s) { sides[next[at(s.lo)]++] = s; });
  for (std::size_t v = 0; v + 1 < starts.size(); ++v)
    std::sort(sides.begin() + static_cast<std::ptrdiff_t>(starts[v]),
              sides.begin() + static_cast<std::ptrdiff_t>(starts[v + 1]),
              [](const Side& a, const Side& b) {
                return std::tie(a.hi, a.corner) < std::tie(b.hi, b.corner);
              });
  return sides;
}

}  // namespace tdbd::mesh
