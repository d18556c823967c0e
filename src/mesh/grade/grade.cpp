#include "mesh/grade/grade.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "mesh/check/check.hpp"
#include "mesh/check/self_intersections.hpp"
#include "mesh/grade/grade_surface.hpp"
#include "mesh/measures.hpp"
#include "mesh/search/inside.hpp"

namespace tdbd::mesh {
namespace {

constexpr int most_rounds = 12;

/// Largest distance of the vertices, edge midpoints and centroids of a mesh from another surface,
/// up to `most`.
double farthest(const TriangleMesh& m, const TriangleTree& from, double most) {
  double worst = 0.0;
  const auto x = [&](int v) { return m.positions[at(v)]; };
  for (const auto& [a, b, c] : m.triangles)
    for (const Vec3& y : {x(a), Vec3(0.5 * (x(a) + x(b))), Vec3(0.5 * (x(b) + x(c))),
                          Vec3(0.5 * (x(c) + x(a))), Vec3((x(a) + x(b) + x(c)) / 3.0)})
      worst = std::max(worst, distance_up_to(from, y, most));
  return worst;
}

void require_bounds(const Graded& g, const TriangleMesh& m, const GradeSurface& surface) {
  const double most = surface.options.deviation + 10.0 * surface.rounding;
  if (g.deviation > most)
    throw RunError(
        fmt::format("grade: the surface moved by {:.3g} m, more than {:.3g} m", g.deviation, most));
  if (std::abs(g.volume_change) > most * area(m))
    throw RunError(fmt::format("grade: the volume changed by {:.3g} m3", g.volume_change));
  if (const auto defects = check_solid(g.mesh); !defects.empty())
    throw RunError("grade: the result bounds no solid: " + summarize(defects));
}

}  // namespace

Graded grade(const TriangleMesh& m, const GradeOptions& options) {
  if (const auto defects = check_solid(m); !defects.empty())
    throw InputError("a mesh that bounds no solid cannot be graded:\n" + summarize(defects));
  GradeSurface surface = make_grade_surface(m, options);
  Graded result;
  result.feature_edges = surface.features.size();
  for (int round = 0; round < most_rounds; ++round) {
    const std::size_t halved = refine(surface);
    flip(surface);
    const std::size_t collapsed = coarsen(surface);
    flip(surface);
    relax(surface);
    if (halved + collapsed == 0) break;
  }
  result.mesh = compact(surface.s);
  const double far = 2.0 * options.deviation + 100.0 * surface.rounding;
  result.deviation = std::max(farthest(result.mesh, surface.original, far),
                              farthest(m, TriangleTree(result.mesh), far));
  result.volume_change = enclosed_volume(result.mesh) - enclosed_volume(m);
  require_bounds(result, m, surface);
  return result;
}

}  // namespace tdbd::mesh
