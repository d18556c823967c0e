#include "io/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <regex>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "core/config/config.hpp"
#include "core/error.hpp"

namespace tdbd {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& reason) {
  throw FolderError(fmt::format("output folder {}: {}", path.string(), reason));
}

/// Names of files that a command may write to its folder, except frames and parts. The file that
/// each command writes first, which identifies its folder, is removed last.
constexpr std::array<std::string_view, 24> result_names = {
    "summary.json",    "timing.json",        "history.nc",
    "history.csv",     "checkpoint.bin",     "rock.pvd",
    "bit.pvd",         "bit.json",           "bit_poses.csv",
    "bit.glb",         "rock_final.ply",     "failure.txt",
    "history.rows",    "checkpoint-new.bin", "checkpoint-previous.bin",
    "convergence.svg", "convergence.csv",    "string.nc",
    "string.rows",     "static.csv",         "modes.csv",
    "broomstick.csv",  "case.toml",          "convergence.json"};
constexpr std::array<std::string_view, 15> bit_names = {
    "bit.json",       "cutters.csv",    "profile.csv",    "analysis.json", "bit.vtp",
    "bit.stl",        "bit.obj",        "bit.ply",        "bit.off",       "bit-united.stl",
    "bit-united.obj", "bit-united.ply", "bit-united.off", "solids.toml",   "bit.toml"};

std::span<const std::string_view> names_of(ResultKind kind) {
  if (kind == ResultKind::bit) return bit_names;
  return result_names;
}

/// Files that a run writes to `frames`: "rock-000123.vtp", "bit_final.vtp".
bool is_frame(const fs::path& file) {
  static const std::regex name(R"((rock|bit)(-[0-9]{6,}|_final)\.vtp(\.partial)?)");
  return std::regex_match(file.filename().string(), name);
}

bool is_there(const fs::path& file) { return fs::exists(fs::symlink_status(file)); }

/// Returns the existing files of an older result, without files that TDBD did not write.
std::vector<fs::path> old_results(const OutputFolder& folder, ResultKind kind) {
  std::vector<fs::path> old;
  for (const std::string_view name : names_of(kind))
    for (const char* suffix : {".partial", ""})
      if (const fs::path file = folder.path / fmt::format("{}{}", name, suffix); is_there(file))
        old.push_back(file);
  if (kind == ResultKind::bit || !fs::is_directory(folder.frames())) return old;
  for (const auto& entry : fs::directory_iterator(folder.frames()))
    if (is_frame(entry.path())) old.push_back(entry.path());
  return old;
}

/// Whether a file begins like one that TDBD writes: a resolved case, or a bit of either kind.
bool is_own(const fs::path& file) {
  if (!fs::is_regular_file(file)) return false;
  std::ifstream in(file);
  std::string line;
  std::getline(in, line);
  return line == resolved_head || line.starts_with("# A bit as the meshes of its parts.") ||
         line.starts_with("# A roller cone bit as built, in SI");
}

/// The file that a command writes first identifies its folder.
void demand_own_folder(const OutputFolder& folder, ResultKind kind,
                       const std::vector<fs::path>& old) {
  const char* first = kind == ResultKind::bit ? "bit.toml" : "case.toml";
  demand_own(folder.path, first);
  if (is_there(folder.path / first)) return;
  if (kind != ResultKind::bit && is_there(folder.path / "convergence.json")) return;
  for (const fs::path& file : old)
    if (file.filename() != "failure.txt" && file.extension() != ".partial")
      refuse(folder.path, fmt::format("holds {}, and no {} of TDBD beside it; take another folder",
                                      file.filename().string(), first));
}

/// The meshes of an older export, or of a bit that is an input.
std::vector<fs::path> parts_in(const OutputFolder& folder) {
  std::vector<fs::path> parts;
  if (!fs::is_directory(folder.path / "parts")) return parts;
  for (const auto& entry : fs::recursive_directory_iterator(folder.path / "parts"))
    if (!entry.is_directory()) parts.push_back(entry.path());
  return parts;
}

/// Returns the files of an older result that may be removed.
std::vector<fs::path> replaceable(const OutputFolder& folder, ResultKind kind,
                                  const std::vector<std::string>& inputs) {
  std::vector<fs::path> old = old_results(folder, kind);
  demand_replaceable(folder.path, old, inputs);
  if (kind == ResultKind::bit) demand_replaceable(folder.path, parts_in(folder), inputs);
  demand_own_folder(folder, kind, old);
  return old;
}

void demand_writable(const OutputFolder& folder, ResultKind kind) {
  const fs::path frames = folder.frames();
  const bool has_frames = kind == ResultKind::run && fs::exists(frames);
  if (has_frames && !fs::is_directory(frames)) refuse(folder.path, "its frames is a file");
  for (const fs::path& written : {folder.path, has_frames ? frames : folder.path})
    if (access(written.c_str(), W_OK) != 0) refuse(folder.path, "not writable");
}

/// Returns the text of a key in every [[table]] of a file; nothing if it cannot be read.
std::vector<std::string> texts_of(const fs::path& file, const char* table, const char* key) {
  std::vector<std::string> texts;
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return texts;
  try {
    Config c = Config::read_file(file.string(), {});
    for (Config& entry : c.tables(table))
      if (entry.is_text(key)) texts.push_back(entry.text(key, {}));
  } catch (const InputError&) {
    return {};
  }
  return texts;
}

/// Whether the path is inside parts/.
bool is_in_parts(const fs::path& name) {
  const fs::path plain = name.lexically_normal();
  return plain.is_relative() && !plain.empty() && *plain.begin() == "parts";
}

bool is_file(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(file, ignored));
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder)
    : folder_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (folder_ < 0)
    throw RunError(
        fmt::format("output folder {}: cannot open: {}", folder.string(), std::strerror(errno)));
  if (flock(folder_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) return;
  close(folder_);
  throw FolderError(
      fmt::format("output folder {}: in use: another command writes to it; wait until it ends "
                  "or choose another folder",
                  folder.string()));
}

FolderLock::~FolderLock() { close(folder_); }

MadeFolders::MadeFolders(const fs::path& folder) {
  for (fs::path p = fs::absolute(folder); !p.empty() && !fs::exists(p); p = p.parent_path())
    made_.push_back(p);
  fs::create_directories(folder);
}

MadeFolders::~MadeFolders() {
  std::error_code not_empty;
  for (const fs::path& folder : made_) fs::remove(folder, not_empty);
}

fs::path OutputFolder::frame(const std::string& name, long number) const {
  return frames() / fmt::format("{}-{:06}.vtp", name, number);
}

void demand_replaceable(const fs::path& folder, const std::vector<fs::path>& files,
                        const std::vector<std::string>& inputs) {
  for (const fs::path& file : files) {
    if (fs::is_directory(file)) refuse(folder, file.filename().string() + " is a folder");
    for (const std::string& input : inputs)
      if (std::error_code ignored; fs::equivalent(file, input, ignored))
        refuse(folder, "holds the input " + input + "; take another folder");
  }
}

void demand_own(const fs::path& folder, const std::string& name) {
  if (is_there(folder / name) && !is_own(folder / name))
    refuse(folder, fmt::format("its {} is not one that TDBD wrote; take another folder", name));
}

OutputFolder claim(const fs::path& path, Overwrite overwrite,
                   const std::vector<std::string>& inputs, ResultKind kind) {
  OutputFolder folder{path};
  try {
    if (fs::exists(path) && !fs::is_directory(path)) refuse(path, "is a file");
    folder.made = std::make_shared<const MadeFolders>(path);
    folder.lock = std::make_shared<const FolderLock>(path);
    if (!fs::is_empty(path)) {
      if (overwrite == Overwrite::no) refuse(path, "exists; --force overwrites");
      replaceable(folder, kind, inputs);
    }
    demand_writable(folder, kind);
  } catch (const fs::filesystem_error& e) {
    refuse(path, e.code().message());
  }
  return folder;
}

void clear(const OutputFolder& folder, const std::vector<std::string>& inputs, ResultKind kind) {
  try {
    const std::vector<fs::path> old = replaceable(folder, kind, inputs);
    if (kind == ResultKind::bit) remove_parts(folder.path, exported_parts(folder.path));
    for (const fs::path& file : old) fs::remove(file);
    if (kind == ResultKind::run) fs::create_directories(folder.frames());
  } catch (const fs::filesystem_error& e) {
    refuse(folder.path, e.code().message());
  }
}

OutputFolder prepare(const fs::path& path, Overwrite overwrite,
                     const std::vector<std::string>& inputs, ResultKind kind) {
  OutputFolder folder = claim(path, overwrite, inputs, kind);
  clear(folder, inputs, kind);
  return folder;
}

void forget_end(const OutputFolder& folder) {
  for (const fs::path& file : {folder.summary(), folder.timing(), folder.failure()}) {
    std::error_code error;
    fs::remove(file, error);
    if (error) throw RunError(fmt::format("cannot remove {}: {}", file.string(), error.message()));
  }
}

std::vector<fs::path> exported_parts(const fs::path& folder) {
  std::vector<fs::path> found;
  for (const std::string& name : texts_of(folder / "bit.toml", "parts", "file"))
    if (is_in_parts(name) && is_file(folder / name)) found.push_back(folder / name);
  if (!found.empty()) return found;
  const std::vector<std::string> names = texts_of(folder / "solids.toml", "solids.rules", "name");
  for (const char* format : {".ply", ".off", ".obj", ".stl"}) {
    std::vector<fs::path> files;
    for (const std::string& name : names)
      if (is_in_parts("parts/" + name)) files.push_back(folder / "parts" / (name + format));
    if (std::ranges::all_of(files, is_file)) found.insert(found.end(), files.begin(), files.end());
  }
  return found;
}

void remove_parts(const fs::path& folder, const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    fs::remove(file);
    std::error_code not_empty;  // not an error: the folder stays
    for (fs::path around = file.parent_path(); around != folder && fs::remove(around, not_empty);)
      around = around.parent_path();
  }
}

}  // namespace tdbd
