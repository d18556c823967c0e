#pragma once

#include <cstdint>
#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::rock {

/// A random rough surface: Gaussian heights of correlation exp(-d^2 / (2 l^2)) at distance d. The
/// same seed gives the same surface.
struct Roughness {
  double amplitude = 0.0;           ///< m, root mean square
  double correlation_length = 0.0;  ///< l, m
  std::uint64_t seed = 1;
};

/// One plane wave of it.
struct Wave {
  double kx = 0.0, ky = 0.0, phase = 0.0;  ///< rad/m, rad/m, rad
};

/// The waves of a rough surface: a sum of n cosines whose wave vectors are drawn from the spectrum
/// of the correlation (Gaussian, 1/l each way) and whose phases are uniform (Shinozuka's spectral
/// representation). Gaussian in the limit of many waves.
std::vector<Wave> rough_waves(const Roughness& r);

/// Depth of the surface below its mean at (x, y), m: amplitude sqrt(2/n) sum cos(k.x + phase).
double roughness_at(const Roughness& r, const std::vector<Wave>& waves, double x, double y);

/// Makes the flat bottom of a borehole (flat_bottom) rough: every vertex moves down by how far the
/// surface at its (x, y) lies below its highest value at any vertex; on the wall by a share that
/// falls to zero at the top, so that the highest place stays where the bottom was and the boundary
/// of a wall does not move.
void roughen_bottom(mesh::TriangleMesh& borehole, const Roughness& r);

}  // namespace tdbd::rock
