#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// Origin of a rock file written at the end of a run, stored in comments of its PLY header.
struct RockStamp {
  long step = 0;          ///< number of steps of the motion before it was written
  double time = 0.0;      ///< s, time of the motion
  std::string case_hash;  ///< hash of the case of the run
};

/// The comment lines without the word `comment`: "tdbd step 60", "tdbd time_s 0.06", "tdbd
/// case_hash 0123".
std::vector<std::string> comments_of(const RockStamp& stamp);

/// The stamp of a file. Nothing if it is no PLY file or lacks one of the comments.
std::optional<RockStamp> read_stamp(const std::filesystem::path& file);

/// If the run continues from a rock file, checks that the stamp of the rock has the time of the
/// motion after its first steps. Otherwise throws InputError that names time.first_step. Rocks
/// without a stamp and motions that start at t = 0 are not checked.
void require_same_time(const Case& c);

}  // namespace tdbd::simulation
