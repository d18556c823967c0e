#pragma once

#include <filesystem>
#include <string>

#include "sweep/design/design.hpp"
#include "sweep/sweep.hpp"

namespace tdbd::sweep {

/// A folder of its own for a test, empty.
std::filesystem::path empty_folder(const std::string& name);

/// Writes a design below that folder and reads it.
Design design_from(const std::filesystem::path& folder, const std::string& text);

/// A free top over three levels of step and two of its own spin: six points in milliseconds.
std::string small_top();

/// Bit B, a tenth of a revolution over 6 mm edges, with forces, and these factors.
std::string small_hole(const std::string& factors);

/// Runs a shard of a design.
SweepResult swept(const Design& d, const std::filesystem::path& table, int threads = 1,
                  Shard shard = {});

std::string text_of(const std::filesystem::path& file);

/// The message from reading the design; empty if it is valid.
std::string mistake_in(const std::string& text);

}  // namespace tdbd::sweep
