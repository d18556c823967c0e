#pragma once

#include <string>
#include <utility>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "core/config/field.hpp"
#include "mesh/files/solids.hpp"

namespace tdbd::bit {

// Ranges of a bit's settings. Values outside them are mistakes of units, and their products with
// others may overflow.

inline constexpr double largest_bit = 10.0;  ///< m
inline constexpr Range bit_length{.lo = 0.0, .hi = largest_bit, .ends = Range::Ends::open_lo};
inline constexpr Range bit_length_or_none = Range::within(0.0, largest_bit);
inline constexpr Range bit_place = Range::within(-largest_bit, largest_bit);

/// kg/m3; the densest element has 22 600.
inline constexpr Range any_density = Range::within(0.0, 3e4);

// Checks that the readers of parts, solids and bodies share.

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

/// Whether the header of a mesh file states a unit other than the one given, m. Records that as a
/// mistake at the key `unit`.
bool contradicts_unit(Config& c, const std::string& file, double unit);

/// The usual range of sizes of a kind of object.
struct SizeRange {
  const char* thing;   ///< its name in messages: "a bit"
  double least, most;  ///< m
};

inline constexpr SizeRange bit_across{"a bit", 0.02, 1.2};  ///< twice the largest radius
/// longest side of its bounding box
inline constexpr SizeRange part_along{"a bit's part", 0.0, 2.0};
/// longest side of its bounding box
inline constexpr SizeRange body_along{"a body", 0.01, 20.0};

/// Returns a question for messages if a size is unusual, because a mesh read in the wrong unit has
/// an unusual size. It lists the sizes in other units: "a size of 1.2e+04 mm, where a bit has 20 to
/// 1200 mm: is it in mm (unit = \"1 mm\": 12 mm)?". Empty if the size is usual. `size`: m; `unit`:
/// length of the file's unit, m.
std::string unit_question(double size, double unit, const SizeRange& usual);

/// Reads the key unit_check of a file: "on", or "off" to allow objects of unusual size.
bool unit_check_enabled(Config& c);

/// Records a mistake at `key` if the parts together do not have the size of a bit. `unit`: of the
/// files, m.
void unit_error(Config& c, const std::string& key, const std::vector<Part>& parts, double unit);

/// Records a mistake at `key` if a mesh does not have the usual size of its kind of object.
void unit_error(Config& c, const std::string& key, const mesh::TriangleMesh& m, double unit,
                const SizeRange& usual);

}  // namespace tdbd::bit
