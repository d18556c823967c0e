#pragma once

#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Indices of the cutters that analyses before drilling include: those whose face cuts when the bit
/// starts. Cutters that an area turns off, or that start later, are excluded. A cutter without a
/// face is included if one of its parts cuts.
std::vector<int> counted_cutters(const Bit& bit);

/// Returns these cutters of a bit.
std::vector<Cutter> cutters_at(const Bit& bit, std::span<const int> indices);

/// Expands values of these cutters to all cutters; the others get `otherwise`.
std::vector<double> among_all(const Bit& bit, std::span<const int> indices,
                              std::span<const double> values, double otherwise);

/// Names of the excluded cutters: "cutter-3, cutter-5".
std::string uncounted_names(const Bit& bit);

}  // namespace tdbd::bit
