#pragma once

#include <fmt/format.h>

#include <string>

#include "io/output_folder.hpp"
#include "python/src/watch.hpp"
#include "simulation/case/run_settings.hpp"

namespace tdbd::python {

/// Warnings of a run, as printed by the command line.
using Told = std::vector<std::string>;

inline Overwrite overwrite_of(bool force) { return force ? Overwrite::force : Overwrite::no; }

/// Checks the number of threads against the limit of the command line. Throws ValueError.
inline int checked_threads(long threads) {
  constexpr long most = 1024;
  if (threads < 1 || threads > most)
    throw py::value_error(fmt::format("threads: found {}, expected 1 to {}", threads, most));
  return static_cast<int>(threads);
}

/// RunOptions or RotateOptions with their common members set.
template <class Options>
Options options_for(const std::string& folder, bool force, const Watch& watch, Told& told) {
  Options options;
  options.folder = folder;
  options.overwrite = overwrite_of(force);
  options.interrupted = &watch.interrupted();
  options.warn = [&told](const std::string& text) { told.push_back(text); };
  return options;
}

}  // namespace tdbd::python
