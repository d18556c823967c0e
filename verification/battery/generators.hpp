#pragma once

#include <rapidcheck.h>

#include "core/random.hpp"
#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

/// RapidCheck generators. Every double is made from an integer, so that counterexamples shrink to
/// few and round numbers. Lengths in m.
namespace tdbd::battery {

/// Integers in [first, last], each as likely; shrinks towards the one nearest 0. (RapidCheck's own
/// ranges start small at their lower end: points would crowd into one corner of their cube.)
rc::Gen<int> integer(int first, int last);

/// Multiples of 1/1000 in [lo, hi] (lo and hi in the same unit); shrinks towards the one nearest 0.
rc::Gen<double> number(double lo, double hi);

/// Points of the cube [-half, half]^3.
rc::Gen<Vec3> point(double half);

/// A stream of random numbers with an arbitrary seed. To be called within a property.
Random any_random();

/// Unit vectors, all directions.
rc::Gen<Vec3> direction();

/// Rotations, from quaternions of small integers; shrinks towards the identity.
rc::Gen<Mat3> rotation();

/// Any rotation, and a translation in the cube [-half, half]^3.
rc::Gen<Pose> pose(double half);

/// Convex polyhedra: hulls of a tetrahedron about the origin and up to 12 points of the unit cube.
rc::Gen<mesh::TriangleMesh> convex_polyhedron();

/// Star-shaped about the origin, nonconvex: spheres of 80 triangles whose vertices went to radii
/// between 0.4 and 1.
rc::Gen<mesh::TriangleMesh> star_shape();

/// Prisms over an L, a U or a star of random proportions, turned anyhow about the origin; within a
/// ball of radius 1.5.
rc::Gen<mesh::TriangleMesh> nonconvex_prism();

}  // namespace tdbd::battery
