#pragma once

#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "core/config/config.hpp"

namespace tdbd::calibration {

/// Reads [unknowns.KEY] and [fixed] of a law, and sets its coefficients. A coefficient in neither
/// has its default; one without a default must be in one of them. No unknown: a law as it stands is
/// held against the records. Mistakes are noted.
std::vector<Unknown> read_unknowns(Config& c, forces::Law& law);

/// Reads [unknowns.KEY] of a coefficient. Mistakes are noted.
Unknown read_unknown(Config table, const forces::LawField& field);

/// Notes every name in a table that is no coefficient of the law of this name.
void refuse_strangers(Config& table, const std::vector<forces::LawField>& fields,
                      std::string_view law);

}  // namespace tdbd::calibration
