#pragma once

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "dynamics/drilling/drilling_step.hpp"
#include "dynamics/drilling/energy_ledger.hpp"
#include "simulation/case/read_chain.hpp"
#include "simulation/step/diagnosis.hpp"
#include "simulation/step/energy_order.hpp"
#include "simulation/step/simulation.hpp"

// The results of a run for the bit's motion, its string and its wear, and their JSON.

namespace tdbd::simulation {

/// The values of the equations of motion in a row of the history.
struct DriveRow {
  double rock_z = 0.0;        ///< m
  double string_twist = 0.0;  ///< rad, angle of the top relative to the bit
  double stored = 0.0;        ///< J, kinetic and elastic
  double top = 0.0, cutting = 0.0, lost = 0.0, residual = 0.0;  ///< J, since the start
  // For a string on a chain.
  double hook_load = 0.0, surface_torque = 0.0;  ///< N, N m
  double top_speed = 0.0, block_speed = 0.0;     ///< rad/s, m/s
};

DriveRow drive_row(const dynamics::DrillingSystem& system, const dynamics::Drilling& drilling,
                   const dynamics::DrillingWork& work, double turned);

/// The results of a run for the motion of a bit that forces move.
struct DriveFigures {
  dynamics::StoredEnergy stored;  ///< at the end
  dynamics::EnergyLedger ledger;
  std::map<std::string, double> cutting_by_part;  ///< J, power times step: of first order
  Expected expected;
  EnergyOrder order;
  ImplicitStatistics standing;
};

/// Computes the natural frequencies of string and mass without rock, and the frequency of rolling
/// in the hole at a rotary speed (rad/s): sqrt(k/m)/2 pi with the inertia about the bit's axis, and
/// w R/(Rh - R)/2 pi. For a string on a chain, the axial and torsional frequencies are the first
/// modes of the whole string with the bit at its end (chain_modes).
Expected expected_of(const dynamics::DrillingSystem& system, double rotary_speed);

/// Returns "energy" of summary.json: every entry in J, the residual and its ratio to the work of
/// the top.
nlohmann::ordered_json energy_json(const DriveFigures& figures);

/// Returns "energy_residual_order_of" of summary.json: window, steps and residuals, or why there is
/// no order.
nlohmann::ordered_json energy_order_json(const EnergyOrder& order);

/// Returns "implicit_forces" of the counters of summary.json: steps whose forces were solved for
/// together with the velocity, how many of these did not converge, and the longest search.
nlohmann::ordered_json implicit_forces_json(const ImplicitStatistics& statistics);

/// Returns "diagnosis" of summary.json: measured and expected frequencies.
nlohmann::ordered_json diagnosis_json(const Diagnosis& diagnosis, const Expected& expected);

/// The results of a summary for a string on a chain.
struct StringSummary {
  double length = 0.0, element_length = 0.0;  ///< m
  int elements = 0;
  std::vector<StaticLoad> statics;
  ChainModes modes;
  double longest_step = 0.0;  ///< longest stable time step, s
  CourantNumbers courant;
  double node_rest_share = 0.0;  ///< share of pairs of node and step that were at rest
};

/// Computes StringSummary::node_rest_share. `at_rest`: number of pairs of node and step that were
/// at rest during `steps` steps.
double node_rest_share(const string::Chain& chain, long at_rest, long steps);

/// Returns the values that do not depend on time steps: lengths, static loads, frequencies.
nlohmann::ordered_json statics_json(const StringSummary& figures);

/// Returns the values that do: the longest stable time step, Courant numbers, the share of nodes at
/// rest.
nlohmann::ordered_json steps_json(const StringSummary& figures);

/// The wear of a piece at the end of a run.
struct PieceWearFigures {
  std::string name;
  bool is_cutter = true;  ///< otherwise a tooth or a gage pad
  bit::WearFlat flat;     ///< of run and table; the volume is that of the run
  double pending = 0.0;   ///< m3, worn since the last wear step and not yet removed from the mesh
  PieceRub rub;           ///< in the last step
};

/// The wear of a bit: "wear" of summary.json.
struct WearFigures {
  double acceleration = 1.0;
  double distance = 0.0;  ///< m, acceleration times downward displacement
  long steps = 0;         ///< wear steps
  double ledger_defect = 0.0;
  double mass_lost = 0.0;  ///< kg
  double worn = 0.0;       ///< m3, of all pieces
  double largest = 0.0;    ///< m3, of the piece with the greatest wear
  double unevenness =
      0.0;  ///< standard deviation of worn volumes over their mean, of the pieces that wore
  bit::DullGrade grade;
  std::vector<PieceWearFigures> pieces;
  std::vector<WearRecord> records;
};

/// Computes the wear so far of a simulation of this case, whose bit must be one that wears.
WearFigures figures_of_wear(const Case& c, const Simulation& s);

nlohmann::ordered_json wear_json(const WearFigures& f);

}  // namespace tdbd::simulation
