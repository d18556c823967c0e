#pragma once

#include <string>
#include <vector>

namespace tdbd::simulation {

/// What a TOML file is, by its tables.
enum class CaseKind { drilling, rotation, calibration, laboratory, sweep, string, bit, unknown };

/// Of the file with its overrides. Throws InputError when it is no TOML.
CaseKind kind_of(const std::string& file, const std::vector<std::string>& overrides);

/// Throws InputError, with the command that is meant, when the file is clearly of no expected kind.
void require_kind(const std::string& file, const std::vector<std::string>& overrides,
                  const std::vector<CaseKind>& expected);

}  // namespace tdbd::simulation
