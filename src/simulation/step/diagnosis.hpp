#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"

namespace tdbd::simulation {

/// Time series of all recorded steps, for the diagnosis and the uncertainty of means.
struct Trace {
  double dt = 0.0;                        ///< s, between steps
  std::vector<double> wob;                ///< N
  std::vector<double> tob;                ///< N m
  std::vector<double> rop;                ///< m/s
  std::vector<double> rotary_speed;       ///< rad/s
  std::vector<Eigen::Vector2d> centre_W;  ///< m, origin of the bit
  std::vector<Eigen::Vector2d> force_B;   ///< N, across the bit's axis, in the frame of the bit

  template <class Archive>
  void serialize(Archive& a) {
    a(dt, wob, tob, rop, rotary_speed, centre_W, force_B);
  }
};

/// Reserves memory for a number of steps, so that adding a step allocates nothing.
void reserve(Trace& trace, long steps);

/// Expected natural frequencies, Hz; 0 if there is no such spring.
struct Expected {
  double torsional = 0.0, axial = 0.0, lateral = 0.0;
  double rolling = 0.0;  ///< frequency of the centre's orbit for pure rolling in the hole: w R /
                         ///< (Rh - R)
  double rolling_speed = 0.0;  ///< m/s, w R: divided by the orbit radius, it gives the frequency
                               ///< for a compliant wall
};

enum class WhirlKind { none, forward, backward, synchronous };

/// Diagnosis of a run: the three instabilities of thesis 1.3. An addition of TDBD [+].
struct Diagnosis {
  /// (max - min) / (2 mean) of the rotary speed, with the mean over whole cycles; or 0 (diagnose)
  double stick_slip_severity = 0.0;
  double stuck_share = 0.0;          ///< of whole cycles below 5 % of that mean, or 0 (diagnose)
  double torsional_frequency = 0.0;  ///< Hz, dominant frequency of the rotary speed
  double lost_contact_share = 0.0;   ///< share of time without weight on bit
  double wob_swing = 0.0;            ///< (max - min) / (2 mean)
  double axial_frequency = 0.0;      ///< Hz, dominant frequency of the weight on bit
  double orbit_radius = 0.0;         ///< m, root mean square of the centre about its mean
  double orbit_frequency = 0.0;      ///< Hz, mean rotation about that position; > 0 in the sense of
                                     ///< the bit's rotation
  WhirlKind whirl = WhirlKind::none;
  bool twists =
      false;         ///< the rotary speed varies by more than half of its mean, without stick-slip
  std::string text;  ///< one line for users
};

inline constexpr double severe_stick_slip = 0.5;  ///< limit of stick_slip_severity

/// Reports what exceeds its usual limits: stick-slip from severe_stick_slip; bounce if contact is
/// lost for 1 % of the time; axial vibration if the weight varies by more than half of its mean;
/// whirl from an orbit of 0.1 mm with steady direction; synchronous whirl within 10 % of the rotary
/// speed. `torque` is the mean torque on bit about +z, N m, positive if the rock resists a positive
/// rotary speed.
///
/// A bit can only stick if it touches rock at least half of the time, the mean torque of the rock
/// resists the mean rotation, and at least half of the rotation is in one direction. Otherwise the
/// severity and the stuck share are 0, and a varying rotary speed is torsional vibration. Both use
/// the last whole cycles of the torsional frequency, because the mean speed over two and a half
/// cycles would be biased. With less than one revolution the text is "too short to judge".
Diagnosis diagnose(const Trace& trace, double torque);

/// Dominant frequency of equally spaced samples about their mean, Hz: the peak of the spectrum with
/// a Hann window, interpolated by a parabola through the logarithms. 0 if the samples are constant.
double strongest_frequency(const std::vector<double>& samples, double dt);

/// "none", "forward", ...
std::string whirl_name(WhirlKind whirl);

}  // namespace tdbd::simulation
