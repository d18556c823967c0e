#pragma once

#include <cstddef>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// How a cutter's rim is brought into the (r, z) half-plane.
enum class OutlineForm {
  planar,  ///< as the ellipse that it shows along the motion, without side rake
  turned   ///< each of its points turned about the axis
};

/// The lower branch of one cutter's outline, at the centres of columns of radius.
struct CutterColumns {
  std::size_t first = 0;      ///< column of depth[0]
  std::vector<double> depth;  ///< m, bit frame; no_depth where a flat has left nothing
  double share = 0.0;         ///< azimuth in turns, from 0 to below 1
};

/// All cutters of a bit. Column k is centred at (k + 1/2) width.
struct RadialOutlines {
  double reach = 0.0;  ///< m, the widest rim's; the columns end there
  double width = 0.0;  ///< m
  std::size_t columns = 0;
  std::vector<CutterColumns> of_cutter;
  std::vector<std::size_t> order;  ///< of passes: falling azimuth, as the bit turns about +z
};

/// Columns are at most `column` wide (m). Rims are cut off at their wear flats.
RadialOutlines radial_outlines(const std::vector<bit::Cutter>& cutters, OutlineForm form,
                               double column);

/// What every cutter cuts in steady drilling, in the order of the cutters.
struct PlanarCut {
  std::vector<double> area;                 ///< m2, in the (r, z) half-plane
  std::vector<double> volume;               ///< m3 per revolution
  std::vector<std::vector<double>> height;  ///< m, removed in each of the cutter's columns
  std::vector<double> bottom;               ///< m, of each column; no_depth: never touched
  int revolutions = 0;                      ///< until two agreed

  /// Radius at which the cutter's volume lies (m): V/(2 pi A); 0 if it cuts nothing.
  double arm(std::size_t cutter) const;
};

/// The plane of Warren and Sinor (1986; thesis 2.1): in a half-plane fixed in space a cutter at
/// azimuth phi passes when the bit has turned by 2 pi k - phi, and then is deeper by
/// advance (k - phi/(2 pi)). Passes, in order of time, remove what lies between outline and bottom.
/// Revolutions are repeated until the heights removed in two of them agree; the last one is
/// reported. Seen: outlines turned into one plane, areas from the interaction of cutters.
/// Reconstructed: all else. `advance`: m per revolution.
PlanarCut planar_cut(const RadialOutlines& outlines, double advance);
PlanarCut planar_cut(const std::vector<bit::Cutter>& cutters, double advance, double column);

/// The same into arrays that have their size from an earlier call.
void planar_cut(const RadialOutlines& outlines, double advance, PlanarCut& cut);

}  // namespace tdbd::reference
