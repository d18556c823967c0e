#pragma once

#include <optional>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "forces/law.hpp"
#include "simulation/case/case_warning.hpp"

namespace tdbd::simulation {

/// A table of a case that names a law, and who follows it.
struct LawTable {
  std::string name;                      ///< "forces", "forces.chamfer"
  forces::Law law;                       ///< as read
  std::optional<forces::Law> fit;        ///< of the key `coefficients`, before the keys beside it
  std::vector<bit::PartKind> followers;  ///< kinds of part, whether or not the bit has them
};

/// A warning for each coefficient that the table gives, that no part of the bit feels, and that
/// could be left out: it is not required, and its value is not the usual one.
std::vector<CaseWarning> idle_coefficients(const Config& table, LawTable law_table,
                                           const bit::Bit& bit);

}  // namespace tdbd::simulation
