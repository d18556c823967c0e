#pragma once

#include <span>
#include <string_view>

#include "forces/part/directions.hpp"
#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// Friction of gage pads, the body and the blunt sides of cutters, forces (11): a contact stress on
/// the contact area, limited by the strength of the rock, and Coulomb friction. An addition of TDBD
/// [+].
///   Fn <= min(stress, cap Scc) A,  Ft <= mu Fn;  forces (4) with ramp = tan full_angle
/// A pad that only slides along the wall has no normal force. If it moves into the wall at an angle
/// of at least full_angle, it has the full stress. full_angle = 0 is a rigid-plastic wear flat. mu
/// may decrease with speed (friction_at).
struct Friction {
  double stress = 0.0;           ///< Pa, contact stress
  double mu = 0.0;               ///< 1, coefficient of friction
  double cap = 1.5;              ///< 1, largest ratio of contact stress to confined strength
  double full_angle = 0.01;      ///< rad, angle of motion into the rock at which the stress is full
  double weakening = 0.0;        ///< 1, relative decrease of mu with speed, see friction_at
  double weakening_speed = 1.0;  ///< m/s
  double slip_speed = default_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "friction";
  static constexpr bool knows(bit::PartKind kind) {
    return kind != bit::PartKind::face && kind != bit::PartKind::tooth;
  }
  static constexpr bool presses(bit::PartKind kind) { return knows(kind); }
  static std::span<const Coefficient<Friction>> coefficients();
};

Pressing law_pressing(const Friction& law, const PartCut& cut);

/// A tooth or shell of a roller cone that is pressed into the rock, forces (12): a crushing
/// pressure on the contact, and Coulomb friction along the slip, which drives the cones. An
/// addition of TDBD [+]; its form is that of element laws in the literature, from memory.
///
///   Fn <= ratio Scc A,  Ft <= mu Fn          A: contact area seen along `normal`; forces (4)
/// The growth of the force with penetration follows from the contact area: linear for a wedge,
/// nearly linear for a sphere, quadratic for a cone. There is no elastic recovery: a tooth that
/// leaves the rock has no force.
struct Indentation {
  double ratio = 1.0;            ///< 1, ratio of crushing pressure to confined strength
  double mu = 0.3;               ///< 1, friction between tooth and rock
  double weakening = 0.0;        ///< 1, relative decrease of mu with speed, see friction_at
  double weakening_speed = 1.0;  ///< m/s
  double slip_speed = default_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "indentation";
  static constexpr bool knows(bit::PartKind kind) {
    return kind == bit::PartKind::tooth || kind == bit::PartKind::cone;
  }
  static constexpr bool presses(bit::PartKind kind) { return knows(kind); }
  static std::span<const Coefficient<Indentation>> coefficients();
};

Pressing law_pressing(const Indentation& law, const PartCut& cut);

/// No force: the part only cuts the rock.
struct NoForce {
  static constexpr std::string_view name = "none";
  static constexpr bool knows(bit::PartKind) { return true; }
  static std::span<const Coefficient<NoForce>> coefficients() { return {}; }
};

inline PartForce law_force(const NoForce&, const PartCut& cut) {
  return {.force = Vec3::Zero(), .point = cut.point, .normal = 0.0, .tangential = 0.0};
}

/// A round cutter that moves along flat, uncut rock.
struct GrooveCutter {
  double diameter = 0.0;   ///< m, > 0
  double back_rake = 0.0;  ///< rad, within 80 degrees of 0
};

/// The depth of a groove and the number of Newton steps used to compute it.
struct GrooveDepth {
  double depth = 0.0;  ///< m
  int iterations = 0;
};

/// Area of a groove of the given depth (m), normal to the motion: a segment of the face, A = a^2 (t
/// - sin t cos t) cos b with depth = a (1 - cos t) cos b, a = diameter/2, b = back rake. For depths
/// of 2 a cos b and more it is the whole face. Glowka (1989), "virgin groove".
double groove_area(const GrooveCutter& cutter, double depth);

/// The inverse of groove_area: the depth of the groove in flat rock with the given cut area (m2, >=
/// 0). This is Glowka's effective depth of cut on rock that other cutters have cut before. Uses
/// Newton's method from below, which converges because t - sin t cos t is convex (the other half of
/// the face by symmetry): at most 5 steps, to rounding. For areas larger than the face it returns
/// the full depth.
GrooveDepth groove_depth(const GrooveCutter& cutter, double area);

/// Power laws in the depth of cut, Glowka (1989), forces (9):
///   Fn = Cn (de/d0)^nn,  Fd = Cd (de/d0)^nd,  d0 = 1 mm
/// de is the depth of a groove in flat rock with the same cut area as the actual cut
/// (laws.hpp). The coefficients come from tests of one cutter at one speed and rake,
/// including chamfer and wear flat, so the other parts of the cutter should have no law of their
/// own. The effective depth is from memory of his work (RECONSTRUCTED). Fitted coefficients:
/// law.hpp. Requires the diameter of the cutter.
struct Glowka {
  double Cn = 0.0;                         ///< N, normal force at 1 mm
  double nn = 0.0;                         ///< 1, exponent of the normal force
  double Cd = 0.0;                         ///< N, drag at 1 mm
  double nd = 0.0;                         ///< 1, exponent of the drag
  double slip_speed = default_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "glowka";
  static constexpr double reference_depth = 1e-3;  // m, d0
  static constexpr bool needs_diameter = true;
  static constexpr bool knows(bit::PartKind kind) { return kind == bit::PartKind::face; }
  static std::span<const Coefficient<Glowka>> coefficients();
};

PartForce law_force(const Glowka& law, const PartCut& cut);

/// Cutting and friction of Detournay and Defourny (1992), forces (7), with the contact length of
/// Detournay, Richard and Shepherd (2008) for wear flats that are not in the mesh:
///   face:    Ft = eps Acut + mu Ff,  Fn = zeta eps Acut + Ff,  Ff = sigma De min(kappa depth, l)
///   chamfer: Fn = sigma A,  Ft = mu Fn         A: contact area, of worn meshes
///   other surfaces of a cutter: Fn <= sigma A,  Ft <= mu Fn,  forces (4)
/// mu may decrease with speed (friction_at). Summed over a bit: T = eps R^2 d/2, W = zeta eps R d,
/// and the friction line E = E0 + mu S of specific energy over drilling strength, E0 = (1 - mu
/// zeta) eps (gamma = 1 for even wear). The strengths are those of the rock under downhole
/// conditions: pressure has an effect only through eps and sigma.
struct Detournay {
  double eps = 0.0;        ///< Pa, intrinsic specific energy
  double zeta = 0.0;       ///< 1, ratio of normal to tangential force of a sharp face
  double sigma = 0.0;      ///< Pa, contact stress of a wear flat
  double mu = 0.0;         ///< 1, friction of a wear flat
  double l = 0.0;          ///< m, length of the wear flat along the motion if it is not in the mesh
  double kappa = 5.0;      ///< 1, growth of the contact length with the depth of cut
  double weakening = 0.0;  ///< 1, relative decrease of mu with speed, see friction_at
  double weakening_speed = 1.0;            ///< m/s
  double slip_speed = default_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "detournay";
  static constexpr bool knows(bit::PartKind kind) { return bit::belongs_to_a_cutter(kind); }
  static constexpr bool presses(bit::PartKind kind) { return bit::is_side_of_a_cutter(kind); }
  static std::span<const Coefficient<Detournay>> coefficients();
};

/// Force on faces and chamfers, forces (3).
PartForce law_force(const Detournay& law, const PartCut& cut);

/// Pressing of the other surfaces of a cutter, forces (4).
Pressing law_pressing(const Detournay& law, const PartCut& cut);

/// Thin cuts under pressure after Miedema, who explains the tests of Zijsling (1987) with this
/// model, forces (10). A chip slides up a shear plane at angle b and then along the face, at the
/// blade angle al = 90 deg + Ebr. The bottom-hole pressure p acts on both, over the heights hi of
/// the cut and hb of the chip:
///   C  = c A/sin b,  W1 = p A/sin b,  W2 = p A (hb/hi)/sin al          A = Acut
///   K2 = (W2 sin(al + b + phi) + W1 sin phi + C cos phi) / sin(al + b + phi + delta)
///   Ft = -W2 sin al + K2 sin(al + delta),  Fn = W2 cos al - K2 cos(al + delta)
/// with c = cohesion_share UCS (1 - sin phi)/(2 cos phi), delta = interface_share phi. Linear in
/// the area and in the pressure. The pressure is that of the bottom hole; pore pressure has no
/// effect (as Zijsling observed in Mancos shale). The back rake is limited to largest_back_rake and
/// the sum of the angles to 170 deg: beyond these, dead rock builds up in front of the face, and
/// the formula has a pole. Forces are not below 0. The formula is from memory; a test compares it
/// with Miedema's published table.
struct ThinCut {
  double shear_angle = 0.20943951023931953;  ///< rad, b: 12 degrees
  double blade_height = 4.04;                ///< 1, hb/hi
  double interface_share = 2.0 / 3.0;        ///< 1, delta/phi
  double cohesion_share = 1.0;  ///< 1, ratio of cohesion to that of unconfined strength and phi
  double largest_back_rake = 0.5235987755982988;  ///< rad: 30 degrees
  double slip_speed = default_slip_speed;         ///< m/s, see slip_share

  static constexpr std::string_view name = "thin-cut";
  static constexpr bool knows(bit::PartKind kind) { return kind == bit::PartKind::face; }
  static std::span<const Coefficient<ThinCut>> coefficients();
};

PartForce law_force(const ThinCut& law, const PartCut& cut);

/// Force from width and depth of cut, as in the model of Langeveld (1992), forces (8):
///   Ft = kt De depth,  Fn = kn De depth
/// RECONSTRUCTED: the thesis only calls this model "very simple". The depth of PartCut is the mean
/// thickness, so De depth is the cut area; the Langeveld model in reference/literature uses the
/// depth of the tip. Thesis: 2.1 (earlier models).
struct DepthOfCut {
  double kn = 0.0;                         ///< Pa, normal force per width and depth
  double kt = 0.0;                         ///< Pa, tangential force per width and depth
  double slip_speed = default_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "depth-of-cut";
  static constexpr bool knows(bit::PartKind kind) { return kind == bit::PartKind::face; }
  static std::span<const Coefficient<DepthOfCut>> coefficients();
};

PartForce law_force(const DepthOfCut& law, const PartCut& cut);

}  // namespace tdbd::forces
