#pragma once

#include <span>
#include <string_view>

#include "forces/law.hpp"
#include "forces/rock/quoted.hpp"

namespace tdbd::forces {

/// Coefficients of a law from the literature, for one rock and one tool.
struct Fit {
  std::string_view name;  ///< for example "glowka-berea-0.5in"
  Law law;
  Evidence evidence = Evidence::assumed;
  std::string_view source;
};

/// All fits. They are for atmospheric pressure unless the source states otherwise.
std::span<const Fit> known_fits();

/// The fit with this name. Throws InputError with the list of names if there is none.
const Fit& fit_named(std::string_view name);

}  // namespace tdbd::forces
