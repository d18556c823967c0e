#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/read_file.hpp"
#include "simulation/case/run_settings.hpp"

namespace tdbd::simulation {
namespace {

using Json = nlohmann::json;

constexpr double same_size = 1e-9;  ///< relative: the size of a level was divided and printed

Figures summarize(const Json& state) {
  Figures figures;
  for (const StudiedFigure& f : studied_figures)
    if (const auto found = state.find(f.in_study); found != state.end() && found->size() == 1)
      figures[f.in_summary] = found->at(0).get<double>();
  return figures;
}

StudiedConvergence study_of(const Json& json) {
  StudiedConvergence study;
  study.keys = json.at("keys").get<std::vector<std::string>>();
  for (const Json& level : json.at("levels")) {
    study.levels.push_back(
        {level.at("sizes").get<std::vector<double>>(), summarize(level.at("state"))});
    if (study.levels.back().sizes.size() != study.keys.size())
      throw InputError(
          fmt::format("{} sizes for {} keys", study.levels.back().sizes.size(), study.keys.size()));
  }
  if (study.keys.empty() || study.levels.empty()) throw InputError("no key or no level");
  for (const StudiedFigure& f : studied_figures) {
    const auto found = json.at("variables").find(f.in_study);
    if (found == json.at("variables").end() || found->at("uncertainty").is_null()) continue;
    study.left[f.in_summary] = found->at("uncertainty").at("value").get<double>();
  }
  return study;
}

std::vector<double> sizes_of(const StudiedConvergence& study,
                             const std::map<std::string, double>& quantities) {
  std::vector<double> sizes;
  for (const std::string& key : study.keys) {
    const auto found = quantities.find(key);
    sizes.push_back(found != quantities.end() ? found->second : NAN);
  }
  return sizes;
}

/// Returns the level with these sizes, or null.
const StudiedConvergence::Level* level_of(const StudiedConvergence& study,
                                          const std::vector<double>& sizes) {
  const auto equal = [](double a, double b) { return std::abs(a - b) <= same_size * std::abs(b); };
  const auto found =
      std::ranges::find_if(study.levels, [&](const StudiedConvergence::Level& level) {
        return std::ranges::equal(level.sizes, sizes, equal);
      });
  return found != study.levels.end() ? &*found : nullptr;
}

}  // namespace

std::vector<StudiedConvergence> read_studied_convergence(const std::string& file) {
  const std::string text = read_file(file, "a convergence.json");
  try {
    const Json json = Json::parse(text);
    std::vector<StudiedConvergence> studies;
    for (const Json& one : json.is_array() ? json : Json::array({json}))
      studies.push_back(study_of(one));
    return studies;
  } catch (const std::exception& e) {
    throw InputError(fmt::format(
        "{}: found {}, expected a convergence.json, or a list of such objects", file, e.what()));
  }
}

NumericalUncertainty numerical_uncertainty(const StudiedConvergence& study,
                                           const std::map<std::string, double>& quantities,
                                           const Figures& figures) {
  NumericalUncertainty found{study.keys, {}, {}};
  const std::vector<double> sizes = sizes_of(study, quantities);
  const StudiedConvergence::Level* own = level_of(study, sizes);
  if (own == nullptr) {
    found.reason = fmt::format("no level of the study has {} = {}", fmt::join(study.keys, ", "),
                               fmt::join(sizes, ", "));
    return found;
  }
  const Figures& finest = study.levels.back().figures;
  for (const StudiedFigure& f : studied_figures) {
    const std::string name = f.in_summary;
    if (!study.left.contains(name) || !figures.contains(name) || !own->figures.contains(name) ||
        !finest.contains(name))
      continue;
    const double x = figures.at(name), at_level = own->figures.at(name);
    const double limit = finest.at(name), left = study.left.at(name);
    if (f.kind == FigureKind::mean &&
        !(std::abs(x - at_level) <= std::abs(at_level - limit) + left)) {
      found.figures.clear();
      found.reason =
          fmt::format("the study is of another case: its level has {} = {:.6g}, the run {:.6g}",
                      name, at_level, x);
      return found;
    }
    found.figures[name] = std::abs(x - limit) + left;
  }
  if (found.figures.empty()) found.reason = "the study has none of these figures";
  return found;
}

}  // namespace tdbd::simulation
