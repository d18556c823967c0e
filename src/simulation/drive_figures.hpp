#pragma once

#include <nlohmann/json_fwd.hpp>

#include "dynamics/energy_ledger.hpp"
#include "simulation/diagnosis.hpp"

namespace tdbd::simulation {

/// What a run of a bit that forces move reports of its motion.
struct DriveFigures {
  dynamics::StoredEnergy stored;  ///< at the end
  dynamics::EnergyLedger ledger;
  Expected expected;
};

/// Frequencies of string and mass alone, without rock, and of rolling in the hole at a rotary speed
/// (rad/s): sqrt(k/m)/2 pi with the inertia about the bit's axis, w R/(Rh - R)/2 pi.
Expected expected_of(const dynamics::DrillingSystem& system, double rotary_speed);

/// "energy" of summary.json: every entry in J, residual and its share of what the top did.
nlohmann::ordered_json energy_json(const DriveFigures& figures);

/// "diagnosis" of summary.json: measured frequencies beside the expected ones.
nlohmann::ordered_json diagnosis_json(const Diagnosis& diagnosis, const Expected& expected);

}  // namespace tdbd::simulation
