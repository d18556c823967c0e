#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/checkpoint.hpp"
#include "simulation/case/case.hpp"

namespace tdbd::simulation {

/// The settings that may change when a run is resumed.
inline constexpr std::array<std::string_view, 3> resumable_keys{"time.duration", "time.revolutions",
                                                                "output.means_from"};

/// Gives a run that was stopped, or that is complete, a later end, and returns its new case, with
/// which resume_run continues it. The files of the result are then bitwise identical to those of an
/// uninterrupted run of the folder's case.toml with the same `overrides`, except timing.json and,
/// in summary.json, the observed order of the energy residual: the plan of a longer run may place
/// it at a step that the run has already made.
///
/// `overrides`: "key=value" of resumable_keys. The newest checkpoint and case.toml are rewritten
/// for the new case; the summary of the earlier end is removed. If the run is killed in between,
/// the same call continues. `warn` is called if an older checkpoint has to be used.
///
/// Throws InputError, before anything is changed, for other keys; for an end before the last
/// checkpoint; for a complete run without a checkpoint (output.checkpoint_every = 0); and for a new
/// output.means_from that is earlier than the checkpoint, because statistics contain sums over
/// steps.
Case extend_run(const std::filesystem::path& folder, const std::vector<std::string>& overrides,
                const CheckpointKeeper::Warn& warn);

}  // namespace tdbd::simulation
