#pragma once

#include <optional>
#include <string>

#include "core/config/config.hpp"
#include "forces/law.hpp"

namespace tdbd::simulation {

/// The key `coefficients`: a law with coefficients from the literature; none: not given.
std::optional<forces::Law> read_fit(Config& c);

/// The law that a table names, with its coefficients; a table that names none has `usual` (empty:
/// it must name one). Coefficients that the table does not give are those of the key
/// `coefficients`, else the law's defaults; those without a default are required.
forces::Law read_law(Config& c, const std::string& usual);

}  // namespace tdbd::simulation
