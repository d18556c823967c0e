#pragma once

#include <string>
#include <vector>

#include "sweep/design/design.hpp"

namespace tdbd::sweep {

/// GSL has direction numbers for so many.
inline constexpr long most_sobol_dimensions = 40;

/// Whether a factor has an interval in place of levels.
bool is_sampled(const Factor& f);

/// The samples of a design: rows of shares in [0, 1), one for each sampled factor. Of a Latin
/// hypercube (McKay, Beckman and Conover 1979) each column has one value in each of `samples` equal
/// parts; Sobol's sequence (1967) begins with its first point, which is the middle.
std::vector<std::vector<double>> samples_of(const Design& d);

/// The points of a design: all combinations of levels, the last factor's the fastest, the samples
/// faster still.
struct Points {
  long count = 0;
  std::vector<std::vector<double>> samples;
};
Points points_of(const Design& d);

/// The level of each factor at a point.
std::vector<Level> levels_at(const Design& d, const Points& points, long index);

/// What the point overrides: the fixed values, then the factors'.
std::vector<std::string> overrides_at(const Design& d, const Points& points, long index);

}  // namespace tdbd::sweep
