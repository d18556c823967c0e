#pragma once

#include <vector>

#include "core/types.hpp"

namespace tdbd::reference {

/// Equal teeth around a cone, as in the models of thesis chapter 2: spheres about their tips.
struct RollerRow {
  double along = 0.0;          ///< L, m, along the journal, outwards from the foot of the common
                               ///< perpendicular of journal and bit axis
  double radius = 0.0;         ///< rho, m, distance of the teeth's tips from the journal
  double tooth_radius = 0.0;   ///< m, of the sphere
  std::vector<double> angles;  ///< gamma_0, rad about the journal; 0: lowest
};

/// A cone on its journal.
struct RollerCone {
  double azimuth = 0.0;        ///< rad, of the journal about the bit's +z
  double journal_angle = 0.0;  ///< beta, rad, of the journal below the horizontal
  double offset = 0.0;         ///< e, m, of the journal in the direction of rotation
  double elevation = 0.0;      ///< z0, m, of the foot of the common perpendicular; z down
  double inertia = 0.0;        ///< Ic, kg m2, about the journal
  std::vector<RollerRow> rows;
};

/// The cones of a roller cone bit.
struct RollerBit {
  std::vector<RollerCone> cones;
};

/// Right-handed unit axes of a cone's journal in the frame (e_r, e_t, e_z) of its azimuth: `s`
/// along the journal, inwards and down; `u` perpendicular to it, down; s x u = e_t.
struct JournalAxes {
  Vec3 s, u;
};
JournalAxes journal_axes(const RollerCone& cone);

}  // namespace tdbd::reference
