#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// The deepest pass of one cutter at one radius, relative to a half-plane fixed in space.
struct Deepest {
  static constexpr double never = -std::numeric_limits<double>::infinity();

  double phi = 0.0;      ///< rad, azimuth of the deepest point
  double depth = never;  ///< m, its z - advance phi / (2 pi); `never`: radius not reached
};

/// A bit's cutters in the (r, z) half-plane, in columns of equal width from the axis to `reach`.
struct RadialColumns {
  double reach = 0.0;                         ///< largest radius of any cutting cutter, m
  double width = 0.0;                         ///< m
  std::vector<std::vector<Deepest>> deepest;  ///< [column][index in Bit::cutters]

  double centre(std::size_t column) const { return (static_cast<double>(column) + 0.5) * width; }
};

/// Computes what each cutter of a bit leaves at each radius if the bit turns about +z and advances
/// along +z by `advance` (m) per revolution. Uses all mesh edges of the cutters' cutting parts,
/// sampled at half of radial_spacing (m), with linear interpolation, evaluated at the columns'
/// centres.
RadialColumns radial_columns(const bit::Bit& bit, double advance, double radial_spacing);

}  // namespace tdbd::reference
