#pragma once

namespace tdbd {

/// Single precision, used to reject candidates conservatively with a margin for its rounding, and
/// where a file format requires it. No result is computed in it. It needs half the memory of double
/// and has twice the lanes.
using Single = float;

}  // namespace tdbd
