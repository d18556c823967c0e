#pragma once

#include <span>

namespace tdbd::app {

/// A file of a template case. Files of one kind are contiguous; the first is the one to run.
struct TemplateFile {
  const char* kind;     ///< "pdc", "bit", "cones", "top", "sweep", "calibration"
  const char* command;  ///< command that runs the first file
  const char* path;     ///< relative to the new folder
  const char* text;
};

/// All template files, embedded when the program was built.
std::span<const TemplateFile> template_files();

}  // namespace tdbd::app
