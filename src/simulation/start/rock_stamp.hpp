#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// What a rock at the end of a run says of itself in comments of its PLY header.
struct RockStamp {
  long step = 0;          ///< steps of the motion that made it
  double time = 0.0;      ///< s, of the motion
  std::string case_hash;  ///< of the run
};

/// The comments, without the word `comment`: "tdbd step 60", "tdbd time_s 0.06", "tdbd case_hash 0123".
std::vector<std::string> comments_of(const RockStamp& stamp);

/// The stamp of a file; nothing where it is no PLY or has not all of the comments.
std::optional<RockStamp> read_stamp(const std::filesystem::path& file);

/// Throws InputError, naming time.first_step, when the run goes on from a rock of another time of the motion than that
/// after its first steps. A rock without a stamp, and a motion that begins anew, are not asked.
void require_same_time(const Case& c);

}  // namespace tdbd::simulation
