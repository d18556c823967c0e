#pragma once

#include <string>

namespace CLI {
class App;
}

namespace tdbd::app {

/// What bash loads to complete the words behind `tdbd`: commands, options, names of values, files by
/// their endings, folders.
std::string bash_completion(const CLI::App& app);

}  // namespace tdbd::app
