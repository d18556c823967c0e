#pragma once

#include <nlohmann/json.hpp>

#include "simulation/result/summary.hpp"

namespace tdbd::simulation {

/// Grows when a key of a summary changes its meaning or goes away.
inline constexpr int summary_schema = 1;

/// What every summary starts with: schema, command, title, status, provenance.
nlohmann::ordered_json summary_head(const std::string& command, const std::string& title,
                                    RunStatus status, const std::string& case_hash,
                                    std::uint64_t seed);

}  // namespace tdbd::simulation
