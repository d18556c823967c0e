#include "calibration/result/calibration_files.hpp"

#include <fmt/format.h>

#include <regex>

#include "core/error.hpp"
#include "core/whole_file.hpp"

namespace tdbd::calibration {
namespace {

namespace fs = std::filesystem;

/// What a calibration leaves in its folder.
bool is_result(const fs::path& file) {
  static const std::regex names(
      R"((calibration\.json|law(-[0-9.]+MPa)?\.toml|residuals\.csv|predictions\.csv|case\.toml|timing\.json|cuts-[0-9a-f]{16}\.nc)(\.partial)?)");
  return std::regex_match(file.filename().string(), names);
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& reason) {
  throw FolderError(fmt::format("output folder {}: {}", folder.string(), reason));
}

std::string law_file(const FittedSet& set) {
  if (!set.pressure) return "law.toml";
  constexpr double Pa_to_MPa = 1e-6;
  return fmt::format("law-{:.3f}MPa.toml", Pa_to_MPa * *set.pressure);
}

std::string number(const std::optional<double>& value) {
  return value ? fmt::format("{}", *value) : "";
}

std::string header(ToolKind kind) {
  const auto names = load_names(kind);
  std::string text = kind == ToolKind::bit ? "test,bit,rock,pressure [Pa],rotary_speed [rad/s],"
                                             "rate_of_penetration [m/s]"
                                           : "test,cutter,rock,pressure [Pa],speed [m/s],depth [m]";
  for (const LoadName& n : names) text += fmt::format(",{} [{}]", n.name, n.si_unit);
  for (const LoadName& n : names)
    for (const char* what : {"mean", "se", "low", "high"})
      text += fmt::format(",{}_{} [{}]", n.name, what, n.si_unit);
  for (const LoadName& n : names) text += fmt::format(",measured_{} [{}]", n.name, n.si_unit);
  return text + "\n";
}

std::string row(ToolKind kind, const Prediction& p) {
  const Record& r = p.record;
  std::string text = fmt::format("{},{},{},{},{},{}", r.test, r.tool, r.rock, r.pressure, r.speed,
                                 kind == ToolKind::bit ? r.rate : r.depth);
  for (const Reading& reading : r.readings) text += "," + number(reading.value);
  for (const PredictedLoad& load : p.loads)
    text += fmt::format(",{},{},{},{}", load.mean, load.se, load.low, load.high);
  for (const Reading& reading : r.readings) text += "," + number(reading.value);
  return text + "\n";
}

}  // namespace

void check_folder(const fs::path& folder, simulation::Overwrite overwrite) {
  std::error_code error;
  if (!fs::exists(folder, error)) return;
  if (!fs::is_directory(folder, error)) refuse(folder, "is a file");
  const bool empty = fs::is_empty(folder, error);
  if (error) refuse(folder, error.message());
  if (!empty && overwrite == simulation::Overwrite::no)
    refuse(folder, "exists; --force overwrites");
}

simulation::OutputFolder prepare_folder(const fs::path& folder, simulation::Overwrite overwrite,
                                        const std::vector<std::string>& inputs) {
  check_folder(folder, overwrite);
  try {
    fs::create_directories(folder);
    simulation::OutputFolder held{folder, std::make_shared<const FolderLock>(folder)};
    std::vector<fs::path> old;
    for (const auto& entry : fs::directory_iterator(folder))
      if (is_result(entry.path())) old.push_back(entry.path());
    simulation::demand_replaceable(folder, old, inputs);
    simulation::demand_own(folder, "case.toml");
    for (const fs::path& file : old) fs::remove(file);
    return held;
  } catch (const fs::filesystem_error& e) {
    refuse(folder, e.code().message());
  }
}

std::string law_toml(const forces::Law& law) {
  forces::Law copy = law;
  std::string text = fmt::format("[forces]\nlaw = \"{}\"\n", forces::law_name(law));
  for (const forces::LawField& f : forces::law_fields(copy))
    if (std::isfinite(*f.value))
      text += fmt::format("{} = {}{}\n", f.key, *f.value,
                          f.unit == "1" ? "" : fmt::format("  # {}", f.unit));
  return text;
}

std::string predictions_csv(ToolKind kind, const std::vector<Prediction>& predictions) {
  std::string text = header(kind);
  for (const Prediction& p : predictions) text += row(kind, p);
  return text;
}

void write_calibration(const fs::path& folder, const CalibrationCase& c, const CutStore& cuts,
                       const Calibration& found) {
  write_text(folder / "case.toml", std::string(simulation::resolved_head) + "\n" + c.resolved);
  for (const fs::path& file : cuts.files)
    fs::copy_file(file, folder / file.filename(), fs::copy_options::overwrite_existing);
  for (const FittedSet& set : found.sets)
    write_text(
        folder / law_file(set),
        law_toml(set.fit.law) + areas_toml(areas_at(set.fit.problem, set.fit.values), set.fit.law));
  write_text(folder / "residuals.csv", predictions_csv(c.records.kind, found.fitted));
  write_text(folder / "predictions.csv", predictions_csv(c.records.kind, found.predictions));
  write_text(folder / "calibration.json", to_json(c, found));
}

}  // namespace tdbd::calibration
