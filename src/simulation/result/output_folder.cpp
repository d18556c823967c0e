#include "simulation/result/output_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>
#include <regex>
#include <string_view>
#include <system_error>

#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw InputError(fmt::format("output folder {}: {}", path.string(), reason));
}

/// Names that a run leaves in its folder, besides the frames.
constexpr std::string_view result_names[] = {"summary.json",
                                             "timing.json",
                                             "history.nc",
                                             "history.csv",
                                             "case.toml",
                                             "checkpoint.nc",
                                             "rock.pvd",
                                             "bit.pvd",
                                             "rock_final.ply",
                                             "bit.json",
                                             "bit.stl",
                                             "bit.vtp",
                                             "failure.txt",
                                             "convergence.json",
                                             "convergence.csv",
                                             "convergence.svg",
                                             "history.rows",
                                             "checkpoint-new.nc",
                                             "checkpoint-previous.nc"};

/// "rock-000123.vtp", "bit_final.vtp": what a run writes into frames.
bool is_frame(const fs::path& file) {
  static const std::regex name(R"((rock|bit)(-[0-9]{6,}|_final)\.vtp(\.partial)?)");
  return std::regex_match(file.filename().string(), name);
}

/// What is there of an older run, and nothing that TDBD did not write.
std::vector<fs::path> old_results(const OutputFolder& folder) {
  std::vector<fs::path> old;
  for (const std::string_view name : result_names)
    for (const char* suffix : {"", ".partial"})
      if (const fs::path file = folder.path / fmt::format("{}{}", name, suffix);
          fs::exists(fs::symlink_status(file)))
        old.push_back(file);
  if (!fs::is_directory(folder.frames())) return old;
  for (const auto& entry : fs::directory_iterator(folder.frames()))
    if (is_frame(entry.path())) old.push_back(entry.path());
  return old;
}

/// A case.toml without the first line of a resolved case is somebody's own.
void demand_own_case(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  if (fs::exists(file) && (!std::getline(in, line) || line != resolved_head))
    refuse(file.parent_path(), "its case.toml is not one that TDBD wrote; take another folder");
}

void remove_results(const OutputFolder& folder, const std::vector<std::string>& inputs) {
  demand_own_case(folder.path / "case.toml");
  const std::vector<fs::path> old = old_results(folder);
  for (const fs::path& file : old) {
    if (fs::is_directory(file)) refuse(folder.path, file.filename().string() + " is a folder");
    for (const std::string& input : inputs)
      if (std::error_code ignored; fs::equivalent(file, input, ignored))
        refuse(folder.path, "holds the input " + input + "; take another folder");
  }
  for (const fs::path& file : old) fs::remove(file);
}

}  // namespace

fs::path OutputFolder::frame(const std::string& name, long number) const {
  return frames() / fmt::format("{}-{:06}.vtp", name, number);
}

OutputFolder prepare(const fs::path& path, Overwrite overwrite,
                     const std::vector<std::string>& inputs, HasFrames frames) {
  const OutputFolder folder{path};
  try {
    if (fs::exists(path) && !fs::is_directory(path)) refuse(path, "is a file");
    if (fs::exists(path) && !fs::is_empty(path)) {
      if (overwrite == Overwrite::no) refuse(path, "exists; --force overwrites");
      remove_results(folder, inputs);
    }
    if (fs::exists(folder.frames()) && !fs::is_directory(folder.frames()))
      refuse(path, "its frames is a file");
    fs::create_directories(frames == HasFrames::yes ? folder.frames() : path);
  } catch (const fs::filesystem_error& e) {
    refuse(path, e.code().message());
  }
  const bool frames_closed = frames == HasFrames::yes && access(folder.frames().c_str(), W_OK) != 0;
  if (frames_closed || access(path.c_str(), W_OK) != 0) refuse(path, "not writable");
  return folder;
}

}  // namespace tdbd::simulation
