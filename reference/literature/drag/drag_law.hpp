#pragma once

#include "reference/literature/drag/drag_rock.hpp"

namespace tdbd::reference {

/// Magnitudes of the rock's force on a cutter, N.
struct CutterForce {
  double cutting = 0.0;  ///< Fc, against the motion
  double normal = 0.0;   ///< Fn, out of the rock along the profile's normal
};

/// The law that models of drag bits share: Fc = eps A, Fn = zeta eps A, with the area A (m2) that
/// the cutter cuts. Reconstructed: of the authors' laws only the names were found.
inline CutterForce sharp_force(const DragRock& rock, double normal_ratio, double area) {
  const double cutting = rock.specific_energy * area;
  return {cutting, normal_ratio * cutting};
}

/// Force under a wear flat of this area, m2: Fn = sigma Aw, Fc = mu sigma Aw.
inline CutterForce flat_force(const DragRock& rock, double area) {
  const double normal = rock.contact_stress * area;
  return {rock.friction * normal, normal};
}

}  // namespace tdbd::reference
