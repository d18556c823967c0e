#pragma once

#include "verification/bit/files/mesh_bit.hpp"

namespace tdbd::simulation {

using bit::test_folder;
using bit::write_file;
using bit::write_one_part_bit;

/// A case that drills with a bit file: `rock` and `time` are the lines of these tables.
inline std::string write_case(const std::filesystem::path& folder, const std::string& bit_file,
                              const std::string& rock, const std::string& time) {
  return write_file(
      folder / "case.toml",
      "[bit]\nfile = \"" + bit_file + "\"\n[rock]\n" + rock +
          "\n[motion]\nrotary_speed = \"120 rpm\"\nrate_of_penetration = \"60 m/h\"\n" +
          "[time]\n" + time + "\n");
}

}  // namespace tdbd::simulation
