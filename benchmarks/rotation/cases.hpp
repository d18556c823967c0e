#pragma once

#include <string>
#include <vector>

#include "dynamics/gyrostat.hpp"
#include "dynamics/loads.hpp"

namespace tdbd::bench {

/// A gyrostat, its initial state, and its final state from a Taylor series with 50 digits. Frames:
/// W space, B bit.
struct RotationCase {
  std::string name;
  dynamics::Gyrostat body;
  dynamics::Loads loads;           ///< only gravity
  Vec3 rotation_vector;            ///< rad, of the initial attitude
  Vec3 w_B;                        ///< rad/s
  std::vector<double> spins;       ///< rad/s, phi' of each cone; the angles start at zero
  Mat3 R_WB_end;                   ///< at `duration`
  std::vector<double> angles_end;  ///< rad, of the cones at `duration`
  double duration = 10.0;          ///< s
};

/// A top of inertia (5, 5, 1) kg m2 that spins at 5 rad/s, 0.05 rad from upright; no cones.
RotationCase slow_top();

/// A free body of inertia (2, 2, 3) kg m2 with three equal cones.
RotationCase free_gyrostat();

/// A heavy asymmetric body with three unequal cones.
RotationCase heavy_gyrostat();

/// The state with this attitude (B to W), angular velocity (rad/s), and spins (rad/s) and angles
/// (rad) of the cones.
dynamics::RotationState state_of(const RotationCase& c, const Mat3& R_WB, const Vec3& w_B,
                                 const std::vector<double>& spins,
                                 const std::vector<double>& angles);

/// The state at time 0.
dynamics::RotationState start_of(const RotationCase& c);

/// Deviations of a final state from the reference and from conservation laws.
struct EndErrors {
  double attitude = 0.0;  ///< R - R_end|_F / sqrt(2), approximately the angle between them in rad
  double cone_angles = 0.0;  ///< rad, the largest
  double momentum = 0.0;  ///< change of the momentum (with gravity: of its z component) over |pi|
  double energy = 0.0;    ///< change of the energy over the initial kinetic energy
};
EndErrors errors_of(const RotationCase& c, const dynamics::RotationState& end);

}  // namespace tdbd::bench
