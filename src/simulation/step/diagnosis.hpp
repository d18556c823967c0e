#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
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

/// The change of a mean from the first to the second half of the recorded steps.
struct MeanChange {
  std::string name;          ///< key of the mean in summary.json
  double relative = 0.0;     ///< second mean minus first, over the larger magnitude of the two
  double t = 0.0;            ///< the change over its standard error
  bool is_drifting = false;  ///< |t| and the relative change both exceed their limits
};

/// Whether the means of a run are those of a steady state.
struct SteadyState {
  std::optional<bool> is_steady;  ///< nothing: not decided, see `reason`
  std::string reason;             ///< why it is not decided, or ""
  double revolutions = 0.0;       ///< of the bit that the means cover
  std::vector<MeanChange> changes;
};

/// Limit of |t|: Student's t with 14 degrees of freedom. A steady run exceeds it with a probability
/// of 5 % in at least one of the four means.
inline constexpr double drift_t = 2.863994;

/// Smallest relative change of a mean that matters.
inline constexpr double smallest_drift = 0.01;

/// Compares the means of weight, torque, rate and rotary speed over the first and the second half
/// of the recorded steps (Geweke, "Evaluating the accuracy of sampling-based approaches to the
/// calculation of posterior moments", Bayesian Statistics 4, 1992; he compares the first tenth with
/// the last half). Standard errors are those of the means of eight batches in each half, which are
/// nearly independent although steps are not (Schmeiser, Oper. Res. 30:556, 1982). A mean drifts if
/// it changes by more than chance explains and by more than smallest_drift. The result is not
/// decided if the steps cover less than one revolution, or are fewer than the batches.
SteadyState steady_state(const Trace& trace);

/// Returns "steady_test" of summary.json.
nlohmann::ordered_json to_json(const SteadyState& state);

/// Describes the means that drift: "the weight on bit by +12 %, the torque by +11 %". Empty if none
/// does.
std::string drifting_means(const SteadyState& state);

}  // namespace tdbd::simulation
