#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "mesh/files/solids.hpp"

namespace tdbd::bit {

/// Whether a name has only letters, digits, - and _, with / between: names become paths of files
/// and keys of results.
bool is_part_name(const std::string& name);

/// The key update_direction, (x, 0, z) at azimuth 0, made a unit vector. Notes a mistake.
Vec3 read_direction(Config& c, const Vec3& fallback);

/// "a, b, c"; of more than ten names the first ten and how many more there are.
std::string listed(const std::vector<std::string>& names);

/// What a missing density should be, for messages.
inline constexpr const char* density_wanted =
    "a density, or 0 for what is counted elsewhere: mass properties are asked for";

/// Notes, at the key that names a mesh file, what is wrong with its solids and how to repair them.
void note_mesh_faults(Config& c, const std::string& key, const std::string& file,
                      const std::vector<mesh::Solid>& solids, const std::string& expected);

}  // namespace tdbd::bit
