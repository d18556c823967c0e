#pragma once

#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

/// Shapes that tests share, closed and oriented outwards unless they say otherwise. Lengths in m.
namespace tdbd::battery {

/// Box between two corners.
mesh::TriangleMesh box(const Vec3& lo, const Vec3& hi);

/// Cylinder about z between -length/2 and length/2: a regular polygon's prism, corner 0 at +x.
mesh::TriangleMesh cylinder(double radius, double length, int sides);

/// Prism over a simple counter-clockwise outline, from z = lo to z = hi.
mesh::TriangleMesh prism(const std::vector<Eigen::Vector2d>& outline, double lo, double hi);

/// Outlines for it: an L, a U (open towards +y) in a square about the origin with arms `arm` wide,
/// and a star.
std::vector<Eigen::Vector2d> l_outline(double size, double arm);
std::vector<Eigen::Vector2d> u_outline(double size, double arm);
std::vector<Eigen::Vector2d> star_outline(double outer, double inner, int points);

/// Torus about z: `around` times `across` quadrilaterals, each cut in two; vertices on the torus.
mesh::TriangleMesh torus(double major_radius, double minor_radius, int around, int across);

/// Icosahedron on the unit sphere, each triangle cut in four `levels` times: 20 * 4^levels
/// triangles, all vertices on the sphere.
mesh::TriangleMesh sphere(double radius, int levels);

/// Flat square [-half, half]^2 at z, of 2 n^2 triangles; normal along -z, as that of the rock.
mesh::TriangleMesh flat_rock(double half, double z, int n);

/// The mesh with every position moved by a pose.
mesh::TriangleMesh placed(const Pose& X, mesh::TriangleMesh m);

}  // namespace tdbd::battery
