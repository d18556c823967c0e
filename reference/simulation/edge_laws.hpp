#pragma once

#include <functional>

#include "core/types.hpp"

namespace tdbd::reference {

/// Arguments of a law: for a face, or for the chamfer along its edge.
struct EdgeCut {
  bool is_face = true;
  double area = 0.0;   ///< m2: of a face normal to the motion, of a chamfer in contact
  double edge = 0.0;   ///< m, length of the edge in rock
  double rake = 0.0;   ///< rad, between the face's normal and the motion
  double speed = 0.0;  ///< m/s
};

/// Tangential and normal force, N.
struct EdgeForce {
  double tangential = 0.0, normal = 0.0;
};

using EdgeLaw = std::function<EdgeForce(const EdgeCut&)>;

/// Forces (6). `strength`: Pa, confined; `te_A4`: m.
struct HansonHansenNumbers {
  double strength = 0.0, A1 = 0.0, A2 = 0.0, A3 = 0.0, te_A4 = 0.0, A5 = 0.0, A6 = 0.0;
};
EdgeLaw hanson_hansen_edges(const HansonHansenNumbers& n);

/// Forces (7), with friction that decreases with speed.
struct DetournayNumbers {
  double eps = 0.0, zeta = 0.0, sigma = 0.0, mu = 0.0, l = 0.0, kappa = 5.0;
  double weakening = 0.0, weakening_speed = 1.0;
};
EdgeLaw detournay_edges(const DetournayNumbers& n);

/// The force on the bit due to a surface that moves at v with the normal n into the rock: forces
/// (3) and (5), with e2 reduced within 30 degrees of a plunge.
Vec3 directed(const EdgeForce& f, const Vec3& v, const Vec3& n);

}  // namespace tdbd::reference
