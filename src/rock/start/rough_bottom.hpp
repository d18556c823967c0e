#pragma once

#include <cstdint>
#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::rock {

/// A random rough surface: Gaussian heights with the correlation exp(-d^2 / (2 l^2)) at distance d.
/// Equal seeds give equal surfaces.
struct Roughness {
  double amplitude = 0.0;           ///< m, root mean square
  double correlation_length = 0.0;  ///< l, m
  std::uint64_t seed = 1;
};

/// One plane wave of a rough surface.
struct Wave {
  double kx = 0.0, ky = 0.0, phase = 0.0;  ///< rad/m, rad/m, rad
};

/// The waves of a rough surface: a sum of n cosines with wave vectors drawn from the spectrum of
/// the correlation (Gaussian, 1/l in each direction) and uniform phases (Shinozuka's spectral
/// representation). Gaussian in the limit of many waves.
std::vector<Wave> rough_waves(const Roughness& r);

/// Depth of the surface below its mean at (x, y), m: amplitude sqrt(2/n) sum cos(k.x + phase).
double roughness_at(const Roughness& r, const std::vector<Wave>& waves, double x, double y);

/// Makes the flat bottom of a borehole (flat_bottom) rough. Every vertex moves down by the depth of
/// the rough surface at its (x, y) below its highest value at any vertex. On the wall this
/// displacement is scaled by a factor that falls to zero at the top. So the highest point of the
/// bottom and the boundary of the wall do not move.
void roughen_bottom(mesh::TriangleMesh& borehole, const Roughness& r);

}  // namespace tdbd::rock
