#include "simulation/result/run_loop.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "core/config/config.hpp"
#include "core/error.hpp"
#include "simulation/case/rotate_settings.hpp"

namespace tdbd::simulation {
namespace {

namespace fs = std::filesystem;

std::string command_name(Stopped command) { return command == Stopped::run ? "run" : "rotate"; }

}  // namespace

fs::path stopped_case(const fs::path& folder, Stopped command) {
  const fs::path file = folder / "case.toml";
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) || line != resolved_head)
    throw InputError(
        fmt::format("{}: found no case.toml of a run, expected the folder of a run that "
                    "was stopped",
                    folder.string()));
  const bool rotates = Config::read_file(file.string(), {}).has(BodySettings::table);
  if (const Stopped found = rotates ? Stopped::rotate : Stopped::run; found != command)
    throw InputError(fmt::format(
        "{}: found a run of tdbd {}, expected one of tdbd {}; to resume it: tdbd {} --resume {}",
        folder.string(), command_name(found), command_name(command), command_name(found),
        folder.string()));
  return file;
}

bool tidy_if_finished(const fs::path& folder) {
  std::ifstream in(folder / "summary.json");
  const auto summary = nlohmann::json::parse(in, nullptr, false);
  const bool is_finished = summary.is_object() && summary.value("status", "") == "completed";
  if (is_finished) remove_checkpoints({folder});
  return is_finished;
}

}  // namespace tdbd::simulation
