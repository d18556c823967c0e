#pragma once

#include "bit/bit.hpp"

namespace tdbd::bit {

/// How the teeth of a row at the gage move rock; those of inner rows move it straight down. All are
/// reconstructed (thesis 4.1.2.2 says only that a direction belongs to a region of the bit).
enum class GageRule {
  normal,     ///< each vertex along the tooth's normal there (Part::core_P, formulation 2.3)
  row,        ///< one direction for the row: its normal in the journal's plane, outward and down
  down,       ///< straight down, as inner rows
  horizontal  ///< straight outwards
};

/// Sets the update directions of every tooth of a roller cone bit. The core of a tooth is the axis
/// of a pin with a round end of the tooth's diameter, up to that end's centre.
void direct_teeth(Bit& bit, GageRule rule);

}  // namespace tdbd::bit
