#include "simulation/study/convergence_run.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/whole_file.hpp"
#include "simulation/study/convergence_output.hpp"

namespace tdbd::simulation {
namespace {

namespace fs = std::filesystem;

/// The inputs of a study. The reference is one of them, so that the study cannot overwrite it.
std::vector<std::string> inputs_of(const ConvergencePlace& place, const ConvergenceStart& start) {
  std::vector<std::string> inputs = start.files;
  if (!place.reference.empty())
    inputs.push_back(fs::is_directory(place.reference) ? fs::path(place.reference) / "summary.json"
                                                       : fs::path(place.reference));
  return inputs;
}

}  // namespace

Convergence converge_into(const ConvergencePlace& place, const ConvergencePlan& plan,
                          const ConvergenceOptions& options) {
  const ConvergenceStart start = check(plan);
  const OutputFolder folder =
      prepare(place.folder, place.overwrite, inputs_of(place, start), ResultKind::convergence);
  try {
    Convergence c = converge(plan, options);
    write_convergence(folder.path, c);
    return c;
  } catch (const RunError& e) {
    write_text(folder.failure(), fmt::format("{}\n", e.what()));
    throw;
  }
}

}  // namespace tdbd::simulation
