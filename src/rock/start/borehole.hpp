#pragma once

#include <cstdint>
#include <vector>

#include "core/types.hpp"
#include "mesh/triangle_mesh.hpp"

namespace tdbd::rock {

/// A point of a meridian curve: radius and depth (z down), m.
struct MeridianPoint {
  double r, z;
};

/// Makes a rock surface of revolution about the z axis. The meridian curve runs from the axis (r =
/// 0) along the bottom and up the wall. Rings of about 2 pi r / edge_length points are placed at an
/// arc spacing of 0.866 edge_length. The normal points out of the rock (up, and towards the axis on
/// the wall). The last ring is the only boundary loop. Thesis: 4.4.1 (reconstructed).
mesh::TriangleMesh borehole(const std::vector<MeridianPoint>& curve, double edge_length);

/// The bottom curve, continued by a vertical wall of height `wall` (m) above its last point.
std::vector<MeridianPoint> with_wall(std::vector<MeridianPoint> bottom, double wall);

/// A flat bottom at depth z inside a wall of height `wall`, m.
std::vector<MeridianPoint> flat_bottom(double radius, double z, double wall);

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
