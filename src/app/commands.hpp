#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace tdbd::app {

/// Each adds one subcommand; when it runs, its exit code goes to `exit_code`.
void add_run(CLI::App& app, int& exit_code);
void add_rotate(CLI::App& app, int& exit_code);
void add_converge(CLI::App& app, int& exit_code);
void add_check(CLI::App& app, int& exit_code);
void add_bit(CLI::App& app, int& exit_code);
void add_mesh(CLI::App& app, int& exit_code);

/// Runs a command's body: an InputError gives 2, any other failure 1, each with one message on
/// standard error.
int guarded(const std::function<int()>& body);

}  // namespace tdbd::app
