#pragma once

namespace tdbd {

/// Single precision, to turn away what is surely not meant, with room for its rounding; nothing is
/// computed with it. Half the memory, twice the lanes.
using Single = float;

}  // namespace tdbd
