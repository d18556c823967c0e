#pragma once

#include <filesystem>

#include "simulation/result/output_folder.hpp"

namespace tdbd::simulation {

/// The command that a folder's run was begun with.
enum class Stopped { run, rotate };

/// The case of a folder that a run was begun in, with its path. Throws InputError if it holds none, or one of another
/// command, which the message names.
std::filesystem::path stopped_case(const std::filesystem::path& folder, Stopped command);

/// Whether the folder holds the result of a run that reached its end. A kill right after that may
/// have left checkpoints: they go.
bool tidy_if_finished(const std::filesystem::path& folder);

/// Removes what an interrupted or failed run said of its end: that is no longer so. Throws RunError.
void forget_end(const OutputFolder& folder);

}  // namespace tdbd::simulation
