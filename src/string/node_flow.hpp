#pragma once

#include <cmath>

namespace tdbd::string {

/// (e^z - 1)/z.
inline double phi(double z) { return std::abs(z) < 1e-8 ? 1.0 + 0.5 * z : std::expm1(z) / z; }

/// b of string (5): change of speed per unit of a constant force that acts for `time` (s), with
/// mass in kg and damping in N s/m.
inline double mobility(double time, double mass, double damping) {
  return time / mass * phi(-damping * time / mass);
}

/// Coulomb friction: at most `resting` (N) at speeds up to `threshold` (m/s), `sliding` (N) above.
/// resting >= sliding >= 0.
struct Coulomb {
  double resting = 0.0;
  double sliding = 0.0;
  double threshold = 0.0;
};

/// A body that moves in one direction; its position is fixed during a flow.
struct DampedBody {
  double mass = 0.0;     ///< kg
  double damping = 0.0;  ///< N s/m
};

/// The exact speed after `time` of a body under a constant force, its damper and Coulomb friction
/// (string (6)): pieces of exponentials between the times at which the speed passes the threshold
/// or zero.
double flow_along(const DampedBody& body, double force, const Coulomb& friction, double time,
                  double speed);

/// Two speeds of one contact point: along the hole and around it, m/s.
struct Slip {
  double along = 0.0;
  double around = 0.0;
};
inline double size_of(const Slip& s) { return std::sqrt(s.along * s.along + s.around * s.around); }

/// Inputs of string (5) for a node: the speeds after the flow without friction (m/s), and
/// mobilities (s/kg), in units of slip.
struct FreeFlow {
  Slip speed;
  Slip mobility;
};

/// The slip after the flow, string (5). One friction vector acts in both directions.
Slip flow_slip(const Slip& start, const FreeFlow& free, const Coulomb& friction);

/// A completed flow, in units of slip.
struct CompletedFlow {
  Slip from, to;          ///< m/s
  Slip force;             ///< without friction and dampers, N
  double friction = 0.0;  ///< friction level, N; 0: none
  double time = 0.0;      ///< s
};

/// Losses of flows, J.
struct Lost {
  double friction = 0.0, damping = 0.0;
};

/// Adds the losses of a flow: minus the impulse of friction and dampers times the mean speed. A
/// body that comes to rest loses its kinetic energy and the work of the force until then; after
/// that the force does no work.
void add_flow_losses(const CompletedFlow& flow, const Slip& mass, const Slip& damping, Lost& lost);

}  // namespace tdbd::string
