#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// How two surfaces are compared: at points at most `spacing` apart, of those within
/// [-half, half]^2 of the x-y plane. m.
struct HausdorffSampling {
  double spacing = 0.0;
  double half = 0.0;
};

/// Largest distance of a sample of `from` to the nearest point of `to`, m: the one-sided Hausdorff
/// distance, from below to within `spacing`. Triangles are found by bins of the x-y plane, which
/// suits sheets. Cost: samples times the triangles in a few bins, less where the largest distance
/// is found early.
double one_sided_hausdorff(const mesh::TriangleMesh& from, const mesh::TriangleMesh& to,
                           const HausdorffSampling& sampling);

/// The larger of both directions, m.
double hausdorff(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b,
                 const HausdorffSampling& sampling);

/// Distance of a point from a triangle, m.
double distance_to_triangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace tdbd::reference
