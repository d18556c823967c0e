#pragma once

#include "mesh/triangle_mesh.hpp"

namespace tdbd::reference {

/// Sampling for the comparison of two surfaces: points at most `spacing` apart, within [-half,
/// half]^2 of the x-y plane. m.
struct HausdorffSampling {
  double spacing = 0.0;
  double half = 0.0;
};

/// Largest distance of a sample of `from` to the nearest point of `to`, m: the one-sided Hausdorff
/// distance, underestimated by at most `spacing`. Triangles are found in bins of the x-y plane,
/// which is efficient for sheets. The run time is proportional to the samples times the triangles
/// in a few bins, and less if the largest distance is found early.
double one_sided_hausdorff(const mesh::TriangleMesh& from, const mesh::TriangleMesh& to,
                           const HausdorffSampling& sampling);

/// The larger of the distances in both directions, m.
double hausdorff(const mesh::TriangleMesh& a, const mesh::TriangleMesh& b,
                 const HausdorffSampling& sampling);

/// Distance of a point from a triangle, m.
double distance_to_triangle(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace tdbd::reference
