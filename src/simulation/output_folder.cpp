#include "simulation/output_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>
#include <vector>

#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw InputError(fmt::format("output folder {}: {}", path.string(), reason));
}

/// Names that a run leaves in its folder, besides the frames.
constexpr const char* result_names[] = {
    "summary.json", "timing.json",   "history.nc", "history.csv", "history.nc.partial",
    "case.toml",    "checkpoint.nc", "rock.pvd",   "bit.pvd",     "rock_final.ply",
    "bit.json"};

/// Removes results of an older run, and nothing that TDBD did not write.
void remove_results(const OutputFolder& folder) {
  for (const char* name : result_names) fs::remove(folder.path / name);
  if (!fs::is_directory(folder.frames())) return;
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(folder.frames()))
    if (entry.path().extension() == ".vtp") old.push_back(entry.path());
  for (const fs::path& file : old) fs::remove(file);
}

}  // namespace

fs::path OutputFolder::frame(const std::string& name, long number) const {
  return frames() / fmt::format("{}-{:06}.vtp", name, number);
}

OutputFolder prepare(const fs::path& path, Overwrite overwrite) {
  const OutputFolder folder{path};
  try {
    if (fs::exists(path) && !fs::is_directory(path)) refuse(path, "is a file");
    if (fs::exists(path) && !fs::is_empty(path)) {
      if (overwrite == Overwrite::no) refuse(path, "exists; --force overwrites");
      remove_results(folder);
    }
    fs::create_directories(folder.frames());
  } catch (const fs::filesystem_error& e) {
    refuse(path, e.code().message());
  }
  if (access(folder.frames().c_str(), W_OK) != 0 || access(path.c_str(), W_OK) != 0)
    refuse(path, "not writable");
  return folder;
}

}  // namespace tdbd::simulation
