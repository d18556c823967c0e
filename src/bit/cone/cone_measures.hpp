#pragma once

#include "bit/bit.hpp"
#include "bit/mass_properties.hpp"

namespace tdbd::bit {

/// A cone's mass and its deviation from the assumptions of the integrator (thesis: 5.1): dynamic
/// symmetry about its axis, with its centre of mass on it.
struct ConeMass {
  MassProperties body_K;         ///< of shell and teeth, in K at angle 0
  double axial_inertia = 0.0;    ///< kg m2, Ic, about the journal's axis
  double asymmetry = 0.0;        ///< (It1 - It2) / Ic, transverse inertias about the centre
  double centre_off_axis = 0.0;  ///< m
};

/// Computes the mass of one cone, shell and teeth. `cone`: index into Bit::cones.
ConeMass cone_mass(const Bit& bit, int cone);

/// Where a row of teeth cuts.
struct RowMeasures {
  double radius = 0.0;         ///< m, of the tip from the journal's axis
  double bit_radius = 0.0;     ///< m, of the tip from the bit's axis when it is deepest
  double height = 0.0;         ///< m, of the tip above the bit's origin at that place
  double reach = 0.0;          ///< m, largest radius of the teeth from the bit's axis
  double rolling_ratio = 0.0;  ///< bit_radius / radius: cone's speed over the bit's; 0 on the axis
};

/// The deepest place of a point of a cone at `radius` (m) from the journal's axis and z_K (m) along
/// it.
Vec3 deepest_B(const Cone& cone, double radius, double z_K);

/// The measures of a row of a cone.
RowMeasures row_measures(const Cone& cone, const ToothRow& row);

}  // namespace tdbd::bit
