#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/part_cut.hpp"
#include "forces/part/pressing.hpp"

namespace tdbd::forces {

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
  double weakening_speed = 1.0;          ///< m/s
  double slip_speed = usual_slip_speed;  ///< m/s, see slip_share

  static constexpr std::string_view name = "detournay";
  static constexpr bool knows(bit::PartKind kind) { return bit::belongs_to_a_cutter(kind); }
  static constexpr bool presses(bit::PartKind kind) { return bit::is_side_of_a_cutter(kind); }
  static std::span<const Coefficient<Detournay>> coefficients();
};

/// Force on faces and chamfers, forces (3).
PartForce law_force(const Detournay& law, const PartCut& cut);

/// Pressing of the other surfaces of a cutter, forces (4).
Pressing law_pressing(const Detournay& law, const PartCut& cut);

}  // namespace tdbd::forces
