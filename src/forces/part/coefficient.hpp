#pragma once

#include <optional>
#include <string_view>

#include "core/config/config.hpp"

namespace tdbd::forces {

/// One coefficient of a law L, described so that a reader of cases needs to know no law.
template <class L>
struct Coefficient {
  std::string_view key;            ///< in a case
  std::string_view unit;           ///< of the SI value, as UDUNITS-2 writes it
  double L::*member;               ///< where it goes
  std::optional<double> fallback;  ///< SI; none: required
  Range range;                     ///< SI
  std::string_view meaning;        ///< a line for a reader
};

/// Speed below which forces fade (m/s), for want of a better one. Ours: a thousandth of the
/// speed at a bit's gage.
inline constexpr double usual_slip_speed = 1e-3;

}  // namespace tdbd::forces
