#pragma once

#include <filesystem>
#include <string>

#include "bit/bit.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/length_unit.hpp"

namespace tdbd::bit {

/// How the mesh files of a bit are written. PLY is always in m and in double precision.
struct ExportOptions {
  std::string parts = "ply";                ///< format of the parts: ply, off, obj or stl
  std::string solids = "stl";               ///< format of the files with all parts
  mesh::LengthUnit unit{"mm", 1e-3, -3};    ///< of STL, OBJ and OFF
  mesh::StlKind stl = mesh::StlKind::text;  ///< of the files with all parts
};

/// The unit of files in a format.
mesh::LengthUnit unit_of_format(const ExportOptions& options, const std::string& format);

/// Writes every part's mesh in its own frame to parts/NAME.FORMAT, and bit.toml, which read_bit
/// reads back. ply, off and obj store coordinates exactly (in a decimal unit), stl is binary and
/// rounds them to single precision. When read back, the parts of a cutter derive their update
/// direction from its frame again, so the rule remains selectable; other parts keep their
/// direction. For a bit with cones, bit.toml contains the cones themselves (cone_bit_text), so that
/// they turn when read back. Throws RunError if a file cannot be written, InputError for an unknown
/// format.
void export_bit(const std::filesystem::path& folder, const Bit& bit, const ExportOptions& options);

/// Writes the whole bit to one file, bit.FORMAT, in the bit frame (cones at angle 0), and
/// solids.toml, from which read_bit reads the same parts: bitwise identical positions X_BP x_P
/// (unless stl is binary or the unit is not decimal), names, kinds, densities, groups, update
/// directions. Text stl has a named solid for each part; obj has a group for each part. ply, off and
/// binary stl have no names, so solids.toml refers to their solids by number. Throws RunError if a
/// file cannot be written, InputError for an unknown format.
void export_solids(const std::filesystem::path& folder, const Bit& bit,
                   const ExportOptions& options);

/// The union of all parts in the bit frame (cones at angle 0) as one closed solid, m. Throws
/// InputError if there is no such solid in the precision of the file (mesh::unite).
mesh::TriangleMesh united_parts(const Bit& bit, const ExportOptions& options);

/// Writes that solid to bit-united.FORMAT, in the format of `solids`.
void export_united(const std::filesystem::path& folder, const Bit& bit,
                   const mesh::TriangleMesh& united, const ExportOptions& options);

/// Writes cutters.csv: the cutter table, from which `table = "cutters.csv"` builds bitwise
/// identical cutters. Writes nothing for a bit without a table or design. Throws RunError if it
/// cannot be written.
void write_cutter_table(const std::filesystem::path& folder, const Bit& bit);

/// Writes profile.csv: the exposure profile (r_m, z_m) from the axis to the gage; for a bit with
/// cones, the profile swept in full turns of the cones (swept_parts). Thesis: fig. 3.8.
void write_profile(const std::filesystem::path& folder, const Bit& bit);

}  // namespace tdbd::bit
