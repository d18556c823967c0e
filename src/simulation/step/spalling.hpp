#pragma once

#include <optional>
#include <vector>

#include "core/compensated_sum.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::simulation {

/// Rock that breaks out beside the faces, as a restart needs it.
struct SpallingState {
  std::vector<rock::EngagedEnds> ends;     ///< per cutter, of the last section of its face
  std::vector<CompensatedSum> broken_out;  ///< m3, per cutter, of what its face removed
};

/// None for a case in which no rock breaks out.
std::optional<SpallingState> start_spalling(const SpallingPlan& plan);

/// Adds the bodies that break rock out around the faces to the cutting bit, and returns them. Empty
/// where no rock breaks out.
std::vector<rock::Breakout> breakouts_of(const Case& c, const bit::Bit& bit,
                                         const MeasuredFaces& faces, rock::CuttingBit& cutting);

/// Before a cut: lets cracks start where the last sections put the ends of the engaged edges,
/// unless the rock at the face's tip does not break out. `X_WB`: the bit over the rock.
void place_breakouts(const Case& c, const Pose& X_WB, const std::vector<rock::Breakout>& breakouts,
                     const SpallingState& state, rock::CuttingBit& cutting);

/// After a cut and its measures: notes what broke out, and where the next cracks start.
void follow_breakouts(const bit::Bit& bit, const rock::CutReport& cut, const Measures& measures,
                      SpallingState& state);

}  // namespace tdbd::simulation
