#pragma once

#include <optional>
#include <string_view>

#include "bit/part_kind.hpp"
#include "core/config/config.hpp"

namespace tdbd::forces {

/// Description of a coefficient of a law L. With it a case reader can handle all laws alike.
template <class L>
struct Coefficient {
  std::string_view key;            ///< key in a case
  std::string_view unit;           ///< of the SI value, in the notation of UDUNITS-2
  double L::*member;               ///< member that stores the value
  std::optional<double> fallback;  ///< default, SI; none: required
  Range range;                     ///< SI
  std::string_view meaning;        ///< one line for users
  /// The kinds of part whose force it can change; the default is all that the law applies to.
  bool (*where)(bit::PartKind) = &L::knows;
};

/// For coefficients that affect only faces.
constexpr bool on_face(bit::PartKind kind) { return kind == bit::PartKind::face; }

/// Default speed below which forces fade, m/s: a thousandth of the speed at the gage of a bit. An
/// addition of TDBD [+].
inline constexpr double usual_slip_speed = 1e-3;

/// The coefficient that every law has (slip_share).
template <class L>
Coefficient<L> slip_speed_of() {
  return {"slip_speed",          "m/s",
          &L::slip_speed,        usual_slip_speed,
          Range::non_negative(), "speed below which the force fades"};
}

/// The two coefficients of laws whose friction decreases with speed (friction_at).
template <class L>
Coefficient<L> weakening_of() {
  return {"weakening",
          "1",
          &L::weakening,
          0.0,
          Range::within(0.0, 1.0),
          "share of mu that is lost at high speed"};
}
template <class L>
Coefficient<L> weakening_speed_of() {
  return {"weakening_speed",   "m/s",
          &L::weakening_speed, 1.0,
          Range::positive(),   "speed at which most of that is lost"};
}

}  // namespace tdbd::forces
