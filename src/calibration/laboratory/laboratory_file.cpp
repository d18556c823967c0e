#include "calibration/laboratory/laboratory_file.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "io/whole_file.hpp"

namespace tdbd::calibration {
namespace {

namespace fs = std::filesystem;

/// Throws if the file must not be written: it is an input, or it exists and may not be overwritten.
void demand_free(const fs::path& file, const LaboratoryOptions& o,
                 const std::vector<std::string>& inputs) {
  if (!fs::exists(file)) return;
  for (const std::string& input : inputs)
    if (fs::equivalent(file, input))
      throw InputError(file.string() + ": found an input itself, expected another file to write");
  if (o.overwrite == Overwrite::no)
    throw FolderError(fmt::format("{}: exists; --force overwrites", file.string()));
}

}  // namespace

void write_records(const LaboratoryCase& c, const LaboratoryOptions& o) {
  const ThreadLimit limit(o.threads);
  const fs::path file = fs::absolute(o.file).lexically_normal();
  demand_free(file, o, c.setup.files);
  const fs::path cuts = o.cuts.empty() ? file.parent_path() / "cuts" : o.cuts;
  const CutStore store = find_cuts(c.setup, cuts, o.progress);
  fs::create_directories(file.parent_path());
  write_text(file, records_csv(drill(c, store)));
}

}  // namespace tdbd::calibration
