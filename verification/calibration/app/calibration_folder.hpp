#pragma once

#include <string>
#include <vector>

#include "app/case_folder.hpp"

namespace tdbd::app {

/// A folder of one test with case.toml and records.csv: three single cutters on flat rock at two
/// pressures under a known law with a few percent of noise; c13 and c19 are fitted, c16 is
/// predicted. Nothing is drilled.
class CalibrationFolder : public CaseFolder {
 public:
  CalibrationFolder();

  /// `tdbd calibrate case.toml -o out ...`
  battery::Outcome calibrate(std::vector<std::string> more = {},
                             const std::string& out = "out") const;
};

/// The same with bits.toml, two small bits in coarse rock whose records `tdbd laboratory` makes.
class BitFolder : public CalibrationFolder {
 public:
  BitFolder();

  /// `tdbd laboratory laboratory.toml -o lab.csv --cuts CUTS`
  battery::Outcome laboratory(std::vector<std::string> more = {},
                              const std::string& out = "lab.csv") const;
};

}  // namespace tdbd::app
