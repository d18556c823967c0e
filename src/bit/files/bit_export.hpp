#pragma once

#include <filesystem>
#include <string>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Writes every part's mesh in its own frame, in m, to parts/NAME.FORMAT, and bit.toml, which
/// read_bit reads back. `format` as for mesh::write_mesh: ply, off and obj store coordinates
/// exactly, stl rounds them to single precision. When read back, the parts of a cutter derive their
/// update direction from its frame again, so the rule remains selectable; other parts keep their
/// direction. For a bit with cones, bit.toml contains the cones themselves (cone_bit_text), so that
/// they turn when read back. Throws RunError if a file cannot be written, InputError for an unknown
/// format.
void export_bit(const std::filesystem::path& folder, const Bit& bit, const std::string& format);

/// Writes the whole bit to one file, bit.FORMAT, in the bit frame and in m (cones at angle 0), and
/// solids.toml, from which read_bit reads the same parts: bitwise identical positions X_BP x_P,
/// names, kinds, densities, groups, update directions. stl is text with a named solid for each
/// part; obj has a group for each part. ply and off have no names, so solids.toml refers to their
/// solids by number. Throws RunError if a file cannot be written, InputError for an unknown format.
void export_solids(const std::filesystem::path& folder, const Bit& bit, const std::string& format);

/// Writes cutters.csv: the cutter table, from which `table = "cutters.csv"` builds bitwise
/// identical cutters. Writes nothing for a bit without a table or design. Throws RunError if it
/// cannot be written.
void write_cutter_table(const std::filesystem::path& folder, const Bit& bit);

/// Writes profile.csv: the exposure profile (r_m, z_m) from the axis to the gage; for a bit with
/// cones, the profile swept in full turns of the cones (swept_parts). Thesis: fig. 3.8.
void write_profile(const std::filesystem::path& folder, const Bit& bit);

}  // namespace tdbd::bit
