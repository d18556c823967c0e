#pragma once

#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"

namespace tdbd::bit {

/// The sizes that a drawn thing usually has.
struct SizeRange {
  const char* thing;   ///< "a bit"
  double least, most;  ///< m
};

inline constexpr SizeRange bit_across{"a bit", 0.02, 1.2};        ///< twice the largest radius
inline constexpr SizeRange part_along{"a bit's part", 0.0, 2.0};  ///< longest side of its box
inline constexpr SizeRange body_along{"a body", 0.01, 20.0};      ///< longest side of its box

/// A mesh read in the wrong unit has a size that its kind of thing does not have. The question
/// whether it is in another unit, with the sizes that it would then have: "a size of 1.2e+04 mm,
/// where a bit has 20 to 1200 mm: is it in mm (unit = \"1 mm\": 12 mm)?". Empty if the size is
/// usual. `size` is in m, with file units of `unit` metres.
std::string unit_question(double size, double unit, const SizeRange& usual);

/// The key unit_check of a file: "on", or "off" to admit things of unusual size.
bool checks_units(Config& c);

/// Notes at `key` if the parts together do not have the size of a bit; `unit` (m) is that of the
/// files.
void ask_for_unit(Config& c, const std::string& key, const std::vector<Part>& parts, double unit);

/// Notes at `key` if a mesh does not have the usual size of its kind of thing.
void ask_for_unit(Config& c, const std::string& key, const mesh::TriangleMesh& m, double unit,
                  const SizeRange& usual);

}  // namespace tdbd::bit
