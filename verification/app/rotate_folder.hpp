#pragma once

#include <string>
#include <vector>

#include "app/case_folder.hpp"

namespace tdbd::app {

/// A folder of one test with a case.toml that uses most keys of a rotate case: a heavy body with
/// two cones, one of them driven, in a periodic torque, on a spring. Beside it box.off, a mesh.
class RotateFolder : public CaseFolder {
 public:
  RotateFolder();

  /// `tdbd rotate case.toml -o out ...`
  battery::Outcome rotate(std::vector<std::string> more = {}, const std::string& out = "out",
                          const battery::Surroundings& around = {}) const;
  /// `tdbd converge case.toml -o orders ...`
  battery::Outcome converge(std::vector<std::string> more, const std::string& out = "orders") const;
};

/// A free body with two cones, nothing but its inertia, its motion and the time.
extern const char* const free_body_text;

}  // namespace tdbd::app
