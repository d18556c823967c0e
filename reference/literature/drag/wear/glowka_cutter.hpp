#pragma once

namespace tdbd::reference {

/// A round cutter face in Glowka's model.
struct GlowkaFace {
  double radius = 0.0;     ///< a, m
  double back_rake = 0.0;  ///< b, rad, within 80 degrees of 0
};

/// A force, or a stress, as a power of the effective depth of cut: value
/// (de/reference_depth)^power. Fits in lbf and inches only need their units changed: 5925 lbf at 1
/// in.
struct DepthLaw {
  double value = 0.0;             ///< N or Pa, at the reference depth
  double reference_depth = 1e-3;  ///< m
  double power = 1.0;
};

double at_depth(const DepthLaw& law, double depth);

/// Area (m2) of the segment of a face up to this height (m) above its edge: A_seg(y) = a^2 acos(1 -
/// y/a) - (a - y) sqrt(2ay - y^2), the whole face from y = 2a on.
double segment_area(double face_radius, double height);

/// Area (m2), normal to the motion, of the cut in flat rock that no cutter has cut before ("virgin
/// groove"), with the depth `depth` along the profile's normal: A_seg(de/cos b) cos b.
double virgin_area(const GlowkaFace& face, double depth);

/// The inverse (m): the depth of the virgin groove whose cut has this area. That the laws use this
/// depth when cutters interact is from memory of Glowka's work (JPT, August 1989), with low
/// confidence: reconstructed. Forty bisections of [0, 2a cos b]. Areas larger than the face's give
/// its whole depth.
double effective_depth(const GlowkaFace& face, double area);

/// The laws of one cutter. The force on a sharp cutter is a power of the effective depth alone. A
/// wear flat adds a stress that increases with a power of the depth, and friction. The stress under
/// a flat is from memory of Glowka's form. That it is added to the sharp cutter's force is our
/// assumption, so that a run can start with sharp cutters.
struct GlowkaLaw {
  DepthLaw normal{};           ///< N, into the rock, of the sharp cutter
  DepthLaw drag{};             ///< N, against the motion, of the sharp cutter
  DepthLaw flat_stress{};      ///< Pa, under the flat
  double flat_friction = 0.0;  ///< mu_d
};

/// Forces of the rock on one cutter, sharp part and flat separately, N.
struct GlowkaForces {
  double normal = 0.0, drag = 0.0;
  double flat_normal = 0.0, flat_drag = 0.0;
};

/// The forces on a cutter that cuts nothing are zero.
GlowkaForces glowka_forces(const GlowkaLaw& law, double depth, double flat_area);

}  // namespace tdbd::reference
