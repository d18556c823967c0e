#pragma once

#include <optional>
#include <vector>

#include "core/compensated_sum.hpp"
#include "simulation/case/case.hpp"
#include "simulation/step/measure.hpp"

namespace tdbd::simulation {

/// State of spalling, sufficient for a restart.
struct SpallingState {
  std::vector<rock::EngagedEnds> ends;     ///< per cutter, from the last section of its face
  std::vector<CompensatedSum> broken_out;  ///< m3, per cutter, part of its removed volume

  template <class Archive>
  void serialize(Archive& a) {
    a(ends, broken_out);
  }
};

/// Nothing if no rock breaks out in the case.
std::optional<SpallingState> start_spalling(const SpallingPlan& plan);

/// Adds the bodies that break out rock around the faces to the cutting bit, and returns them. Empty
/// if no rock breaks out.
std::vector<rock::Breakout> breakouts_of(const Case& c, const bit::Bit& bit,
                                         const MeasuredFaces& faces, rock::CuttingBit& cutting);

/// Called before a cut: places the start of cracks at the ends of the engaged edges in the last
/// sections, unless the rock at the tip of the face does not break out. `X_WB` is the pose of the
/// bit relative to the rock.
void place_breakouts(const Case& c, const Pose& X_WB, const std::vector<rock::Breakout>& breakouts,
                     const SpallingState& state, rock::CuttingBit& cutting);

/// Called after a cut and its measurements: stores the broken-out volume and where the next cracks
/// start.
void follow_breakouts(const bit::Bit& bit, const rock::CutReport& cut, const Measures& measures,
                      SpallingState& state);

}  // namespace tdbd::simulation
