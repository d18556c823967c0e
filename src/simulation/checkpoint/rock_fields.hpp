#pragma once

#include "rock/rock.hpp"
#include "simulation/checkpoint/tape_items.hpp"

namespace tdbd::simulation {

template <class A>
void fields(A& a, Of<A, rock::MovedIn>& x) {
  a.number(x.first);
  a.number(x.last);
}

template <class A>
void fields(A& a, Of<A, rock::PressedVertex>& x) {
  a.number(x.v);
  item(a, x.d_W);
  a.number(x.hold);
}

template <class A>
void fields(A& a, Of<A, rock::CarriedDisplacement>& x) {
  a.number(x.v);
  item(a, x.from);
  item(a, x.weight);
}

template <class A>
void fields(A& a, Of<A, rock::LeftVertex>& x) {
  a("v", x.v);
  a("part", x.part);
  a("left_W", x.left_W);
}

/// The surface with all its slots, dead ones too: vertices and triangles keep their numbers. The
/// stars' neighbours follow from the rest (refresh_stars).
template <class A>
void fields(A& a, Of<A, mesh::Surface>& x) {
  std::vector<double> places;
  std::vector<std::int32_t> corners;
  if constexpr (A::writes) {
    places.reserve(3 * x.stars.size());
    for (const mesh::VertexStar& star : x.stars)
      places.insert(places.end(), {star.x.x(), star.x.y(), star.x.z()});
    corners.reserve(3 * x.triangles.size());
    for (const mesh::Triangle& t : x.triangles) corners.insert(corners.end(), t.begin(), t.end());
  }
  a("places", places);
  a("corners", corners);
  a("opposite", x.opposite);
  a("corner_of", x.corner_of);
  a("boundary", x.boundary);
  a("free_vertices", x.free_vertices);
  a("free_triangles", x.free_triangles);
  if constexpr (!A::writes) {
    x.stars.resize(places.size() / 3);
    for (std::size_t v = 0; v < x.stars.size(); ++v)
      x.stars[v].x = Vec3(places[3 * v], places[3 * v + 1], places[3 * v + 2]);
    x.triangles.resize(corners.size() / 3);
    for (std::size_t t = 0; t < x.triangles.size(); ++t)
      x.triangles[t] = {corners[3 * t], corners[3 * t + 1], corners[3 * t + 2]};
  }
}

/// Without its index, which follows from the surface.
template <class A>
void fields(A& a, Of<A, rock::Rock>& x) {
  a("surface", x.surface);
  a("last_part", x.last_part);
  a("touched", x.touched);
  a("touched_list", x.touched_list);
  a("cuts", x.cuts);
  a("moved_in", x.moved_in);
  a("pressed", x.pressed);
  a("carried", x.carried);
  a("left", x.left);
}

}  // namespace tdbd::simulation
