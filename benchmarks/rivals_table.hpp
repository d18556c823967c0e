#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "benchmarks/turns.hpp"

namespace tdbd::bench {

/// Warm: turns so long that each side works in its own caches. Cold: shorter ones, each of which
/// finds the caches emptied by the others.
struct Condition {
  std::string name;
  long steps, turns;
};

/// All figures of a condition, those of the meshes as they are now, and their ratios to the
/// yardstick's. Times in us, counts in millions; null where nothing was counted.
nlohmann::ordered_json condition_told(const Condition& condition,
                                      const std::vector<Contender>& sides,
                                      const std::vector<Figures>& figures);

/// The same as lines for a reader.
std::string condition_text(const nlohmann::ordered_json& condition);

}  // namespace tdbd::bench
