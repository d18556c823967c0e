#pragma once

#include <string>

namespace CLI {
class App;
}

namespace tdbd::app {

/// The manual page tdbd(1), for man(7): all commands with their options, remarks and examples.
std::string manual_page(const CLI::App& app);

}  // namespace tdbd::app
