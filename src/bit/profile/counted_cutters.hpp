#pragma once

#include <span>
#include <string>
#include <vector>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// The cutters that analyses before any drilling count, as indices: those whose face cuts when the bit
/// starts. Cutters that an area turns off, or that start later, are left out. A cutter without a face
/// counts if one of its parts cuts.
std::vector<int> counted_cutters(const Bit& bit);

/// These cutters of a bit.
std::vector<Cutter> cutters_at(const Bit& bit, std::span<const int> indices);

/// Values of these cutters among those of all, the others `otherwise`.
std::vector<double> among_all(const Bit& bit, std::span<const int> indices,
                              std::span<const double> values, double otherwise);

/// "cutter-3, cutter-5": those that are left out.
std::string uncounted_names(const Bit& bit);

}  // namespace tdbd::bit
