#pragma once

namespace tdbd {

/// Single precision: rejects candidates conservatively, with a margin for its rounding; no result is computed in it.
/// Half the memory, twice the lanes.
using Single = float;

}  // namespace tdbd
