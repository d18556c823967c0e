#pragma once

#include <vector>

#include "calibration/case/calibration_case.hpp"
#include "core/config/config.hpp"

namespace tdbd::calibration {

/// Reads [unknowns.KEY] and [fixed] of a law, and sets its coefficients. A coefficient in neither
/// table has its default; one without a default must be in one of them. Without unknowns, the law
/// is compared with the records unchanged. Mistakes are recorded.
std::vector<Unknown> read_unknowns(Config& c, forces::Law& law);

/// Reads [unknowns.KEY] of a coefficient. Mistakes are recorded.
Unknown read_unknown(Config table, const forces::LawField& field);

/// Records as a mistake every name in a table that is not a coefficient of the law of this name.
void refuse_strangers(Config& table, const std::vector<forces::LawField>& fields,
                      std::string_view law);

}  // namespace tdbd::calibration
