#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace tdbd {

/// Checks that `path` is a regular file (or a link to one) that can be opened. Otherwise throws
/// InputError "PATH: found F, expected E". Pipes and devices are rejected without being opened,
/// because they may never end. `expected` describes the file: "a TOML file".
void require_readable_file(const std::filesystem::path& path, std::string_view expected);

/// Reads all bytes of a file. Throws InputError like require_readable_file, and if reading fails.
std::string read_file(const std::filesystem::path& path, std::string_view expected);

/// Reads a text file as UTF-8 without byte-order mark. UTF-16 with a byte-order mark is converted.
/// Throws InputError "PATH:LINE: byte N of the line: found 0xE9, expected text in UTF-8" at the
/// first byte that is no UTF-8, such as an accented letter in Latin-1. `hint` follows the message.
std::string read_text_file(const std::filesystem::path& path, std::string_view expected,
                           std::string_view hint = {});

}  // namespace tdbd
