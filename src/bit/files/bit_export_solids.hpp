#pragma once

#include <filesystem>
#include <string>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Writes the whole bit to one file, bit.FORMAT, in the bit's frame and in m (cones at the angle
/// 0), and solids.toml, which read_bit reads back to the same parts: positions X_BP x_P to the last
/// bit, names, kinds, densities, groups, update directions. stl is text with a named solid for each
/// part, obj has a group for each; ply and off have no names, so solids.toml gives them by number.
/// Throws RunError when a file cannot be written, InputError for an unknown format.
void export_solids(const std::filesystem::path& folder, const Bit& bit, const std::string& format);

}  // namespace tdbd::bit
