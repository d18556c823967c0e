#include "core/read_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <system_error>

#include "core/error.hpp"
#include "core/text.hpp"

namespace tdbd {
namespace {

[[noreturn]] void reject_file(const std::filesystem::path& path, std::string_view found,
                              std::string_view expected) {
  throw InputError(fmt::format("{}: found {}, expected {}", path.string(), found, expected));
}

}  // namespace

void require_readable_file(const std::filesystem::path& path, std::string_view expected) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) reject_file(path, "no such file", expected);
  if (!fs::status_known(status)) reject_file(path, error.message(), expected);
  if (fs::is_directory(status)) reject_file(path, "a folder", expected);
  if (!fs::is_regular_file(status)) reject_file(path, "no regular file", expected);
  if (std::ifstream(path)) return;
  if (is_resource_error({errno, std::generic_category()}))
    throw RunError(fmt::format("{}: cannot open: {}", path.string(), std::strerror(errno)));
  reject_file(path, fmt::format("a file that cannot be opened ({})", std::strerror(errno)),
              expected);
}

std::string read_file(const std::filesystem::path& path, std::string_view expected) {
  require_readable_file(path, expected);
  std::ifstream in(path, std::ios::binary);
  std::string bytes;
  std::error_code unknown;
  if (const std::uintmax_t size = std::filesystem::file_size(path, unknown); !unknown)
    bytes.resize(size);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  if (in) bytes.append(std::istreambuf_iterator<char>(in), {});  // it grew, or its size is unknown
  if (in.bad()) reject_file(path, "a file that cannot be read", expected);
  return bytes;
}

std::string read_text_file(const std::filesystem::path& path, std::string_view expected,
                           std::string_view hint) {
  std::string text = read_file(path, expected);
  if (text.starts_with("\xFF\xFE")) return utf8_of_utf16(std::string_view(text).substr(2), 0, 1);
  if (text.starts_with("\xFE\xFF")) return utf8_of_utf16(std::string_view(text).substr(2), 1, 0);
  if (text.starts_with("\xEF\xBB\xBF")) text.erase(0, 3);
  const std::optional<std::size_t> wrong = invalid_utf8(text);
  if (!wrong) return text;
  const std::string_view before = std::string_view(text).substr(0, *wrong);
  const std::size_t line = before.rfind('\n') + 1;  // 0 on the first line
  throw InputError(
      fmt::format("{}:{}: byte {} of the line: found 0x{:02X}, expected text in UTF-8{}",
                  path.string(), std::ranges::count(before, '\n') + 1, *wrong - line + 1,
                  static_cast<unsigned char>(text[*wrong]), hint));
}

}  // namespace tdbd
