#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace tdbd::sweep {

/// The numbers of a summary under these dotted names ("wob_mean_n", "sections.0.mean_area_m2"); true
/// and false count as 1 and 0, null as NaN. Throws InputError that lists the names that stand for no
/// number, each with the nearest that does.
std::vector<double> figures_of(const nlohmann::ordered_json& summary,
                               const std::vector<std::string>& names);

/// All names that stand for a number, in the summary's order.
std::vector<std::string> figure_names(const nlohmann::ordered_json& summary);

}  // namespace tdbd::sweep
