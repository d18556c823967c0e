#pragma once

namespace tdbd::forces {

/// The strength of the rock where a part meets it. Thesis: app. C (Scc, P), nomenclature.
struct Strength {
  double unconfined = 0.0;      ///< Pa, compressive strength without confinement
  double confined = 0.0;        ///< Pa, the same under the bottom hole's pressure (Scc)
  double friction_angle = 0.0;  ///< rad, internal (Mohr-Coulomb)
  double pressure = 0.0;        ///< Pa, of the bottom hole (P)
};

}  // namespace tdbd::forces
