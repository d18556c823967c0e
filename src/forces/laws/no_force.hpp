#pragma once

#include <span>
#include <string_view>

#include "forces/part/coefficient.hpp"
#include "forces/part/part_cut.hpp"

namespace tdbd::forces {

/// No force: the part only cuts the rock.
struct NoForce {
  static constexpr std::string_view name = "none";
  static constexpr bool knows(bit::PartKind) { return true; }
  static std::span<const Coefficient<NoForce>> coefficients() { return {}; }
};

inline PartForce law_force(const NoForce&, const PartCut& cut) {
  return {.force = Vec3::Zero(), .point = cut.point, .normal = 0.0, .tangential = 0.0};
}

}  // namespace tdbd::forces
