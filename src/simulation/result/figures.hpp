#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "dynamics/drilling/drilling_step.hpp"
#include "dynamics/drilling/energy_ledger.hpp"
#include "dynamics/drilling/residual_order.hpp"
#include "simulation/case/chain_statics.hpp"
#include "simulation/step/diagnosis.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/simulation.hpp"

// What a run reports of the bit's motion, of its string and of its wear, and the JSON of these.

namespace tdbd::simulation {

/// What the equations of motion leave in a row of the history.
struct DriveRow {
  double rock_z = 0.0;                                          ///< m
  double string_twist = 0.0;                                    ///< rad, of the top over the bit
  double stored = 0.0;                                          ///< J, kinetic and elastic
  double top = 0.0, cutting = 0.0, lost = 0.0, residual = 0.0;  ///< J, since the start
  // Of a string on a chain.
  double hook_load = 0.0, surface_torque = 0.0;  ///< N, N m
  double top_speed = 0.0, block_speed = 0.0;     ///< rad/s, m/s
};

DriveRow drive_row(const dynamics::DrillingSystem& system, const dynamics::Drilling& drilling,
                   const dynamics::DrillingWork& work, double turned);

/// What a run of a bit that forces move reports of its motion.
struct DriveFigures {
  dynamics::StoredEnergy stored;  ///< at the end
  dynamics::EnergyLedger ledger;
  std::map<std::string, double> cutting_by_part;  ///< J, power times step: first order in it
  Expected expected;
  EnergyOrder order;
  StandingStatistics standing;
};

/// Frequencies of string and mass alone, without rock, and of rolling in the hole at a rotary speed
/// (rad/s): sqrt(k/m)/2 pi with the inertia about the bit's axis, w R/(Rh - R)/2 pi. Of a string on a chain
/// axial and torsional are the first modes of the whole string with the bit at its end (chain_modes).
Expected expected_of(const dynamics::DrillingSystem& system, double rotary_speed);

/// "energy" of summary.json: every entry in J, residual and its share of what the top did.
nlohmann::ordered_json energy_json(const DriveFigures& figures);

/// "energy_residual_order_of" of summary.json: why there is none, the window, steps and residuals.
nlohmann::ordered_json energy_order_json(const EnergyOrder& order);

/// "standing" of summary.json: steps whose forces were solved for with the velocity, how many of
/// these searches did not settle, and the longest of them.
nlohmann::ordered_json standing_json(const StandingStatistics& standing);

/// "diagnosis" of summary.json: measured frequencies beside the expected ones.
nlohmann::ordered_json diagnosis_json(const Diagnosis& diagnosis, const Expected& expected);

/// What a summary reports of a string on a chain.
struct StringFigures {
  double length = 0.0, element_length = 0.0;  ///< m
  int elements = 0;
  std::vector<StaticLoad> statics;
  ChainModes modes;
  double longest_step = 0.0;  ///< that is stable, s
  CourantNumbers courant;
  double node_rest_share = 0.0;  ///< of nodes times steps
};

/// `at_rest`: nodes times steps that were at rest, of this number of steps.
double node_rest_share(const string::Chain& chain, long at_rest, long steps);

/// What does not depend on time steps: lengths, static loads, frequencies.
nlohmann::ordered_json statics_json(const StringFigures& figures);

/// What does: the longest stable step, Courant numbers, the share of node-steps at rest.
nlohmann::ordered_json steps_json(const StringFigures& figures);

/// The wear of a piece at the end of a run.
struct PieceWearFigures {
  std::string name;
  bool is_cutter = true;  ///< or a tooth or a gage pad
  bit::WearFlat flat;     ///< of run and table; its volume is that of the run
  double pending = 0.0;   ///< m3, worn since the last wear step and not yet cut from the mesh
  PieceRub rub;           ///< of the last step
};

/// The wear of a bit: `wear` of summary.json.
struct WearFigures {
  double acceleration = 1.0;
  double distance = 0.0;  ///< m of wear
  long steps = 0;         ///< wear steps
  double ledger_defect = 0.0;
  double mass_lost = 0.0;  ///< kg
  double worn = 0.0;       ///< m3, of all pieces
  double largest = 0.0;    ///< m3, of the piece that is worn most
  double unevenness =
      0.0;  ///< standard deviation of worn volumes over their mean, of the pieces that wore
  bit::DullGrade grade;
  std::vector<PieceWearFigures> pieces;
  std::vector<WearRecord> records;
};

/// The wear of a simulation of this case so far; its bit must wear.
WearFigures figures_of_wear(const Case& c, const Simulation& s);

nlohmann::ordered_json wear_json(const WearFigures& f);

}  // namespace tdbd::simulation
