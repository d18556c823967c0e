#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "reference/literature/drag/plane/cutter_rim.hpp"
#include "reference/literature/drag/planes/bit_path.hpp"

namespace tdbd::reference {

/// A cutter's face for models on spokes, in the bit's frame B: a sharp disc.
struct SpokeCutter {
  Vec3 tip_B, centre_B, along_B;  ///< m; from the centre to the rim: to the tip, and across
  Vec3 face_B, normal_B;          ///< unit: face's outward normal; profile's normal into the rock
  double back_rake = 0.0, chamfer = 0.0, chamfer_angle = 0.0;
};

/// A cutter in its place, with its rim projected along the normal of the half-plane through the
/// hole's axis and its tip (exact when the tip crosses a spoke).
struct PlacedCutter {
  Vec3 tip_W;
  double cosine = 1.0, sine = 0.0;  ///< of the tip's azimuth about the hole's axis
  double radius = 0.0;              ///< m, of the tip from the hole's axis
  RimEllipse rim;
};

/// Makes the faces of a table of cutters (X_BC must be set). Throws InputError that begins with the
/// model's name if there is none, or one without a size.
std::vector<SpokeCutter> spoke_cutters(const std::vector<bit::Cutter>& cutters,
                                       const std::string& model);

PlacedCutter placed(const SpokeCutter& cutter, const BitPlace& place);

/// The largest radius that a rim reaches on a bit centred on the hole's axis, m.
double widest_reach(const std::vector<SpokeCutter>& cutters);

}  // namespace tdbd::reference
