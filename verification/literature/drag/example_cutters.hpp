#pragma once

#include <string>

#include "bit/cutter/cutter_table.hpp"
#include "reference/literature/drag/drag_rock.hpp"

namespace tdbd::reference {

/// Cutters of the example bits A, B and C, sharp.
inline std::vector<bit::Cutter> example_cutters(char letter) {
  return bit::read_cutter_table(std::string(TDBD_SOURCE_DIR "/cases/bits/bit-") + letter + ".csv",
                                bit::CutterDefaults{});
}

inline std::vector<bit::Cutter> without_side_rake(std::vector<bit::Cutter> cutters) {
  for (bit::Cutter& c : cutters) c.side_rake = 0.0;
  return cutters;
}

/// The rock that comparisons of drag models share, sharp: 100 MPa, 0.8.
inline DragRock rock_k() { return {100e6, 0.8, 0.0, 0.0}; }

/// The gage radius of all three bits, m.
inline constexpr double example_gage = 107.95e-3;

}  // namespace tdbd::reference
