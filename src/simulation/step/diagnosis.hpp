#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"

namespace tdbd::simulation {

/// What a bit did in every step that counts, for its diagnosis and the uncertainty of its means.
struct Trace {
  double dt = 0.0;                        ///< s, between steps
  std::vector<double> wob;                ///< N
  std::vector<double> tob;                ///< N m
  std::vector<double> rop;                ///< m/s
  std::vector<double> rotary_speed;       ///< rad/s
  std::vector<Eigen::Vector2d> centre_W;  ///< m, of the bit's origin
};

/// Room for this number of steps, so that adding one allocates nothing.
void reserve(Trace& trace, long steps);

/// Frequencies that a run would show by itself, Hz; 0: there is no such spring.
struct Expected {
  double torsional = 0.0, axial = 0.0, lateral = 0.0;
  double rolling = 0.0;  ///< of the centre's orbit when the bit rolls in its hole: w R / (Rh - R)
  double rolling_speed = 0.0;  ///< m/s, w R: over the orbit's radius the same for a wall that gives
};

enum class WhirlKind { none, forward, backward, synchronous };

/// Thesis 1.3: the three instabilities of drilling, from the record of a run. Ours.
struct Diagnosis {
  /// (max - min) / (2 mean) of the rotary speed, with the mean of whole cycles; or 0 (diagnose)
  double stick_slip_severity = 0.0;
  double stuck_share = 0.0;          ///< of whole cycles below 5 % of that mean, or 0 (diagnose)
  double torsional_frequency = 0.0;  ///< Hz, strongest of the rotary speed
  double lost_contact_share = 0.0;   ///< of time without weight on bit
  double wob_swing = 0.0;            ///< (max - min) / (2 mean)
  double axial_frequency = 0.0;      ///< Hz, strongest of the weight on bit
  double orbit_radius = 0.0;         ///< m, root mean square of the centre about its mean
  double orbit_frequency = 0.0;      ///< Hz, mean turn about that mean; > 0 with the bit
  WhirlKind whirl = WhirlKind::none;
  bool twists =
      false;         ///< the rotary speed swings by more than half of its mean, without stick-slip
  std::string text;  ///< one line for a reader
};

inline constexpr double severe_stick_slip = 0.5;  ///< of its severity

/// Names what exceeds its usual limits: stick-slip from that severity, bounce when contact is
/// lost for 1 % of the time, axial vibration when the weight swings by more than half of its mean,
/// whirl from an orbit of 0.1 mm that goes round steadily; synchronous within 10 % of the rotary
/// speed. `torque`: N m, mean torque on bit about +z, positive where the rock resists a positive
/// rotary speed. A bit can only stick where it touches rock half of the time or longer, the rock's
/// mean torque resists its mean rotation, and at least half of its turning goes one way. Elsewhere
/// the severity and the stuck share are 0, and a rotary speed that swings is torsional vibration.
/// Both count the last whole cycles of the torsional frequency: a record of two and a half cycles has
/// another mean speed than the bit.
Diagnosis diagnose(const Trace& trace, double torque);

/// The strongest frequency of equally spaced samples about their mean, Hz: peak of the spectrum
/// under a Hann window, between lines by a parabola through the logarithms. 0 if nothing varies.
double strongest_frequency(const std::vector<double>& samples, double dt);

/// "none", "forward", ...
std::string whirl_name(WhirlKind whirl);

}  // namespace tdbd::simulation
