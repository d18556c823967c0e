#pragma once

#include <filesystem>
#include <string>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// Writes every part's mesh in its own frame, in m, to parts/NAME.FORMAT, and bit.toml, which
/// read_bit reads back. `format` as for mesh::write_mesh: ply, off and obj keep every bit of the
/// coordinates, stl rounds them to single precision. Parts of a cutter derive their update
/// direction from its frame again, so the rule stays selectable; other parts keep theirs. For a bit
/// with cones, bit.toml holds the cones themselves (cone_bit_text), so that they turn when read
/// back. Throws RunError when a file cannot be written, InputError for an unknown format.
void export_bit(const std::filesystem::path& folder, const Bit& bit, const std::string& format);

/// Writes the whole bit to one file, bit.FORMAT, in the bit frame and in m (cones at angle 0), and
/// solids.toml, which read_bit reads back to the same parts: positions X_BP x_P to the last bit,
/// names, kinds, densities, groups, update directions. stl is text with a named solid for each
/// part, obj has a group for each; ply and off have no names, so solids.toml refers to their solids
/// by number. Throws RunError when a file cannot be written, InputError for an unknown format.
void export_solids(const std::filesystem::path& folder, const Bit& bit, const std::string& format);

/// cutters.csv: the cutter table, from which `table = "cutters.csv"` builds the same cutters to the
/// last bit. Writes nothing for a bit without a table or design. Throws RunError when it cannot be written.
void write_cutter_table(const std::filesystem::path& folder, const Bit& bit);

/// profile.csv: the exposure profile (r_m, z_m) from the axis to the gage; for a bit with cones,
/// what they touch in full turns (swept_parts). Thesis: fig. 3.8.
void write_profile(const std::filesystem::path& folder, const Bit& bit);

}  // namespace tdbd::bit
