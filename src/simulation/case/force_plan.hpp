#pragma once

#include <array>

#include "bit/bit.hpp"
#include "forces/law.hpp"
#include "forces/rock/formation.hpp"

namespace tdbd::simulation {

/// Whether a run asks for forces at all.
enum class Forces { off, on };

/// What the area cut by a face is taken from (formulation 2.6): the section ahead of it [+], or
/// the volume that it removed [R].
enum class CutMeasure { section, volume };

/// What a chamfer's contact is taken from: the engaged edge times its width [+], or the rock
/// triangles that it moved or touches [R].
enum class ChamferMeasure { edge, triangles };

/// The force laws of a run, by kind of part, and the rock that they ask for.
struct ForcePlan {
  Forces forces = Forces::off;
  CutMeasure cut = CutMeasure::section;
  ChamferMeasure chamfer = ChamferMeasure::edge;
  std::array<forces::Law, bit::part_kinds.size()> laws;  ///< by PartKind
  forces::Formation rock;
};

inline const forces::Law& law_of(const ForcePlan& plan, bit::PartKind kind) {
  return plan.laws[static_cast<std::size_t>(kind)];
}

}  // namespace tdbd::simulation
