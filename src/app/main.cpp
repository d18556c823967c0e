#include <unistd.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "app/commands.hpp"
#include "core/provenance.hpp"
#include "core/reason.hpp"

namespace {

/// A closed pipe and a limit on file sizes are failed writes, reported like any other.
void let_writes_fail() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// For failures that no exception carries out: in a destructor, or in a thread of TBB that could not start another one.
[[noreturn]] void end_without_catch() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::exception& e) {
    std::fprintf(stderr, "tdbd: %s\n", tdbd::reason_of(e));
    _exit(1);
  } catch (...) {
  }
  std::abort();
}

/// Fails a command whose output did not arrive.
int after_output(int exit_code) {
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return exit_code;
  std::fputs("tdbd: cannot write to standard output\n", stderr);
  return exit_code == 0 ? 1 : exit_code;
}

}  // namespace

/// The command line. Exit codes: 0 done, 1 the computation failed, 2 the input is wrong, 130
/// interrupted.
int main(int argc, char** argv) {
  let_writes_fail();
  std::set_terminate(end_without_catch);
  CLI::App app{"TDBD: drill bits cutting rock, verification first", "tdbd"};
  app.require_subcommand(1);
  app.set_version_flag("--version",
                       std::string(tdbd::provenance().version) + " " + tdbd::provenance().commit);
  app.footer(
      "Exit codes: 0 done, 1 the computation failed, 2 the input is wrong, 130 interrupted.");
  int exit_code = 0;
  tdbd::app::add_run(app, exit_code);
  tdbd::app::add_rotate(app, exit_code);
  tdbd::app::add_converge(app, exit_code);
  tdbd::app::add_calibrate(app, exit_code);
  tdbd::app::add_check(app, exit_code);
  tdbd::app::add_keys(app, exit_code);
  tdbd::app::add_bit(app, exit_code);
  tdbd::app::add_laboratory(app, exit_code);
  tdbd::app::add_mesh(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? 0 : 2;
  }
  return after_output(exit_code);
}
