#pragma once

#include <span>

namespace tdbd::app {

/// A file of a case to begin with. Files of one kind stand together, the one to run first.
struct TemplateFile {
  const char* kind;     ///< "pdc", "cones", "top", "sweep", "calibration"
  const char* command;  ///< that runs the first
  const char* path;     ///< from the new folder
  const char* text;
};

/// All of them, embedded when the program was built.
std::span<const TemplateFile> template_files();

}  // namespace tdbd::app
