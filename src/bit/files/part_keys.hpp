#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "mesh/files/solids.hpp"

namespace tdbd::bit {

/// Letters, digits, - and _, in folders by /: names become paths of files and keys of results.
bool is_part_name(const std::string& name);

/// The key update_direction, (x, 0, z) at azimuth 0 made unit; a mistake is noted.
Vec3 read_direction(Config& c, const Vec3& fallback);

/// "a, b, c", and how many more there are than ten.
std::string listed(const std::vector<std::string>& names);

inline constexpr const char* density_wanted =
    "a density, or 0 for what is counted elsewhere: mass properties are asked for";

/// Notes what is wrong with the solids of a mesh file, and what repairs it, at the key that names
/// the file.
void note_mesh_faults(Config& c, const std::string& key, const std::string& file,
                      const std::vector<mesh::Solid>& solids, const std::string& expected);

}  // namespace tdbd::bit
