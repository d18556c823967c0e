#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "battery/evidence.hpp"
#include "bit/files/bit_file.hpp"

namespace tdbd::claims {

/// One of cases/bits.
inline bit::Bit example(const std::string& name) {
  return bit::read_bit(TDBD_SOURCE_DIR "/cases/bits/" + name + ".toml", bit::DirectionRule::hybrid,
                       bit::InsideRule::down)
      .bit;
}

/// The bits with cutters whose tips all stand on the profile.
inline std::vector<bit::Bit> fixed_cutter_bits() {
  return {example("bit-a"), example("bit-b"), example("bit-c")};
}

/// The end of a limit: empty, or the reason why it is more than three times the measured value.
inline std::string because(const std::string& wide) {
  return wide.empty() ? "" : "; wide: " + wide;
}

/// Checks and records that a number is at most `limit`; `wide`: why that is far above it.
inline void record_bound(const std::string& claim, const std::string& what, double measured,
                         const std::string& unit, double limit, const std::string& wide = "") {
  EXPECT_LE(measured, limit) << what;
  battery::record({claim, what, measured, unit, fmt::format("<= {:g}{}", limit, because(wide)),
                   measured <= limit ? battery::Verdict::holds : battery::Verdict::refuted});
}

/// Checks and records that a number is within `room` of `expected`.
inline void record_near(const std::string& claim, const std::string& what, double measured,
                        double expected, double room, const std::string& wide = "") {
  EXPECT_NEAR(measured, expected, room) << what;
  battery::record({claim, what, measured, "1",
                   fmt::format("{} +- {:g}{}", expected, room, because(wide)),
                   std::abs(measured - expected) <= room ? battery::Verdict::holds
                                                         : battery::Verdict::refuted});
}

}  // namespace tdbd::claims
