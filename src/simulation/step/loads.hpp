#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "forces/part/directions.hpp"
#include "simulation/step/cuts.hpp"
#include "simulation/step/diagnosis.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::simulation {

/// Force of the rock on one part. Frame W.
struct PartLoad {
  Vec3 force_W = Vec3::Zero();  ///< N, on the bit
  Vec3 point_W = Vec3::Zero();  ///< m; for several contacts of a part, the mean weighted by force
  double normal = 0.0;          ///< N, Fn of the law
  double tangential = 0.0;      ///< N, Ft
  double power = 0.0;           ///< W, dissipated in the rock: -F . v
};

/// Forces of the rock on the bit in a step.
struct BitLoads {
  std::vector<PartLoad> parts;       ///< one per part of the bit
  Vec3 force_W = Vec3::Zero();       ///< N
  Vec3 torque_W = Vec3::Zero();      ///< N m, about the origin of the bit
  std::vector<double> cone_torques;  ///< N m, about the Z axis of each cone, of the forces on it
  double power = 0.0;                ///< W
};

/// Evaluates the law of the part that made this cut, for this motion of the bit.
PartLoad load_of(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
                 const BitVelocity& motion, double dt, const CutOfPart& cut);

/// Torque of a load about the Z axis of a cone, N m.
double torque_about_cone(const bit::Bit& bit, const Pose& X_WB, int cone, const PartLoad& load);

/// Sets all loads to zero.
void clear(const bit::Bit& bit, BitLoads& loads);

/// Adds the load of the part that made this cut.
void add(const PartLoad& load, const bit::Bit& bit, const Pose& X_WB, const CutOfPart& cut,
         BitLoads& loads);

/// Evaluates the laws of all parts for this motion of the bit and sums the loads, simulation (4). A
/// pure function except that it reuses the memory of `loads`.
void sum_loads(const ForcePlan& plan, const bit::Bit& bit, const Pose& X_WB,
               const BitVelocity& motion, double dt, const std::vector<CutOfPart>& cuts,
               BitLoads& loads);

/// Force F of a part's law and a resistance C (N s/m), at one velocity of its point.
struct PartDrag {
  forces::PartForce force;
  Mat3 resistance = Mat3::Zero();
};

/// The resistance C with F = -C v, simulation (7):
///   C = -(F.v/v^2) I + q v^T - v q^T,   q = -(F - (F.v/v^2) v)/v^2
/// C + C^T >= 0 for any law, because laws do no positive work. v: m/s, not 0; F: N.
Mat3 secant_resistance(const Vec3& v, const Vec3& F);

/// Kind of resistance: the secant, which reproduces the force; the tangent -dF/dv by forward
/// differences; or none.
enum class Resistance { secant, tangent, none };

/// Speed at which laws are evaluated at rest, where they have a slope but no direction: a creep
/// into the rock, m/s.
inline constexpr double smallest_speed = 1e-9;

/// Evaluates the law of a part at this velocity (m/s) of its point.
PartDrag drag_of(const ForcePlan& plan, const CutOfPart& cut, const Vec3& v_W, double dt,
                 Resistance which);

/// A pressing surface (forces (4)) in a step that solves for force and velocity together, by an
/// augmented Lagrangian, simulation (13):
///   p = min(limit, max(0, (p' + k_n (v_n - g/h))/(1 + k_n c))),   c = ramp |v_t|/limit
///   t = t' + k_t v_t, shortened to mu p;                  F = -p n - t
/// g/h is the speed at which the surface returns to rock from which it has risen by g. p' and t'
/// are the normal force and the friction of the last estimate. If the estimate does not change any
/// more, the law is satisfied for any penalties k; they only affect the rate of convergence.
struct PressedContact {
  forces::Pressing law;
  Vec3 normal_W = Vec3::Zero();
  double free_speed = 0.0;         ///< m/s, g/h
  double p = 0.0;                  ///< N, estimate
  Vec3 friction_W = Vec3::Zero();  ///< N, estimate, opposite to the slip
  double k_n = 0.0, k_t = 0.0;     ///< N s/m
  std::optional<double> slip{};    ///< m/s, for mu and c; none: |v_t|
};

/// Force at the velocity v (m/s) of the contact relative to the rock, and its slope -dF/dv. The
/// slope includes the dependence of friction on normal force and speed.
PartDrag drag_of(const PressedContact& contact, const Vec3& v_W);

/// Sets the estimate to the force at this velocity.
void update_estimate(PressedContact& contact, const Vec3& v_W);

/// Mean and standard deviation over steps.
struct MeanAndDeviation {
  double mean = 0.0, deviation = 0.0;
};

inline constexpr double sampling_coverage = 0.95;

/// Statistical uncertainty of the means over the recorded steps, relative to an infinitely long
/// run: half-widths of 95 % confidence intervals, from the means of eight equal batches. Empty if
/// there are fewer steps than batches. Errors of mesh and time step are not included (`tdbd
/// converge`).
struct SamplingUncertainty {
  std::optional<double> wob, tob, rop, rotary_speed;  ///< N, N m, m/s, rad/s
  std::optional<double> imbalance;                    ///< 1
};

/// Statistics of one part of the bit.
struct PartLoadFigures {
  std::string name;
  MeanAndDeviation normal, tangential;  ///< N
  double power = 0.0;                   ///< W, mean
  double removed = 0.0;                 ///< m3, by the whole cutter of the part
  double specific_energy = 0.0;         ///< Pa: energy per volume; 0 without volume
};

/// Statistics of the forces on the bit over the recorded steps. SI units.
struct LoadStatisticsSummary {
  long steps = 0;                      ///< recorded steps; if 0, the other members are unknown
  double from = 0.0, to = 0.0;         ///< s, time range of the recorded steps
  MeanAndDeviation wob, tob;           ///< N, N m
  MeanAndDeviation rop, rotary_speed;  ///< m/s, rad/s
  SamplingUncertainty uncertainty;
  double aggressiveness = 0.0;         ///< 3 T / (D W); in oilfield units 36 T / (D W)
  double specific_energy = 0.0;        ///< Pa, W/A + w T/(A v), A the gage circle
  double imbalance = 0.0;              ///< mean lateral force in the bit's frame over WOB
  double imbalance_azimuth = 0.0;      ///< rad, azimuth of that force in the frame of the bit
  double power = 0.0;                  ///< W, mean, spent on the rock
  std::vector<PartLoadFigures> parts;  ///< parts with a force
};

/// Converts the statistics to the JSON of `summary.json`: wob_mean_n, tob_mean_n_m,
/// rop_mean_m_per_s and others at top level, parts under "forces". Null if no step was recorded.
nlohmann::ordered_json to_json(const LoadStatisticsSummary& figures);

/// Sums of forces over the recorded steps.
struct LoadStatistics {
  RunningVariance wob, tob;                         ///< N, N m
  RunningVariance rop, rotary_speed;                ///< m/s, rad/s
  Vec3 lateral_B = Vec3::Zero();                    ///< N, mean force on the bit in its frame
  double energy = 0.0;                              ///< J, dissipated in the rock
  double removed = 0.0;                             ///< m3
  double time = 0.0;                                ///< s
  std::vector<RunningVariance> normal, tangential;  ///< N, per part
  std::vector<double> part_energy, part_removed;    ///< J, m3, per part

  template <class Archive>
  void serialize(Archive& a) {
    a(wob, tob, rop, rotary_speed, lateral_B, energy, removed, time, normal, tangential,
      part_energy, part_removed);
  }
};

/// Progress of the bit in a step. In free motion these are displacements divided by the step, so
/// that their means are displacements over time; in prescribed motion they are velocities.
struct StepRates {
  double penetration = 0.0;  ///< m/s relative to the rock along z
  double rotary = 0.0;       ///< rad/s about the axis of the bit
};
StepRates rates_of(const Move& move);
StepRates rates_of(const BitVelocity& velocity, const Pose& X_WB);

/// Forces of one step, for the statistics and the history.
struct LoadedStep {
  const BitLoads& loads;
  const BitVelocity& velocity;
  const Pose& X_WB;
  const std::vector<double>& removed_by_part;  ///< m3
  double dt = 0.0;                             ///< s
  StepRates rates;
};

void add(const LoadedStep& step, LoadStatistics& statistics);
void add(const LoadedStep& step, Trace& trace);

MeanAndDeviation summarize(const RunningVariance& spread);

LoadStatisticsSummary summarize(const bit::Bit& bit, const LoadStatistics& statistics, double end);

/// Half-width of the confidence interval (sampling_coverage) of the mean of `samples`, from
/// Student's t distribution of the means of eight consecutive batches of equal length. Initial
/// samples that do not fill a batch are omitted. Nothing for fewer than eight samples. (Schmeiser,
/// Oper. Res. 30:556, 1982.)
std::optional<double> batch_uncertainty(const std::vector<double>& samples);

/// Half-width of the confidence interval of the imbalance r = |L|/W, with the means L of the force
/// across the axis and W of the weight: that of the mean of (L_i . L/|L| - r W_i)/W over the steps,
/// the error of a ratio of means to first order (Cochran, Sampling Techniques, 1977, section 2.11).
/// Nothing for fewer than eight steps, without weight, or without a force across the axis.
std::optional<double> imbalance_uncertainty(const Trace& trace);

/// Half-widths for all means of a trace.
SamplingUncertainty sampling_of(const Trace& trace);

}  // namespace tdbd::simulation
