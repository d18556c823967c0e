#pragma once

#include <string>
#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/run_settings.hpp"
#include "simulation/case/string_settings.hpp"
#include "simulation/case/top_settings.hpp"
#include "string/section.hpp"
#include "string/simple_bit.hpp"
#include "string/statics.hpp"

namespace tdbd::simulation {

/// Reads sections, survey and friction of the table [string], and checks them against each other.
/// `step`: s, for the default loss time. Records mistakes; appends warnings. In read_string.cpp.
StringPlan read_string_plan(Config& whole, double step, std::vector<CaseWarning>& warnings);

/// A string on a chain and its top, without the bit.
struct ChainAbove {
  StringPlan string;
  string::Chain chain;
  ChainStart start = ChainStart::steady;
};

/// Reads [string] and its tables. `inertia`: of the bit and what is rigidly connected to it, kg m2;
/// the default frequency of soft-torque depends on it. Records mistakes; appends warnings.
ChainAbove read_chain_above(Config& whole, double step, double inertia,
                            std::vector<CaseWarning>& warnings);

/// Returns the longest stable step (s) with a bit of this mass (kg) and inertia (kg m2), including
/// the last cell; 0 if they cannot move. Records a mistake if `step` is longer.
double check_chain_step(Config& whole, double step, const string::Chain& chain, double mass,
                        double inertia);

/// Returns the hook load at the start, N: that of the log, otherwise that of [string.top], where it
/// is a mistake if the top does not hang from a hook load. `usual`: that of the static equilibrium.
double read_hook_load(Config& whole, const dynamics::Schedule& logged, const string::Chain& chain,
                      double usual);

/// Reads the keys of a chain in [output] for steps of this length (s). Records mistakes.
ChainOutput read_chain_output(Config& output, const string::Chain& chain, double step);

/// Refuses these keys if there is no chain.
void refuse_chain_output(Config& output);

/// [string.bit]: a bit without a shape, for runs without rock.
struct SimpleBitSettings {
  string::SimpleBit bit;

  static constexpr TableKey table{"string.bit", "a bit without a shape, for runs without rock"};
  void visit(FieldVisitor& v) {
    double axial_damping = 0.0, torsional_damping = 0.0;  // in addition to those of the mud
    v(bit.law,
      {.name = "law",
       .values = {{{"none", string::BitLaw::none},
                   {"fixed", string::BitLaw::fixed},
                   {"two-level", string::BitLaw::two_level},
                   {"regenerative", string::BitLaw::regenerative},
                   {"load", string::BitLaw::load}}},
       .meaning = "none: off bottom; fixed: it cannot move; two-level: Coulomb friction about the "
                  "axis; regenerative: cuts what the blade ahead left; load: constant"});
    v(bit.weight, {.name = "weight", .unit = "N", .meaning = "constant part of the weight on bit"});
    v(bit.torque,
      {.name = "torque", .unit = "N m", .meaning = "constant part of the torque on bit"});
    v(axial_damping, {.name = "axial_damping",
                      .unit = "N s/m",
                      .computed_default = "0",
                      .range = up_to_largest,
                      .meaning = "to rest, beside that of the mud"});
    v(torsional_damping, {.name = "torsional_damping",
                          .unit = "N m s/rad",
                          .computed_default = "0",
                          .range = up_to_largest,
                          .meaning = "to rest, beside that of the mud"});
    bit.axial_damping += axial_damping;
    bit.torsional_damping += torsional_damping;
    visit_law(v);
  }
  void visit_law(FieldVisitor& v) {
    v.only(bit.law == string::BitLaw::two_level,
           {"a key of another law", "none, or law = \"two-level\""}, [&] {
             v(bit.resting_torque, {.name = "static",
                                    .unit = "N m",
                                    .need = Need::required,
                                    .computed_default = "two-level: required",
                                    .range = up_to_largest,
                                    .meaning = "largest torque at rest"});
             v(bit.sliding_torque, {.name = "dynamic",
                                    .unit = "N m",
                                    .need = Need::required,
                                    .computed_default = "two-level: required",
                                    .range = up_to_largest,
                                    .meaning = "torque in motion"});
           });
    v.only(bit.law == string::BitLaw::regenerative,
           {"a key of another law", "none, or law = \"regenerative\""}, [&] {
             v(bit.force_per_depth, {.name = "axial_stiffness",
                                     .unit = "N/m",
                                     .need = Need::required,
                                     .computed_default = "regenerative: required",
                                     .range = up_to_largest,
                                     .meaning = "force of all blades by the depth of one"});
             v(bit.torque_per_depth, {.name = "torsional_stiffness",
                                      .unit = "N",
                                      .need = Need::required,
                                      .computed_default = "regenerative: required",
                                      .range = up_to_largest,
                                      .meaning = "torque of all blades by that depth"});
             v(bit.contact_force, {.name = "contact_force",
                                   .unit = "N",
                                   .computed_default = "0",
                                   .range = up_to_largest,
                                   .meaning = "regenerative: on wear flats while it advances"});
             v(bit.contact_lever, {.name = "contact_lever",
                                   .unit = "m",
                                   .computed_default = "0",
                                   .range = up_to_largest,
                                   .meaning = "regenerative: torque over that force"});
             v(bit.pitch, {.name = "pitch",
                           .unit = "rad",
                           .need = Need::required,
                           .computed_default = "regenerative: required",
                           .range = Range::positive(),
                           .meaning = "angle between blades"});
           });
  }
};

/// [output] of `tdbd string`.
struct StringOutput {
  long history_every = 1;

  static constexpr TableKey table{"output", "what is recorded"};
  void visit(FieldVisitor& v) {
    v(history_every, {.name = "history_every",
                      .computed_default = "at most 10 000 rows",
                      .lo = 1,
                      .hi = 1'000'000'000,
                      .meaning = "steps between rows of the history"});
  }
};

/// [motion] of `tdbd string`, whose defaults depend on the top.
struct StringMotion {
  static constexpr TableKey table{"motion", "how the bit moves"};
  void visit(FieldVisitor& v) {
    v.any(motion_keys::rotary_speed);
    v.any(motion_keys::rate_of_penetration);
    v.any(motion_keys::weight_on_bit);
    v.any(motion_keys::weight_at_start);
    v.any(motion_keys::torque_at_start);
  }
};

/// A chain with a bit that has no shape, and their initial state.
struct ChainPlan {
  StringPlan string;
  string::Chain chain;
  string::SimpleBit bit;
  double bit_weight = 0.0;  ///< N, without the last cell, for a vertical string
  ChainStart start = ChainStart::steady;
  string::SteadyMotion motion;  ///< at the start
  double rotary_speed = 0.0;    ///< of the top, rad/s
  double rate = 0.0;            ///< of the block, m/s
  double hook_load = 0.0;       ///< N: Top::Axial::hook_load
  double surface_weight = 0.0;  ///< N, that is kept: Top::Axial::autodriller
  RigLog log;                   ///< replaces these values, which are those of its start
  double longest_step = 0.0;    ///< s, the longest that is stable
};

/// Reads the tables [string], [string.*] and [motion] for steps of this length (s). Records
/// mistakes; appends warnings.
ChainPlan read_chain_plan(Config& whole, double step, std::vector<CaseWarning>& warnings);

/// Static torque and drag without mud: the motion of the string, and its loads.
struct StaticLoad {
  std::string name;  ///< "pull_up", "slack_off", "rotate", "drill"
  string::SteadyLoad load;
};

/// Returns the loads of a chain off bottom, whose last element carries `hanging` (N), and those
/// with the pull and torque of `start` if these differ from hanging.
std::vector<StaticLoad> static_loads(const string::Chain& chain, double hanging,
                                     const string::SteadyMotion& start);

/// Returns the first three free vibrations of each kind, with the top at rest and the bit off
/// bottom.
struct ChainModes {
  std::vector<string::Mode> axial, torsional;
};

/// `mass` (kg) and `inertia` (kg m2): of the bit, including the last cell.
ChainModes chain_modes(const string::Chain& chain, double mass, double inertia);

/// The number of elements that the fastest waves pass in a step.
struct CourantNumbers {
  double axial = 0.0, torsional = 0.0;
};
CourantNumbers courant_numbers(const std::vector<string::Section>& sections, double element_length,
                               double step);

/// The properties of a chain that are checked for doubtful values.
struct DoubtfulChain {
  const StringPlan& string;
  const string::Chain& chain;
  std::vector<StaticLoad> loads;
  double hole_diameter = 0.0;      ///< m; 0: unknown
  double passing_frequency = 0.0;  ///< of the bit's blades, Hz; 0: none
};

/// Warns if a static load compresses the string beyond its sinusoidal buckling, 2 sqrt(E I w
/// sin/clearance), which a soft string does not model; and if the waves excited by the blades of
/// the bit have fewer than ten elements per wavelength.
std::vector<CaseWarning> chain_warnings(const Config& c, const DoubtfulChain& doubtful);

}  // namespace tdbd::simulation
