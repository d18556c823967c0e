#pragma once

namespace tdbd::reference {

/// Rock properties that all models of drag bits can share: forces linear in the area that a cutter
/// cuts, and in that of its wear flat. The comparison calibrates them once for all models.
struct DragRock {
  double specific_energy = 0.0;  ///< eps, Pa: drag of a sharp cutter over its area
  double normal_ratio = 0.0;     ///< zeta: force into the rock over drag of a sharp cutter
  double contact_stress = 0.0;   ///< sigma, Pa, under a wear flat
  double friction = 0.0;         ///< mu, of a wear flat
};

}  // namespace tdbd::reference
