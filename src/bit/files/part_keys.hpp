#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "mesh/files/solids.hpp"

namespace tdbd::bit {

/// Whether a name contains only letters, digits, - and _, with / in between. Names become paths of
/// files and keys of results.
bool is_part_name(const std::string& name);

/// Reads the key update_direction, (x, 0, z) at azimuth 0, and normalizes it. Records a mistake.
Vec3 read_direction(Config& c, const Vec3& fallback);

/// Formats names as "a, b, c". Of more than ten names, the first ten and the number of others.
std::string listed(const std::vector<std::string>& names);

/// What is expected in place of a missing density, for messages.
inline constexpr const char* expected_density =
    "a density, or 0 for what is counted elsewhere: mass properties are required";

/// Records, at the key that names a mesh file, the faults of its solids and how to repair them.
void report_mesh_faults(Config& c, const std::string& key, const std::string& file,
                        const std::vector<mesh::Solid>& solids, const std::string& expected);

}  // namespace tdbd::bit
