#pragma once

#include "reference/literature/drag/wear/glowka_cutter.hpp"

namespace tdbd::reference {

/// A wear flat: a plane along the motion truncates a long cylinder whose face leans back by b.
/// `worn` is the lost height y (m), measured on the face, so it is y cos b along the profile's
/// normal. Derived from this shape, not from a source. Back rakes must be above 0: the flat of a
/// face normal to the motion would be infinite.

/// m2: A_seg(y)/sin b.
double flat_area(const GlowkaFace& face, double worn);

/// m, length along the motion at its longest: y/sin b.
double flat_length(const GlowkaFace& face, double worn);

/// m3, lost by the cutter: cot b int_0^y A_seg, in closed form.
double worn_volume(const GlowkaFace& face, double worn);

/// Heating of a flat. The rock is a half-space that slides past, the cutter a thermal resistance.
/// The formula is from memory of Glowka and Stone (confidence 0.8) and follows from a band of heat
/// on a half-space.
struct FlatHeat {
  double friction = 0.0;              ///< mu
  double rock_conductivity = 0.0;     ///< k_r, W/(m K)
  double rock_diffusivity = 0.0;      ///< alpha_r, m2/s
  double cutter_resistance = 0.0;     ///< f, K m2/W, of the cutter from its flat to the fluid
  double fluid_temperature = 293.15;  ///< K
};

/// Mean temperature (K) of a flat under this normal force: T_fluid + q f g/(f + g), with the heat
/// of friction q = mu Fn v/Aw and the rock's share g = 4/(3 sqrt pi) sqrt(alpha_r L/v)/k_r.
double flat_temperature(const FlatHeat& heat, double normal_force, double speed, double area,
                        double length);

/// PROPOSAL. That cutters wear faster above some 350 C is stated in the abstract of SPE 14222
/// (thermal wear). The threshold is from memory (confidence 0.8). The form, volume per work of the
/// normal force times an exponential above the threshold, is our assumption.
struct WearLaw {
  double coefficient = 0.0;           ///< C0, m3/(N m)
  double threshold = 350.0 + 273.15;  ///< K
  double growth = 50.0;               ///< T1, K: increase that multiplies the wear rate by e
};

/// C(T), m3/(N m).
double wear_coefficient(const WearLaw& law, double temperature);

/// dy/dt (m/s) of a flat under a mean stress: (C Fn v)/(A_seg cot b) with Fn = stress A_seg/sin b,
/// which is C stress v/cos b. So at a steady stress and temperature, height is lost at a constant
/// rate, as in Archard's law.
double wear_speed(const WearLaw& law, const GlowkaFace& face, double temperature, double stress,
                  double speed);

}  // namespace tdbd::reference
