#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "core/error.hpp"

namespace tdbd::bench {

/// Parses the command line and runs the program. Returns its exit code: 2 for bad input.
template <class Run>
int parse_and_run(CLI::App& app, int argc, char** argv, Run&& run) try {
  app.parse(argc, argv);
  run();
  return 0;
} catch (const CLI::ParseError& e) {
  return app.exit(e) == 0 ? 0 : 2;
} catch (const InputError& e) {
  fmt::print(stderr, "{}\n", e.what());
  return 2;
}

}  // namespace tdbd::bench
