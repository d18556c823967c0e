#pragma once

#include <filesystem>
#include <string>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// A text as a string of TOML.
std::string quoted(const std::string& text);

/// A vector as an array of TOML, to the last bit.
std::string vector_text(const Vec3& v);

/// Writes every part's mesh in its own frame, in m, to parts/NAME.FORMAT, and bit.toml, which
/// read_bit reads back. `format` as of mesh::write_mesh: ply, off and obj keep every bit of the
/// coordinates, stl rounds them to single precision. Parts of a cutter take their update direction
/// from its frame again, so that its rule stays open; the others keep theirs. Of a bit with cones
/// bit.toml holds the cones themselves (cone_bit_text), so that they turn when read back.
/// Throws RunError when a file cannot be written, InputError for an unknown format.
void export_bit(const std::filesystem::path& folder, const Bit& bit, const std::string& format);

/// cutters.csv: the cutter table, from which `table = "cutters.csv"` builds the same cutters to the
/// last bit. Nothing for a bit without a table. Throws RunError when it cannot be written.
void write_cutter_table(const std::filesystem::path& folder, const Bit& bit);

/// profile.csv: the exposure profile (r_m, z_m) from the axis to the gage; of a bit with cones what
/// they touch in full turns (swept_parts). Thesis: fig. 3.8.
void write_profile(const std::filesystem::path& folder, const Bit& bit);

}  // namespace tdbd::bit
