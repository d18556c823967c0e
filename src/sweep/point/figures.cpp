#include "sweep/point/figures.hpp"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.hpp"
#include "core/nearest_name.hpp"

namespace tdbd::sweep {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<std::pair<std::string, double>>;

void collect(const Json& value, const std::string& name, Numbers& numbers) {
  const std::string before = name.empty() ? "" : name + ".";
  if (value.is_object()) {
    for (const auto& [key, child] : value.items()) collect(child, before + key, numbers);
  } else if (value.is_array()) {
    for (std::size_t i = 0; i < value.size(); ++i)
      collect(value[i], fmt::format("{}{}", before, i), numbers);
  } else if (value.is_number()) {
    numbers.emplace_back(name, value.get<double>());
  } else if (value.is_boolean()) {
    numbers.emplace_back(name, value.get<bool>() ? 1.0 : 0.0);
  } else if (value.is_null()) {
    numbers.emplace_back(name, std::numeric_limits<double>::quiet_NaN());
  }
}

Numbers numbers_of(const Json& summary) {
  Numbers numbers;
  collect(summary, "", numbers);
  return numbers;
}

}  // namespace

std::vector<std::string> figure_names(const Json& summary) {
  std::vector<std::string> names;
  for (const auto& [name, number] : numbers_of(summary)) names.push_back(name);
  return names;
}

std::vector<double> figures_of(const Json& summary, const std::vector<std::string>& names) {
  std::map<std::string, double> numbers;
  for (const auto& [name, number] : numbers_of(summary)) numbers.emplace(name, number);
  std::vector<double> figures;
  std::string missing;
  for (const std::string& name : names) {
    const auto found = numbers.find(name);
    if (found != numbers.end()) {
      figures.push_back(found->second);
      continue;
    }
    const auto nearest = nearest_name(name, figure_names(summary));
    missing +=
        fmt::format("{}sweep.figures: found {}, expected a number of the summary{}",
                    missing.empty() ? "" : "\n", name, nearest ? ", such as " + *nearest : "");
  }
  if (!missing.empty()) throw InputError(missing);
  return figures;
}

}  // namespace tdbd::sweep
