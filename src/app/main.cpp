#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>
#include <utility>
#include <vector>

#include "app/arguments.hpp"
#include "app/terminal.hpp"
#include "core/error.hpp"
#include "core/provenance.hpp"
#include "core/text.hpp"

namespace {

/// Turns a closed pipe or a file size limit into failed writes, which are reported like other
/// errors.
void ignore_write_signals() {
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
}

/// Reports failures that exceptions cannot propagate: in a destructor, or in a TBB thread that
/// could not start another one.
[[noreturn]] void terminate_handler() {
  try {
    if (std::current_exception()) std::rethrow_exception(std::current_exception());
  } catch (const std::exception& e) {
    std::fprintf(stderr, "tdbd: %s\n", tdbd::error_message_of(e));
    _exit(1);
  } catch (...) {
  }
  std::abort();
}

/// The output of `--version`.
std::string version_text() {
  const tdbd::Provenance& p = tdbd::provenance();
  return std::string("tdbd ") + p.version + "\ncommit " + p.commit + "\ncompiler " + p.compiler +
         "\nflags " + p.flags;
}

/// Prints the help, the version or an error. Returns 0 after --help and --version, 2 for an invalid
/// command line.
int print_message(const CLI::App& app, const CLI::ParseError& error) {
  if (error.get_exit_code() == 0) return app.exit(error);
  std::fprintf(stderr, "tdbd: %s\n", tdbd::app::mistake(error).c_str());
  return 2;
}

/// Parses the words and runs their command. CLI11 requires them in reverse order.
int dispatch(CLI::App& app, int& exit_code, std::vector<std::string> words) {
  if (const auto page = tdbd::app::requested_page(app, words)) {
    tdbd::app::write_out(*page);
    return 0;
  }
  words = tdbd::app::parsed_words(app, std::move(words));
  if (words.empty()) {
    tdbd::app::write_out(tdbd::app::overview(app));
    return 0;
  }
  std::reverse(words.begin(), words.end());
  try {
    app.parse(std::move(words));
  } catch (const CLI::ParseError& e) {
    return print_message(app, e);
  }
  return exit_code;
}

/// Throws InputError at the first word with a byte that is no UTF-8: names of files are stored in
/// results, which are UTF-8.
void require_utf8(const std::vector<std::string>& words) {
  for (std::size_t i = 0; i < words.size(); ++i)
    if (const auto wrong = tdbd::invalid_utf8(words[i]))
      throw tdbd::InputError(fmt::format(
          "command line: word {}: found byte 0x{:02X} after \"{}\", expected UTF-8: rename the "
          "file",
          i + 1, static_cast<unsigned char>(words[i][*wrong]), words[i].substr(0, *wrong)));
}

}  // namespace

/// The command line. Exit codes: 0 success, 1 computation failed, 2 invalid input, 130 interrupted.
int main(int argc, char** argv) {
  ignore_write_signals();
  std::set_terminate(terminate_handler);
  CLI::App app{"TDBD: drill bits cutting rock, verification first", "tdbd"};
  app.require_subcommand(1);
  app.set_version_flag("--version", version_text());
  app.footer(
      "Exit codes: 0 done, 1 the computation failed, 2 the input is wrong, 130 interrupted.");
  int exit_code = 0;
  tdbd::app::add_new(app, exit_code);
  tdbd::app::add_run(app, exit_code);
  tdbd::app::add_rotate(app, exit_code);
  tdbd::app::add_string(app, exit_code);
  tdbd::app::add_converge(app, exit_code);
  tdbd::app::add_calibrate(app, exit_code);
  tdbd::app::add_check(app, exit_code);
  tdbd::app::add_keys(app, exit_code);
  tdbd::app::add_bit(app, exit_code);
  tdbd::app::add_laboratory(app, exit_code);
  tdbd::app::add_sweep(app, exit_code);
  tdbd::app::add_curve(app, exit_code);
  tdbd::app::add_mesh(app, exit_code);
  tdbd::app::add_draw(app, exit_code);
  tdbd::app::add_page(app, exit_code);
  tdbd::app::add_report(app, exit_code);
  tdbd::app::add_compare(app, exit_code);
  const int code = tdbd::app::guarded([&] {
    std::vector<std::string> words(argv + 1, argv + argc);
    require_utf8(words);
    return dispatch(app, exit_code, std::move(words));
  });
  return tdbd::app::after_output(code);
}
