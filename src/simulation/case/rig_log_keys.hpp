#pragma once

#include "core/config/key.hpp"

/// The keys of the log of a rig (rig_log.hpp).
namespace tdbd::simulation {

namespace rig_log_keys {

inline constexpr TableKey table{
    "string.top.log", "the record of a rig as the motion of the top, linear between its rows"};

inline constexpr PathKey file{
    .name = "file",
    .meaning = "LAS 2.0 (NAME.las), or CSV under a header of names with units: \"RPM [rpm]\""};
inline constexpr TextKey time{.name = "time",
                              .fallback = "time",
                              .meaning = "the column of times; \"TIME [s]\" gives a unit too"};
/// A column that the log may have.
constexpr TextKey column(std::string_view name, std::string_view meaning) {
  return {.name = name, .usual = "none", .meaning = meaning};
}
inline constexpr TextKey rotary_speed =
    column("rotary_speed", "the column that replaces motion.rotary_speed");
inline constexpr TextKey block_speed =
    column("block_speed", "the column that replaces motion.rate_of_penetration; downward");
inline constexpr TextKey hook_load =
    column("hook_load", "the column that replaces string.top.hook_load (axial = hook-load)");
inline constexpr QuantityKey start{.name = "start",
                                   .unit = "s",
                                   .usual = "that of the first row",
                                   .meaning = "time of the log at which the run starts"};

}  // namespace rig_log_keys

}  // namespace tdbd::simulation
