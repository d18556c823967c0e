#pragma once

#include <vector>

#include "core/types.hpp"
#include "reference/simulation/axial_bit.hpp"
#include "reference/simulation/crushing_feet.hpp"

/// Cones with spherical teeth under a bit with a fixed axis, on rock that is a grid of heights.
namespace tdbd::reference {

/// Heights of rock over a square, z down; initially 0.
class RockGrid {
 public:
  RockGrid(double half_side, double spacing);

  double spacing() const { return spacing_; }
  /// Index of the column at or below x (m).
  int index(double x) const;
  double place(int i) const { return (i - half_) * spacing_; }
  double& height(int i, int j);
  double height(int i, int j) const;

 private:
  double spacing_;
  int half_;
  std::vector<double> heights_;
};

struct RolledCone {
  Pose X_BK;                    ///< at its angle 0
  double axial_inertia = 0.0;   ///< kg m2
  std::vector<Vec3> centres_K;  ///< m, of its teeth
};

struct RolledBit {
  std::vector<RolledCone> cones;
  double tooth_radius = 0.0;  ///< m
  double pressure = 0.0;      ///< Pa, normal force over the magnitude of the area vector
  SmoothContact contact;
  double carrier_inertia = 0.0;  ///< kg m2, It of dynamics (2) about z
};

struct RolledState {
  double time = 0.0;
  double height = 0.0, rate = 0.0, turned = 0.0;  ///< m, m/s, rad
  double momentum = 0.0;                          ///< N m s, of bit and cones about z
  double spent = 0.0;                             ///< J, work on the rock
  std::vector<double> angles, spins;              ///< rad; pi_k of dynamics (2), N m s
};

/// rad/s, of the bit, and of cone k about its journal.
double rotary_speed(const RolledBit& bit, const RolledState& s);
double cone_speed(const RolledBit& bit, const RolledState& s, std::size_t k);

/// Upward force (N) and torque against the rotation (N m), and the torques on the cones about their
/// axes.
struct RolledLoads {
  double weight = 0.0, torque = 0.0, power = 0.0;
  std::vector<double> cones;
};
RolledLoads rolled_loads(const RolledBit& bit, const RockGrid& rock, const RolledState& s);

/// Makes one Runge-Kutta step under a string. The teeth leave their prints after it.
void roll(const RolledBit& bit, const AxialString& string, double h, RockGrid& rock,
          RolledState& s);

}  // namespace tdbd::reference
