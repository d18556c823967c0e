#pragma once

#include <optional>

#include "rock/cut/swept_part.hpp"

namespace tdbd::rock {

/// How far a vertex goes, and through the surface of which part of its group it leaves.
struct WholeExit {
  std::size_t part;  ///< index into CuttingGroup::parts
  double t;          ///< > 0
};

/// What a crossing of the whole's solid says, with the planes numbered as there; nothing if the vertex
/// stays.
std::optional<WholeExit> whole_exit(const CuttingWhole& whole, const RelativePath& path,
                                    const Crossing& x);

/// The exit of one of the paths for which prepare_exits was called with whole.solid, if the whole
/// sweeps it.
std::optional<WholeExit> prepared_whole_exit(const CuttingWhole& whole, const RelativePath& path,
                                             const SweptScratch& scratch);

}  // namespace tdbd::rock
