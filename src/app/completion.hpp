#pragma once

#include <string>

namespace CLI {
class App;
}

namespace tdbd::app {

/// The script with which bash completes the words after `tdbd`: commands, options, names of values,
/// files by extension, folders.
std::string bash_completion(const CLI::App& app);

}  // namespace tdbd::app
