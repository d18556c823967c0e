#pragma once

#include <string>
#include <vector>

#include "simulation/case/motion.hpp"

namespace tdbd::simulation {

/// Reads a path: CSV with the columns time_s, x_m, y_m, z_m, rx_rad, ry_rad, rz_rad (place of the
/// bit's origin and rotation vector, spatial frame). Throws InputError for a missing column, NaN,
/// fewer than two rows, or times that do not rise, with the file's line.
std::vector<PathPoint> read_path_table(const std::string& path);

}  // namespace tdbd::simulation
