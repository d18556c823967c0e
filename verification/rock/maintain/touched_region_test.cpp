#include "rock/maintain/touched_region.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "rock/maintain/maintain.hpp"
#include "rock/maintain/ring_notes.hpp"
#include "verification/rock/bumpy_sheet.hpp"

namespace tdbd::rock::touched_region_test {

/// A crumpled sheet some of whose vertices are touched, and limits around its edges of 0.3.
struct Touched {
  Rock rock = rock_of(any_sheet(*battery::number(0.1, 1.2)));
  MaintenanceLimits limits = limits_for(*battery::number(0.2, 0.5));
  std::vector<int> vertices;

  Touched() {
    limits.worst_quality = *battery::number(0.01, 0.5);
    limits.flip_quality = *battery::number(0.0, 1.0);
    limits.smooth_quality = *battery::number(0.0, 1.0);
    limits.smoothing = Smoothing::tangential;
    for (int k = *battery::integer(1, 12); k > 0; --k) {
      vertices.push_back(*battery::integer(0, rock.surface.vertex_slots() - 1));
      touch(rock, vertices.back());
    }
  }
};

std::vector<int> sorted(std::vector<int> list) {
  std::ranges::sort(list);
  return list;
}

Vec3 area_of(const mesh::Surface& s, int t) {
  const auto& [a, b, c] = s.triangles[at(t)];
  return mesh::area_vector(s.position(a), s.position(b), s.position(c));
}

double quality_of(const mesh::Surface& s, int t) {
  const auto& [a, b, c] = s.triangles[at(t)];
  return mesh::triangle_quality(s.position(a), s.position(b), s.position(c));
}

double edge_of(const mesh::Surface& s, int t, std::size_t i) {
  const mesh::Triangle& v = s.triangles[at(t)];
  return (s.position(v[(i + 1) % 3]) - s.position(v[(i + 2) % 3])).norm();
}

/// Whether a neighbour lies back to back: the normals are more than 120 degrees apart.
bool is_folded(const mesh::Surface& s, int t) {
  for (int c = 3 * t; c < 3 * t + 3; ++c) {
    const int o = s.opposite_of(c);
    if (o >= 0 && area_of(s, t).normalized().dot(area_of(s, o / 3).normalized()) < -0.5)
      return true;
  }
  return false;
}

/// Of the triangles at touched vertices, each once, those of which a limit says so.
RC_GTEST_PROP(TouchedRegion, has_every_touched_triangle_under_what_it_needs, ()) {
  Touched x;
  const mesh::Surface& s = x.rock.surface;
  TouchedRegion region;
  region.fine_rings = FineRings::classified;
  std::vector<int> unknown;
  begin_notes(x.rock, x.limits, OldNotes::used, unknown);
  classify_touched_triangles(x.rock, x.limits, region);
  const auto wanted = [&](const std::function<bool(int)>& is_wanted) {
    std::vector<int> found;
    for (int t = 0; t < s.triangle_slots(); ++t)
      if (std::ranges::any_of(s.triangles[at(t)],
                              [&](int v) { return std::ranges::count(x.vertices, v) > 0; }) &&
          is_wanted(t))
        found.push_back(t);
    return found;
  };
  const auto shortest = [&](int t) {
    return std::min({edge_of(s, t, 0), edge_of(s, t, 1), edge_of(s, t, 2)});
  };
  const auto longest = [&](int t) {
    return std::max({edge_of(s, t, 0), edge_of(s, t, 1), edge_of(s, t, 2)});
  };
  const MaintenanceLimits& l = x.limits;
  RC_ASSERT(sorted(region.triangles) == wanted([](int) { return true; }));
  RC_ASSERT(region.asked == static_cast<long>(region.triangles.size()));
  RC_ASSERT(sorted(region.with_long_edges) ==
            wanted([&](int t) { return longest(t) > l.longest_edge; }));
  RC_ASSERT(sorted(region.to_flip) ==
            wanted([&](int t) { return quality_of(s, t) < l.flip_quality; }));
  RC_ASSERT(sorted(region.to_smooth) ==
            wanted([&](int t) { return quality_of(s, t) < l.smooth_quality; }));
  RC_ASSERT(sorted(region.steep) == wanted([&](int t) {
              return -area_of(s, t).z() < 0.5 * l.shortest_edge * l.shortest_edge;
            }));
  RC_ASSERT(sorted(region.to_collapse) == wanted([&](int t) {
              return shortest(t) < l.shortest_edge || quality_of(s, t) < l.worst_quality ||
                     is_folded(s, t);
            }));
  for (int t = 0; t < s.triangle_slots(); ++t) {
    const int place = place_of(region, t);
    if (place >= 0)
      RC_ASSERT(region.triangles[at(place)] == t);
    else
      RC_ASSERT(std::ranges::count(region.triangles, t) == 0);
  }
}

/// The figures that the limits are compared with are squares of those that they are told of.
RC_GTEST_PROP(Shape, has_squared_lengths_and_quality, ()) {
  const Rock rock = rock_of(any_sheet(*battery::number(0.1, 1.0)));
  const mesh::Surface& s = rock.surface;
  for (int t = 0; t < s.triangle_slots(); ++t) {
    const Shape shape = shape_of(s, t);
    for (std::size_t i = 0; i < 3; ++i)
      RC_ASSERT(std::abs(std::sqrt(shape.edge2[i]) - edge_of(s, t, i)) < 1e-14);
    RC_ASSERT(std::abs(std::sqrt(shape.quality2) - quality_of(s, t)) < 1e-14);
    RC_ASSERT((0.5 * shape.doubled_area - area_of(s, t)).norm() < 1e-15);
  }
}

/// After a classification only what is touched again has changed.
TEST(TouchedRegion, finds_what_changed_since) {
  Rock rock = rock_of(battery::bumpy_rock(1.5, 10, 0.1, 7));
  for (const int v : {40, 50, 60}) touch(rock, v);
  TouchedRegion region;
  std::vector<int> unknown;
  begin_notes(rock, limits_for(0.3), OldNotes::used, unknown);
  classify_touched_triangles(rock, limits_for(0.3), region);
  find_changed(rock, region);
  EXPECT_TRUE(region.changed.empty());
  touch(rock, 50);
  touch(rock, 70);
  find_changed(rock, region);
  EXPECT_EQ(sorted(region.changed), (std::vector{50, 70}));
}

}  // namespace tdbd::rock::touched_region_test
