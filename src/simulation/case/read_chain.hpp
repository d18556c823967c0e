#pragma once

#include <vector>

#include "core/config/config.hpp"
#include "simulation/case/case_warning.hpp"
#include "simulation/case/chain_keys.hpp"
#include "simulation/case/plans.hpp"
#include "simulation/case/rig_log.hpp"
#include "string/simple_bit.hpp"
#include "string/statics.hpp"

namespace tdbd::simulation {

/// Reads sections, survey and friction of the table [string], which it checks against each other.
/// `step`: s, for the default loss time. Notes mistakes in the file; appends warnings. In read_string.cpp.
StringPlan read_string_plan(Config& whole, double step, std::vector<CaseWarning>& warnings);

/// A string on a chain and its top, without what hangs below.
struct ChainAbove {
  StringPlan string;
  string::Chain chain;
  ChainStart start = ChainStart::steady;
};

/// Reads [string] and its tables for a bit of this inertia (kg m2), with what is rigid with it, which the
/// usual frequency of soft-torque depends on. Notes mistakes in the file; appends warnings.
ChainAbove read_chain_above(Config& whole, double step, double inertia,
                            std::vector<CaseWarning>& warnings);

/// The longest stable step (s) with a bit of this mass (kg) and inertia (kg m2), the last cell included;
/// 0: they cannot move. Notes a mistake if `step` is longer.
double check_chain_step(Config& whole, double step, const string::Chain& chain, double mass,
                        double inertia);

/// The hook load at the start, N: of the log, or what [string.top] gives and refuses without one; `usual`:
/// that of the static equilibrium.
double read_hook_load(Config& whole, const dynamics::Schedule& logged, const string::Chain& chain,
                      double usual);

/// Reads the keys of a chain in [output] for steps of this length (s). Notes mistakes in the file.
ChainOutput read_chain_output(Config& output, const string::Chain& chain, double step);

/// Refuses them where there is no chain.
void refuse_chain_output(Config& output);

/// A chain with a bit that has no shape, and how both start.
struct ChainPlan {
  StringPlan string;
  string::Chain chain;
  string::SimpleBit bit;
  double bit_weight = 0.0;  ///< without the last cell, vertical, N
  ChainStart start = ChainStart::steady;
  string::SteadyMotion motion;  ///< at the start
  double rotary_speed = 0.0;    ///< of the top, rad/s
  double rate = 0.0;            ///< of the block, m/s
  double hook_load = 0.0;       ///< N: Top::Axial::hook_load
  double surface_weight = 0.0;  ///< to be kept, N: Top::Axial::autodriller
  RigLog log;                   ///< in place of these values, which are those of its start
  double longest_step = 0.0;    ///< that is stable, s
};

/// Reads the tables [string], [string.*] and [motion] for steps of this length (s). Notes mistakes in
/// the file; appends warnings.
ChainPlan read_chain_plan(Config& whole, double step, std::vector<CaseWarning>& warnings);

}  // namespace tdbd::simulation
