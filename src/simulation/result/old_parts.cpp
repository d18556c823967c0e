#include "simulation/result/old_parts.hpp"

#include <algorithm>
#include <string>
#include <system_error>

#include "core/config/config.hpp"
#include "core/error.hpp"

namespace tdbd::simulation {
namespace {

namespace fs = std::filesystem;

/// The text of a key in every [[table]] of a file; nothing where it cannot be read.
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

/// Below parts/ and nowhere else.
bool is_in_parts(const fs::path& name) {
  const fs::path plain = name.lexically_normal();
  return plain.is_relative() && !plain.empty() && *plain.begin() == "parts";
}

bool is_file(const fs::path& file) {
  std::error_code ignored;
  return fs::is_regular_file(fs::symlink_status(file, ignored));
}

}  // namespace

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
    std::error_code not_empty;  // then it stays
    for (fs::path around = file.parent_path(); around != folder && fs::remove(around, not_empty);)
      around = around.parent_path();
  }
}

}  // namespace tdbd::simulation
