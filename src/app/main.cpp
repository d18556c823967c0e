#include <CLI/CLI.hpp>

#include "app/commands.hpp"

/// The command line. Exit codes: 0 done, 1 the computation failed, 2 the input is wrong.
int main(int argc, char** argv) {
  CLI::App app{"TDBD: drill bits cutting rock, verification first", "tdbd"};
  app.require_subcommand(1);
  int exit_code = 0;
  tdbd::app::add_run(app, exit_code);
  tdbd::app::add_check(app, exit_code);
  tdbd::app::add_bit(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  return exit_code;
}
