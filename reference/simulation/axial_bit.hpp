#pragma once

#include "reference/simulation/cut_history.hpp"
#include "reference/simulation/edge_laws.hpp"

namespace tdbd::reference {

/// Drive and load of a bit with a fixed axis: dynamics (9) and (11) along and about z, with dampers
/// connected to the top.
struct AxialString {
  double mass = 0.0, inertia = 0.0;            ///< kg, kg m2
  double load = 0.0, damping = 0.0;            ///< N, N s/m
  double rate = 0.0;                           ///< m/s, initial speed of the dampers' end
  double following_time = 0.0;                 ///< s, time constant of its rate; 0: constant rate
  double stiffness = 0.0, turn_damping = 0.0;  ///< N m/rad, N m s/rad
  double speed = 0.0, start_angle = 0.0;       ///< rad/s, rad, of the top
};

struct AxialState {
  double time = 0.0;
  double height = 0.0, rate = 0.0;   ///< m, m/s, down
  double end_rate = 0.0;             ///< m/s, of the dampers' end
  double turned = 0.0, speed = 0.0;  ///< rad, rad/s
  double spent = 0.0;                ///< J, work on the rock
};

/// Load of the rock on all cutters: the upward force, N, and the torque against the rotation, N m.
struct AxialLoads {
  double weight = 0.0, torque = 0.0;
};

AxialLoads axial_loads(const Columns& bit, const EdgeLaw& law, const HeightHistory& history,
                       const AxialState& s);

/// A bit that starts in a bottom that fits it, by the classical Runge-Kutta method.
class AxialRun {
 public:
  AxialRun(const Columns& bit, EdgeLaw law, const AxialString& string, const AxialState& start,
           int bins_per_turn);

  void step(double h);
  const AxialState& state() const { return state_; }
  AxialLoads loads() const { return axial_loads(bit_, law_, history_, state_); }

 private:
  AxialState rates(const AxialState& s) const;

  const Columns& bit_;
  EdgeLaw law_;
  AxialString string_;
  AxialState state_;
  HeightHistory history_;
};

}  // namespace tdbd::reference
