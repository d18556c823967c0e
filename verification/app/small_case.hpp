#pragma once

#include <string>
#include <vector>

#include "app/case_folder.hpp"

namespace tdbd::app {

/// A folder of one test with a case that runs in a blink: a bit of six cutters in a coarse rock.
/// Files: case.toml, bit.toml, bit.csv.
class SmallCase : public CaseFolder {
 public:
  SmallCase();

  /// `tdbd run case.toml -o out ...`
  battery::Outcome run(std::vector<std::string> more = {}, const std::string& out = "out",
                       const battery::Surroundings& around = {}) const;
};

/// The input is refused: exit code 2, this message for this file alone, nothing written.
void expect_refused(const SmallCase& c, const std::string& message);

/// The small case with a law for its faces, and `tables` from line 18 of case.toml on.
class SmallCaseWithForces : public SmallCase {
 public:
  explicit SmallCaseWithForces(const std::string& tables);
};

}  // namespace tdbd::app
