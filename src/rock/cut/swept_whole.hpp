#pragma once

#include <optional>

#include "rock/cut/swept_part.hpp"

namespace tdbd::rock {

/// How far a vertex moves, and through the surface of which part of its group it leaves.
struct WholeExit {
  std::size_t part;  ///< index into CuttingGroup::parts
  double t;          ///< m, > 0
};

/// Converts a crossing of the whole's solid, with its planes numbered as there. Returns nothing if
/// the vertex does not move.
std::optional<WholeExit> whole_exit(const CuttingWhole& whole, const RelativePath& path,
                                    const Crossing& x);

/// Returns the exit of a path for which prepare_exits was called with whole.solid. Nothing if the
/// whole does not sweep it.
std::optional<WholeExit> prepared_whole_exit(const CuttingWhole& whole, const RelativePath& path,
                                             const SweptScratch& scratch);

}  // namespace tdbd::rock
