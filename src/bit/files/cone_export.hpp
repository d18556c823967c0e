#pragma once

#include <string>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// A roller cone bit as the text of a bit file (cone_file.hpp), in SI, with the places along the
/// journals and the height that it was given: what read_bit makes of it is the same bit to
/// rounding, and its cones turn. Overlaps of neighbouring cones are reported, not refused: the bit
/// was built.
std::string cone_bit_text(const Bit& bit);

}  // namespace tdbd::bit
