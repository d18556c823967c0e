#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "app/arguments.hpp"
#include "app/commands.hpp"
#include "app/print.hpp"
#include "app/templates.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "io/whole_file.hpp"

namespace tdbd::app {
namespace {

namespace fs = std::filesystem;

struct NewArguments {
  std::string kind, folder;
};

std::vector<std::string> kinds() {
  std::vector<std::string> names;
  for (const TemplateFile& f : template_files())
    if (names.empty() || names.back() != f.kind) names.emplace_back(f.kind);
  return names;
}

std::vector<TemplateFile> files_of(const std::string& kind) {
  std::vector<TemplateFile> files;
  std::ranges::copy_if(template_files(), std::back_inserter(files),
                       [&](const TemplateFile& f) { return f.kind == kind; });
  if (!files.empty()) return files;
  const auto meant = nearest_name(kind, kinds());
  throw InputError(
      fmt::format("KIND: found {}, expected {}", kind,
                  meant ? *meant : fmt::format("one of {}", fmt::join(kinds(), ", "))));
}

/// Checks that the folder is new or empty, so that no existing file is changed.
void require_new(const fs::path& folder) {
  if (fs::exists(fs::symlink_status(folder)) && !(fs::is_directory(folder) && fs::is_empty(folder)))
    throw InputError(
        fmt::format("NAME: found {}, which exists, expected a new folder", folder.string()));
}

int write_new(const NewArguments& a) {
  const std::vector<TemplateFile> files = files_of(a.kind);
  const fs::path folder = a.folder;
  require_new(folder);
  for (const TemplateFile& f : files) {
    fs::create_directories((folder / f.path).parent_path());
    write_text(folder / f.path, f.text);
    say("{}\n", (folder / f.path).string());
  }
  const std::string first = (folder / files.front().path).string();
  const std::string output = (folder / "result").string();
  say("to run it: tdbd {} {} -o {}{}\nevery key: tdbd keys\n", files.front().command, first, output,
      a.kind == "sweep" ? ".nc" : "");
  return 0;
}

}  // namespace

void add_new(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("new", "Write an example case with all its files");
  auto a = std::make_shared<NewArguments>();
  command->add_option("kind", a->kind, "kind of example")
      ->required()
      ->type_name(fmt::format("{{{}}}", fmt::join(kinds(), ",")));
  command->add_option("name", a->folder, "name of the new folder")->required()->type_name(a_folder);
  command->footer(
      "pdc: a PDC bit drills; cones: a roller cone bit drills; top: a heavy top; sweep: a design "
      "of\n"
      "many cases; calibration: measured readings and a law to fit. All files are in the new "
      "folder.\n"
      "Example: tdbd new pdc first");
  command->callback([a, &exit_code] { exit_code = guarded([&] { return write_new(*a); }); });
}

}  // namespace tdbd::app
