#pragma once

namespace tdbd::forces {

/// The strength of the rock at the contact with a part. Thesis: app. C (Scc, P), nomenclature.
struct Strength {
  double unconfined = 0.0;      ///< Pa, compressive strength without confinement
  double confined = 0.0;        ///< Pa, compressive strength under bottom-hole pressure (Scc)
  double friction_angle = 0.0;  ///< rad, internal (Mohr-Coulomb)
  double pressure = 0.0;        ///< Pa, at the bottom of the hole (P)
};

}  // namespace tdbd::forces
