#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"
#include "forces/rock/strength.hpp"

namespace tdbd::forces {

/// Rock in layers between parallel planes, level or dipping.
struct Formation {
  Vec3 normal_W = Vec3(0, 0, 1);  ///< unit normal of the planes, towards the deeper layers
  std::vector<double> tops;  ///< m, normal_W . x of the planes, ascending: tops of layers 1, 2, ...
  std::vector<Strength> strengths;  ///< of layers 0, 1, ...: one more than tops
};

/// The normal of beds that dip by an angle (rad, from horizontal) towards an azimuth (rad, about +z
/// from +x), in which direction they get deeper (z is down).
Vec3 bedding_normal(double dip, double azimuth);

/// The layer of a point: 0 above the first plane. A point on a plane belongs to the layer below.
/// Run time is logarithmic in the number of layers; does not allocate.
std::size_t layer_at(const Formation& formation, const Vec3& x_W);

/// The strength of the rock at a point.
const Strength& strength_at(const Formation& formation, const Vec3& x_W);

/// Why this is not a valid formation (wrong number of strengths, planes out of order, a normal that
/// is not a unit vector, a strength that is not positive); empty if it is valid.
std::string formation_problem(const Formation& formation);

}  // namespace tdbd::forces
