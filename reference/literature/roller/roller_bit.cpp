#include "reference/literature/roller/roller_bit.hpp"

#include <cmath>

namespace tdbd::reference {

JournalAxes journal_axes(const RollerCone& cone) {
  const double cosine = std::cos(cone.journal_angle), sine = std::sin(cone.journal_angle);
  return {Vec3(-cosine, 0.0, sine), Vec3(sine, 0.0, cosine)};
}

}  // namespace tdbd::reference
