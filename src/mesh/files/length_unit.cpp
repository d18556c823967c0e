#include "mesh/files/length_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <system_error>

#include "core/text.hpp"
#include "core/units.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/text_reader.hpp"

namespace tdbd::mesh {
namespace {

constexpr std::string_view comment_key = "tdbd unit ", name_key = "unit=";
constexpr double same_length = 1e-9;  // relative; conversions of units differ by rounding

bool agree(double a, double b) { return std::abs(a - b) <= same_length * b; }

std::optional<int> power_of_ten(double metres) {
  constexpr int least = -12, most = 6;
  for (int p = least; p <= most; ++p)
    if (agree(metres, std::pow(10.0, p))) return p;
  return std::nullopt;
}

/// Units in headers come from files of any origin, so a wrong one is none.
std::optional<LengthUnit> unit_in_header(std::string_view text) {
  try {
    return length_unit(text);
  } catch (const UnitError&) {
    return std::nullopt;
  }
}

std::optional<LengthUnit> unit_of_first_solid(std::string_view bytes) {
  std::string_view line = bytes.substr(0, bytes.find_first_of("\r\n"));
  line.remove_prefix(std::min(line.find_first_of(" \t"), line.size()));
  std::string name(trimmed(line));
  return take_unit_of_name(name);
}

/// Removes the first line and returns it without the blanks around it.
std::string_view take_line(std::string_view& bytes) {
  const std::size_t end = std::min(bytes.find('\n'), bytes.size() - 1);
  const std::string_view line = trimmed(bytes.substr(0, end + 1));
  bytes.remove_prefix(end + 1);
  return line;
}

/// Searches the comments above the first statement of an OBJ or OFF file, whose keyword may come
/// first, or those of the header of a PLY file.
std::optional<LengthUnit> unit_of_comments(std::string_view bytes, std::string_view mark,
                                           bool (*is_end)(std::string_view)) {
  while (!bytes.empty()) {
    const std::string_view line = take_line(bytes);
    if (is_end(line)) break;
    if (!line.starts_with(mark)) continue;
    if (auto unit = unit_of_comment(trimmed(line.substr(mark.size())))) return unit;
  }
  return std::nullopt;
}

}  // namespace

LengthUnit length_unit(std::string_view text) {
  std::string quantity(trimmed(text));
  if (quantity.empty() || std::isalpha(static_cast<unsigned char>(quantity.front())) != 0)
    quantity = "1 " + quantity;
  const double metres = to_si(quantity, "m");
  if (!(metres > 0.0) || !std::isfinite(metres))
    throw UnitError('"' + std::string(text) + '"', "a positive length");
  return length_unit_of(metres);
}

LengthUnit length_unit_of(double metres) {
  constexpr std::array named = {
      std::pair{"m", 1.0},   std::pair{"dm", 0.1},    std::pair{"cm", 1e-2},  std::pair{"mm", 1e-3},
      std::pair{"um", 1e-6}, std::pair{"in", 0.0254}, std::pair{"ft", 0.3048}};
  for (const auto& [name, length] : named)
    if (agree(metres, length)) return {name, metres, power_of_ten(metres)};
  return {fmt::format("{}m", metres), metres, power_of_ten(metres)};
}

std::string unit_comment(const LengthUnit& unit) { return std::string(comment_key) + unit.name; }

std::optional<LengthUnit> unit_of_comment(std::string_view comment) {
  if (!comment.starts_with(comment_key)) return std::nullopt;
  return unit_in_header(comment.substr(comment_key.size()));
}

std::string name_with_unit(const std::string& name, const LengthUnit& unit) {
  return fmt::format("{}{}{}{}", name, name.empty() ? "" : " ", name_key, unit.name);
}

std::optional<LengthUnit> take_unit_of_name(std::string& name) {
  const std::size_t blank = name.find_last_of(" \t");
  const std::size_t last = blank == std::string::npos ? 0 : blank + 1;
  const std::string_view word = std::string_view(name).substr(last);
  if (!word.starts_with(name_key)) return std::nullopt;
  auto unit = unit_in_header(word.substr(name_key.size()));
  if (unit) name = std::string(trimmed(std::string_view(name).substr(0, last)));
  return unit;
}

std::optional<LengthUnit> stated_unit(std::string_view bytes, std::string_view extension) {
  bytes = without_mark(bytes);
  constexpr std::size_t stl_title = 80;
  if (extension == ".ply")
    return unit_of_comments(bytes, "comment ", [](auto line) { return line == "end_header"; });
  if (extension != ".stl")
    return unit_of_comments(bytes, "#", [](auto line) {
      return !line.empty() && !line.starts_with('#') && !line.ends_with("OFF");
    });
  if (begins_with_solid(bytes)) return unit_of_first_solid(trimmed(bytes));
  std::string_view title = bytes.substr(0, stl_title);
  return unit_of_comment(trimmed(title.substr(0, title.find('\0'))));
}

std::optional<LengthUnit> stated_unit_of(const std::filesystem::path& file) {
  constexpr std::size_t longest_header = 4096;
  std::error_code none;  // opening a pipe would block
  if (!std::filesystem::is_regular_file(file, none)) return std::nullopt;
  std::ifstream in(file, std::ios::binary);
  std::string bytes(longest_header, '\0');
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return stated_unit(bytes, lower_extension(file));
}

double unit_or(const std::filesystem::path& file, double otherwise) {
  const auto stated = stated_unit_of(file);
  return stated ? stated->metres : otherwise;
}

std::string unit_contradiction(const std::filesystem::path& file, double given) {
  return unit_contradiction(file, stated_unit_of(file), given);
}

std::string unit_contradiction(const std::filesystem::path& file,
                               const std::optional<LengthUnit>& stated, double given) {
  if (!stated || agree(given, stated->metres)) return "";
  const std::string name = length_unit_of(given).name;
  const bool has_number = std::isdigit(static_cast<unsigned char>(name.front())) != 0;
  return fmt::format("{}{}, but the header of {} states the unit {}", has_number ? "" : "1 ", name,
                     file.string(), stated->name);
}

namespace {

/// Splits a number into the text before the exponent and the exponent. Nothing if the exponent is
/// no integer.
std::optional<std::pair<std::string_view, int>> split_exponent(std::string_view word) {
  const std::size_t e = word.find_first_of("eE");
  if (e == std::string_view::npos) return std::pair{word, 0};
  std::string_view digits = word.substr(e + 1);
  if (digits.starts_with('+')) digits.remove_prefix(1);
  int exponent = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  constexpr int most = 100000;  // so that adding a power cannot overflow
  if (error != std::errc() || end != digits.data() + digits.size() || std::abs(exponent) > most)
    return std::nullopt;
  return std::pair{word.substr(0, e), exponent};
}

}  // namespace

std::optional<double> decimal_number(std::string_view word, int power) {
  if (word.starts_with('+')) word.remove_prefix(1);
  std::string shifted;
  if (power != 0) {
    const auto parts = split_exponent(word);
    if (!parts) return std::nullopt;
    shifted = fmt::format("{}e{}", parts->first, parts->second + power);
    word = shifted;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

std::string decimal_text(double x, int power) {
  constexpr int least = -7, most = 16;  // exponents outside are written as such
  if (x == 0.0 || power == 0) return fmt::format("{}", x);
  std::array<char, 32> buffer{};
  const auto [last, error] =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), x, std::chars_format::scientific);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(last - buffer.data()));
  const auto [mantissa, exponent] = split_exponent(text).value_or(std::pair{text, 0});
  const int shifted = exponent - power;
  if (shifted < least || shifted > most) return fmt::format("{}e{}", mantissa, shifted);
  const bool negative = mantissa.front() == '-';
  std::string digits;
  for (const char c : mantissa)
    if (c >= '0' && c <= '9') digits += c;
  if (shifted < 0) digits.insert(0, static_cast<std::size_t>(-shifted), '0');
  const std::size_t whole = static_cast<std::size_t>(std::max(shifted, 0)) + 1;
  if (digits.size() < whole) digits.append(whole - digits.size(), '0');
  if (digits.size() > whole) digits.insert(whole, 1, '.');
  return (negative ? "-" : "") + digits;
}

}  // namespace tdbd::mesh
