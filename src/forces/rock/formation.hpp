#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"
#include "forces/rock/strength.hpp"

namespace tdbd::forces {

/// Rock in layers between parallel planes: level beds, or beds that dip.
struct Formation {
  Vec3 normal_W = Vec3(0, 0, 1);  ///< unit, of the planes, towards the deeper layers
  std::vector<double> tops;  ///< m, normal_W . x of the planes, rising: tops of layers 1, 2, ...
  std::vector<Strength> strengths;  ///< of layers 0, 1, ...: one more than tops
};

/// The normal of beds that dip by an angle (rad, from horizontal) towards an azimuth (rad, about +z
/// from +x), on which side they lie deeper (z points down).
Vec3 bedding_normal(double dip, double azimuth);

/// The layer of a point: 0 above the first plane; a point on a plane belongs to the layer below.
/// Costs the logarithm of the number of layers; does not allocate.
std::size_t layer_at(const Formation& formation, const Vec3& x_W);

/// The strength of the rock at a point.
const Strength& strength_at(const Formation& formation, const Vec3& x_W);

/// Why this is not a formation (not one strength more than planes, planes out of order, a normal
/// that is not a unit vector, a strength that is not positive); empty if it is one.
std::string formation_problem(const Formation& formation);

}  // namespace tdbd::forces
