#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "dynamics/schedule.hpp"
#include "simulation/case/motion.hpp"
#include "string/top.hpp"

/// The drive of the top of a string on a chain: its settings, and the log of a rig (rig_log.cpp).
namespace tdbd::simulation {

/// The names of top drives in a case.
enum class TopDrive { speed, pi, soft_torque, z_torque };

namespace top_keys {

inline constexpr QuantityKey hook_load{.name = "hook_load",
                                       .unit = "N",
                                       .computed_default = "that of the start",
                                       .range = up_to_largest,
                                       .meaning = "axial = hook-load: the force",
                                       .usual = Range::within(1e3, 1e7)};

}  // namespace top_keys

/// [string.top]: the drive of the top of the string.
struct TopSettings {
  TopDrive torsion = TopDrive::speed;
  string::Top top{.filter = 0.5};
  double tuned_frequency = 0.0;  ///< Hz
  double impedance_factor = 1.0, compensation = 0.0;
  std::vector<double> rate_limits{0.0, 60.0 / 3600.0};

  static constexpr TableKey table{"string.top", "what drives the top of the string"};
  void visit(FieldVisitor& v) {
    v(torsion, {.name = "torsion",
                .values = {{{"speed", TopDrive::speed},
                            {"pi", TopDrive::pi},
                            {"soft-torque", TopDrive::soft_torque},
                            {"z-torque", TopDrive::z_torque}}},
                .meaning = "speed: turns with motion.rotary_speed; the others: an inertia under "
                           "control, that speed its set point"});
    visit_control(v);
    visit_axial(v);
    visit_autodriller(v);
  }
  /// For the rotation.
  void visit_control(FieldVisitor& v) {
    const bool is_pi = torsion == TopDrive::pi, is_soft = torsion == TopDrive::soft_torque,
               is_z = torsion == TopDrive::z_torque;
    v.only(is_soft, {"a frequency without torsion = \"soft-torque\"", "none, or that top drive"},
           [&] {
             v(tuned_frequency, {.name = "tuned_frequency",
                                 .unit = "Hz",
                                 .computed_default = "the string's first torsional frequency",
                                 .range = Range::positive(),
                                 .meaning = "soft-torque: frequency of least reflection"});
           });
    v.only(is_z, {"a compensation without torsion = \"z-torque\"", "none, or that top drive"}, [&] {
      v(compensation, {.name = "compensation",
                       .range = Range::within(0.0, 0.95),
                       .meaning = "z-torque: share of the inertia"});
    });
    v.only(is_soft || is_z,
           {"a factor without soft-torque or z-torque", "none, or one of these top drives"}, [&] {
             v(impedance_factor,
               {.name = "impedance_factor",
                .range = Range::positive(),
                .meaning = "proportional gain over the impedance of the top section"});
           });
    const Refusal of_speed{"a key of a top drive with torsion = \"speed\"",
                           "none, or torsion = \"pi\", \"soft-torque\" or \"z-torque\""};
    v.only(torsion != TopDrive::speed, of_speed, [&] {
      v(top.inertia, {.name = "inertia",
                      .unit = "kg m2",
                      .need = Need::required,
                      .computed_default = "required, except speed",
                      .range = Range::positive(),
                      .meaning = "of the top drive"});
      v(top.torque_limit, {.name = "torque_limit",
                           .unit = "N m",
                           .need = Need::optional,
                           .computed_default = "none",
                           .range = Range::positive(),
                           .meaning = "of the motor"});
      v.only(is_pi, {"a gain with a tuned top drive", "impedance_factor, or torsion = \"pi\""},
             [&] {
               v(top.proportional, {.name = "proportional",
                                    .unit = "N m s/rad",
                                    .need = Need::required,
                                    .computed_default = "pi: required; else from impedance_factor",
                                    .range = Range::non_negative(),
                                    .meaning = "gain of the speed"});
             });
      v.only(
          is_pi || is_z, {"a gain with soft-torque", "tuned_frequency, or torsion = \"pi\""}, [&] {
            v(top.integral, {.name = "integral",
                             .unit = "N m/rad",
                             .need = Need::required,
                             .computed_default = "pi, z-torque: required; else from the frequency",
                             .range = Range::non_negative(),
                             .meaning = "gain of the angle"});
          });
    });
  }
  void visit_autodriller(FieldVisitor& v) {
    const bool drills = top.axial == string::Top::Axial::autodriller;
    v.only(drills, {"a key of an autodriller", "none, or axial = \"autodriller\""}, [&] {
      v(top.gain, {.name = "gain",
                   .unit = "m/s/N",
                   .need = Need::required,
                   .computed_default = "autodriller: required",
                   .range = Range::non_negative(),
                   .meaning = "of the weight's error"});
      v(top.integral_gain, {.name = "integral_gain",
                            .unit = "m/s2/N",
                            .need = Need::required,
                            .computed_default = "autodriller: required",
                            .range = Range::non_negative(),
                            .meaning = "of its integral"});
      v(top.filter, {.name = "filter",
                     .unit = "s",
                     .range = Range::non_negative(),
                     .meaning = "autodriller: time constant of the measured weight"});
    });
    if (v.when(drills)) {
      v(rate_limits, {.name = "rate_limits",
                      .unit = "m/s",
                      .computed_default = "autodriller: 0 to 60 m/h",
                      .meaning = "slowest and fastest rate of the block",
                      .usual = Range::within(0.0, 0.3)});
    }
  }
  void visit_axial(FieldVisitor& v) {
    v(top.axial, {.name = "axial",
                  .values = {{{"rate", string::Top::Axial::rate},
                              {"hook-load", string::Top::Axial::hook_load},
                              {"autodriller", string::Top::Axial::autodriller}}},
                  .meaning = "rate: lowered with motion.rate_of_penetration; hook-load: hangs from "
                             "a force; autodriller: keeps motion.weight_on_bit at the surface"});
  }
};

/// In [string.top]. The default is the load of the start.
struct HookLoad {
  double hook_load = 0.0;

  void visit(FieldVisitor& v) { v(hook_load, top_keys::hook_load); }
};

/// The motion of the top of a string according to the log of a rig, linear between rows. Empty if
/// the log does not contain it. Times are those of the run.
struct RigLog {
  dynamics::Schedule rotary_speed;                       ///< rad/s
  dynamics::Schedule block_speed;                        ///< m/s, downward
  dynamics::Schedule hook_load;                          ///< N
  double end = std::numeric_limits<double>::infinity();  ///< of its last row, s
};

/// Whether the log contains this quantity.
inline bool is_given(const dynamics::Schedule& s) { return !s.times.empty(); }

/// [string.top.log]: the record of a rig as the motion of the top.
struct LogSettings {
  std::string file;
  std::string time = "time";
  std::optional<std::string> rotary_speed, block_speed, hook_load;

  static constexpr TableKey table{
      "string.top.log", "the record of a rig as the motion of the top, linear between its rows"};
  void visit(FieldVisitor& v) {
    v.path(file,
           {.name = "file",
            .need = Need::required,
            .meaning =
                "LAS 2.0 (NAME.las), or CSV under a header of names with units: \"RPM [rpm]\""});
    v(time, {.name = "time", .meaning = "the column of times; \"TIME [s]\" also gives a unit"});
    v(rotary_speed, {.name = "rotary_speed",
                     .computed_default = "none",
                     .meaning = "the column that replaces motion.rotary_speed"});
    v(block_speed, {.name = "block_speed",
                    .computed_default = "none",
                    .meaning = "the column that replaces motion.rate_of_penetration; downward"});
    v(hook_load, {.name = "hook_load",
                  .computed_default = "none",
                  .meaning = "the column that replaces string.top.hook_load (axial = hook-load)"});
  }
};

/// The start of the run in the log, in [string.top.log]. The default is the first row.
struct LogStart {
  double start = 0.0;

  void visit(FieldVisitor& v) {
    v(start, {.name = "start",
              .unit = "s",
              .computed_default = "that of the first row",
              .meaning = "time of the log at which the run starts"});
  }
};

/// Reads [string.top.log] and its file. The result is empty without that table. Records mistakes.
RigLog read_rig_log(Config& whole);

/// Records a mistake if the log ends before the run of this duration (s).
void check_rig_log(Config& whole, const RigLog& log, double duration);

/// Records a mistake if the table has a quantity that the log contains.
void refuse_logged(Config& table, const QuantityKey& key, const dynamics::Schedule& logged);

/// The motion of the top during the step of h (s) from t: the turn of the set point, the distance
/// of the block, and the mean hook load, from the log or otherwise these constant values.
string::TopCommand command_of(const RigLog& log, const string::TopCommand& usual, double t,
                              double h);

}  // namespace tdbd::simulation
