#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "benchmarks/turns.hpp"

namespace tdbd::bench {

/// Warm: turns so long that each side works in its own caches. Cold: shorter turns, in each of
/// which the caches contain data of the other sides.
struct Condition {
  std::string name;
  long steps, turns;
};

/// All values of a condition, those of the present meshes, and their ratios to those of the height field.
/// Times in us, counts in millions; null where there was no counter.
nlohmann::ordered_json condition_json(const Condition& condition,
                                      const std::vector<Contender>& sides,
                                      const std::vector<Figures>& figures);

/// The same as text.
std::string condition_text(const nlohmann::ordered_json& condition);

}  // namespace tdbd::bench
