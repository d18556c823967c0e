#pragma once

#include <cmath>

namespace tdbd::string {

/// (e^z - 1)/z.
inline double phi(double z) { return std::abs(z) < 1e-8 ? 1.0 + 0.5 * z : std::expm1(z) / z; }

/// b of string (5): what a constant force that acts for a time changes a speed by, over the force;
/// time in s, mass in kg, damping in N s/m.
inline double mobility(double time, double mass, double damping) {
  return time / mass * phi(-damping * time / mass);
}

/// Coulomb's friction: at most `resting` (N) holds a body at a speed up to `threshold` (m/s),
/// `sliding` brakes it above. resting >= sliding >= 0.
struct Coulomb {
  double resting = 0.0;
  double sliding = 0.0;
  double threshold = 0.0;
};

/// A body that moves along one direction, at a position that stands still.
struct OneWay {
  double mass = 0.0;     ///< kg
  double damping = 0.0;  ///< N s/m
};

/// The speed after a time, exactly, of a body under a constant force, its damper and Coulomb
/// friction (string (6)): pieces of exponentials between the times at which the speed passes the
/// threshold or zero.
double flow_along(const OneWay& body, double force, const Coulomb& friction, double time,
                  double speed);

/// Two speeds of one contact point: along the hole and around it, m/s.
struct Slip {
  double along = 0.0;
  double around = 0.0;
};
inline double size_of(const Slip& s) { return std::sqrt(s.along * s.along + s.around * s.around); }

/// What string (5) needs of a node: where both speeds go without friction (m/s), and mobilities
/// (s/kg), all in units of slip.
struct FreeFlow {
  Slip speed;
  Slip mobility;
};

/// The slip after the flow, string (5). One vector of friction resists both directions.
Slip flow_slip(const Slip& start, const FreeFlow& free, const Coulomb& friction);

/// A flow that has been made, in units of slip.
struct DoneFlow {
  Slip from, to;          ///< m/s
  Slip force;             ///< without friction and dampers, N
  double friction = 0.0;  ///< its level, N; 0: none
  double time = 0.0;      ///< s
};

/// What flows took from bodies, J.
struct Lost {
  double friction = 0.0, damping = 0.0;
};

/// Adds what a flow took: minus the impulse of friction and dampers times the mean speed. A body that
/// comes to rest takes its kinetic energy and the force's work until then; the force's impulse after
/// that does no work.
void book_flow(const DoneFlow& flow, const Slip& mass, const Slip& damping, Lost& lost);

}  // namespace tdbd::string
