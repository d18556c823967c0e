#pragma once

#include <cstddef>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::reference {

/// How a cutter's rim is mapped to the (r, z) half-plane.
enum class OutlineForm {
  planar,  ///< its projection along the motion, an ellipse, without side rake
  turned   ///< each of its points rotated about the axis
};

/// The lower branch of one cutter's outline, at the centres of columns of radius.
struct CutterColumns {
  std::size_t first = 0;      ///< column of depth[0]
  std::vector<double> depth;  ///< m, bit frame; no_depth where a flat left no material
  double share = 0.0;         ///< azimuth in turns, in [0, 1)
};

/// All cutters of a bit. Column k is centred at (k + 1/2) width.
struct RadialOutlines {
  double reach = 0.0;  ///< m, of the widest rim; the columns end there
  double width = 0.0;  ///< m
  std::size_t columns = 0;
  std::vector<CutterColumns> of_cutter;
  std::vector<std::size_t> order;  ///< of passes: descending azimuth (the bit turns about +z)
};

/// Makes the outlines with columns of at most `column` (m). Rims are truncated at their wear flats.
RadialOutlines radial_outlines(const std::vector<bit::Cutter>& cutters, OutlineForm form,
                               double column);

/// What every cutter cuts in steady drilling, in the order of the cutters.
struct PlanarCut {
  std::vector<double> area;                 ///< m2, in the (r, z) half-plane
  std::vector<double> volume;               ///< m3 per revolution
  std::vector<std::vector<double>> height;  ///< m, removed in each of the cutter's columns
  std::vector<double> bottom;               ///< m, of each column; no_depth: never cut
  int revolutions = 0;                      ///< number of revolutions until two agreed

  /// Mean radius of the cutter's volume (m): V/(2 pi A); 0 if it cuts nothing.
  double arm(std::size_t cutter) const;
};

/// The single plane of Warren and Sinor (1986; thesis 2.1). In a half-plane fixed in space, a
/// cutter at azimuth phi passes when the bit has turned by 2 pi k - phi, and then is deeper by
/// advance (k - phi/(2 pi)). Passes, in order of time, remove what lies between outline and bottom.
/// Revolutions are repeated until the heights removed in two of them agree; the last one is
/// reported. Stated in the thesis: outlines rotated into one plane, areas from the interaction of
/// cutters. Reconstructed: everything else. `advance`: m per revolution.
PlanarCut planar_cut(const RadialOutlines& outlines, double advance);
PlanarCut planar_cut(const std::vector<bit::Cutter>& cutters, double advance, double column);

/// The same into arrays that an earlier call has sized.
void planar_cut(const RadialOutlines& outlines, double advance, PlanarCut& cut);

}  // namespace tdbd::reference
