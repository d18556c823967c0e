#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "mesh/facet.hpp"
#include "rock/maintain/collapse.hpp"
#include "rock/maintain/star.hpp"
#include "verification/battery/generators.hpp"
#include "verification/rock/bumpy_sheet.hpp"

namespace tdbd::rock::collapse_distance_test {

/// The corners around v of triangles without `beside`, from v on.
std::vector<mesh::Facet> triangles_around(const mesh::Surface& s, int v, int beside) {
  std::vector<mesh::Facet> found;
  mesh::visit_corners(s, v, [&](int c) {
    const int p = s.vertex(mesh::next_corner(c)), q = s.vertex(mesh::previous_corner(c));
    if (p != beside && q != beside) found.push_back({s.position(v), s.position(p), s.position(q)});
  });
  return found;
}

double distance_of(const std::vector<mesh::Facet>& facets, const Vec3& x_W, double least = 1e300) {
  for (const mesh::Facet& f : facets) least = std::min(least, mesh::squared_distance(f, x_W));
  return std::sqrt(least);
}

/// The guards on distance with every triangle measured from every place.
std::optional<Refusal> judge_all_distances(const mesh::Surface& s, int a, int b, const Vec3& x_W,
                                           const MaintenanceLimits& l, double& drifted) {
  std::vector<mesh::Facet> old, kept, replacing;
  for (const auto& [v, other] : {std::pair{a, b}, std::pair{b, a}}) {
    const auto all = triangles_around(s, v, -1), some = triangles_around(s, v, other);
    old.insert(old.end(), all.begin(), all.end());
    kept.insert(kept.end(), some.begin(), some.end());
  }
  for (const mesh::Facet& f : kept) replacing.push_back({x_W, f.b, f.c});
  const auto to_new = [&](const Vec3& from_W) {
    return distance_of(replacing, from_W, (x_W - from_W).squaredNorm());
  };
  drifted = 0.0;
  for (const mesh::Facet& f : kept)
    drifted = std::max(drifted, distance_of(old, 0.5 * (x_W + f.b)));
  for (const mesh::Facet& f : old) drifted = std::max(drifted, to_new(0.5 * (f.a + f.b)));
  for (const int v : {a, b}) {
    const double d = to_new(s.position(v));
    if (d > l.ridge_cut && is_on_ridge(s, v, l)) return Refusal::ridge;
    drifted = std::max(drifted, d);
  }
  return drifted > l.farthest ? std::optional(Refusal::distance) : std::nullopt;
}

/// Distances that cannot be the greatest are not computed: the verdict and the bits are the same. Of
/// crumpled sheets too, and of some whose vertices coincide.
RC_GTEST_PROP(CollapseDistance, is_that_from_every_triangle, ()) {
  Rock rock = rock_of(any_sheet(*battery::number(0.1, 1.2)));
  const mesh::Surface& s = rock.surface;
  MaintenanceLimits l = limits_for(0.9);
  l.farthest = *battery::number(0.0, 0.3);
  l.ridge_cut = *battery::number(0.0, 0.1);
  for (int c = *battery::integer(0, 12); c < 3 * s.triangle_slots(); c += 13) {
    const int a = s.vertex(mesh::next_corner(c)), b = s.vertex(mesh::previous_corner(c));
    if (s.is_boundary(a) || s.is_boundary(b)) continue;
    if (c % 5 == 0) rock.surface.place(a, s.position(b));
    if (c % 7 == 0) rock.surface.place(s.vertex(c), s.position(b));
    const Vec3 &x_a = s.position(a), &x_b = s.position(b);
    for (const Vec3& x_W : {x_a, x_b, Vec3(0.5 * (x_a + x_b))}) {
      double quick = 0.0, slow = 0.0;
      const auto verdict = judge_distance(s, a, b, x_W, l, {}, quick);
      RC_ASSERT(verdict == judge_all_distances(s, a, b, x_W, l, slow));
      if (!verdict) RC_ASSERT(quick == slow);
    }
  }
}

}  // namespace tdbd::rock::collapse_distance_test
