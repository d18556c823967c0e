#pragma once

#include <limits>

#include "core/config/config.hpp"
#include "dynamics/schedule.hpp"
#include "string/top.hpp"

namespace tdbd::simulation {

/// What the log of a rig gives the top of a string, linear between its rows; empty where the log does not
/// have it. Times are those of the run.
struct RigLog {
  dynamics::Schedule rotary_speed;                       ///< rad/s
  dynamics::Schedule block_speed;                        ///< m/s, downward
  dynamics::Schedule hook_load;                          ///< N
  double end = std::numeric_limits<double>::infinity();  ///< of its last row, s
};

/// Whether the log gives this.
inline bool is_given(const dynamics::Schedule& s) { return !s.times.empty(); }

/// Reads [string.top.log] and its file; without that table all is empty. Notes mistakes in the file.
RigLog read_rig_log(Config& whole);

/// Notes a mistake where the log ends before the run of this duration (s).
void check_rig_log(Config& whole, const RigLog& log, double duration);

/// Notes a mistake where the table has a quantity that the log gives.
void refuse_logged(Config& table, const QuantityKey& key, const dynamics::Schedule& logged);

/// What the top does over the step of h (s) at t: the turn of the set point, the way of the block, and the
/// mean hook load, from the log or else at these constant values.
string::TopCommand command_of(const RigLog& log, const string::TopCommand& usual, double t,
                              double h);

}  // namespace tdbd::simulation
