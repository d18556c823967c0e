#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace tdbd::app {

/// Each function adds one subcommand, which stores its exit code in `exit_code`.
void add_run(CLI::App& app, int& exit_code);
void add_rotate(CLI::App& app, int& exit_code);
void add_string(CLI::App& app, int& exit_code);
void add_converge(CLI::App& app, int& exit_code);
void add_calibrate(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_keys(CLI::App& app, int& exit_code);
void add_bit(CLI::App& app, int& exit_code);
void add_laboratory(CLI::App& app, int& exit_code);
void add_new(CLI::App& app, int& exit_code);
void add_sweep(CLI::App& app, int& exit_code);
void add_mesh(CLI::App& app, int& exit_code);

/// Runs the body of a command and returns its exit code: 2 after an InputError or an invalid path,
/// 1 after any other failure, each with one message on standard error.
int guarded(const std::function<int()>& body);

}  // namespace tdbd::app
