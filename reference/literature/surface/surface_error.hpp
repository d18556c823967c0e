#pragma once

#include <vector>

#include "bit/bit.hpp"
#include "reference/literature/surface/z_map.hpp"

namespace tdbd::reference {

/// Distance of one surface from another along the bit's profile normal, over a ring of the bottom.
/// Lengths in m.
struct SurfaceError {
  double r_lo = 0.0, r_hi = 0.0;
  double mean_signed = 0.0;  ///< positive: the surface is deeper than the reference
  double mean = 0.0, rms = 0.0, p95 = 0.0, p99 = 0.0;  ///< of absolute values
  double volume = 0.0;                                 ///< m3 by which the surface's hole is larger
  long samples = 0;
};

/// Cosine of the profile's angle as a function of the radius, from the tips of a bit's cutters: the
/// factor from a difference in depth to a distance along the normal.
struct ProfileCosine {
  std::vector<double> radius, angle;  ///< m, ascending; rad
  double at(double r) const;
};
ProfileCosine profile_cosine(const bit::Bit& bit);

/// Errors of `surface` relative to `reference` (height fields with the same cells), one per ring
/// between adjacent `radii` (m, ascending), over all cells whose centres are in the ring. The
/// profile's normal is used on the steps between grooves, too; on their flanks this exceeds the
/// nearest distance. Throws std::invalid_argument if the cells differ.
std::vector<SurfaceError> surface_errors(const ZMap& reference, const ZMap& surface,
                                         const ProfileCosine& cosine,
                                         const std::vector<double>& radii);

/// A coarse height field interpolated bilinearly to the cells of another one.
ZMap resampled(const ZMap& coarse, const ZMap& cells_of);

}  // namespace tdbd::reference
