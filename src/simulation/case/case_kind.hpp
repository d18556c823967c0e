#pragma once

#include <string>
#include <vector>

#include "core/config/key_table.hpp"

namespace tdbd::simulation {

/// The kind of a TOML file, recognized by its tables.
enum class CaseKind { drilling, rotation, calibration, laboratory, sweep, string, bit, unknown };

/// Returns the kind of a file with its overrides. Throws InputError if it is not TOML.
CaseKind kind_of(const std::string& file, const std::vector<std::string>& overrides);

/// Throws InputError, with the command that the user probably meant, if the file is clearly of none
/// of the expected kinds.
void require_kind(const std::string& file, const std::vector<std::string>& overrides,
                  const std::vector<CaseKind>& expected);

/// Lists every table of an input file: of cases of `tdbd run`, then of `tdbd rotate`, then of bit
/// files. A new settings struct is added to the list in case_kind.cpp or bit/files/bit_file.cpp.
std::vector<KeyTable> all_tables();

}  // namespace tdbd::simulation
