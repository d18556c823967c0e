#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"
#include "forces/rock/strength.hpp"

namespace tdbd::forces {

/// Rock in layers between parallel planes: horizontal beds, or beds that dip.
struct Formation {
  Vec3 normal_W = Vec3(0, 0, 1);  ///< unit, of the planes, to the deeper layers
  std::vector<double> tops;  ///< m, normal_W . x of the planes, rising: tops of layers 1, 2, ...
  std::vector<Strength> strengths;  ///< of layers 0, 1, ...: one more than tops
};

/// The direction across beds that dip by an angle (rad, from horizontal) to the side of an azimuth
/// (rad, about +z from +x), in which they lie deeper (z is down).
Vec3 bedding_normal(double dip, double azimuth);

/// The layer of a point: 0 above the first plane; a point on a plane belongs to the layer below.
/// Cost: logarithm of the layers; no allocation.
std::size_t layer_at(const Formation& formation, const Vec3& x_W);

/// The strength of the rock at a point.
const Strength& strength_at(const Formation& formation, const Vec3& x_W);

/// Why this is no formation (not one strength more than planes, planes that do not rise, a normal
/// that is not unit, a strength that is not positive); empty: nothing.
std::string formation_problem(const Formation& formation);

}  // namespace tdbd::forces
