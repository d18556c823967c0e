#pragma once

#include "bit/bit.hpp"

namespace tdbd::bit {

/// How the teeth of a gage row move rock; those of inner rows move it straight down. All four rules
/// are reconstructed: thesis 4.1.2.2 only states that a direction belongs to a region of the bit.
enum class GageRule {
  normal,     ///< each vertex along the tooth's normal there (Part::core_P), bit (9)
  row,        ///< one direction per row: its normal in the journal's plane, outward and down
  down,       ///< straight down, like inner rows
  horizontal  ///< straight outwards
};

/// Sets the update direction of every tooth of a roller cone bit. The core of a tooth is the axis
/// of a pin with a round end of the tooth's diameter, up to the centre of that end.
void direct_teeth(Bit& bit, GageRule rule);

}  // namespace tdbd::bit
