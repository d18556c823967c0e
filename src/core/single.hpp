#pragma once

namespace tdbd {

/// Single precision: rejects candidates conservatively, with a margin for its rounding; no result is computed in it.
/// Half the memory, twice the lanes. Files hold it where their format does.
using Single = float;

}  // namespace tdbd
