#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <system_error>
#include <utility>
#include <vector>

#include "core/config/config.hpp"
#include "core/config/config_document.hpp"
#include "core/config/number_doubts.hpp"
#include "core/text.hpp"
#include "core/units.hpp"

namespace tdbd {
namespace {

/// The shortest digits that read back to the same number.
std::string number_text(double x) { return std::isfinite(x) ? fmt::format("{}", x) : ""; }

/// Returns "[a, b, c]"; empty if one of the texts is empty.
std::string bracketed(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) {
    if (text.empty()) return "";
    all += (all.empty() ? "" : ", ") + text;
  }
  return "[" + all + "]";
}

std::string list_text(const std::vector<double>& list) {
  std::vector<std::string> texts;
  texts.reserve(list.size());
  for (const double x : list) texts.push_back(number_text(x));
  return bracketed(texts);
}

std::string pairs_text(const std::vector<std::pair<double, double>>& pairs) {
  std::vector<std::string> texts;
  texts.reserve(pairs.size());
  for (const auto& [a, b] : pairs) texts.push_back(list_text({a, b}));
  return bracketed(texts);
}

std::string matrix_text(const Mat3& m) {
  if (!m.allFinite()) return "";
  return fmt::format("[{}, {}, {}]", toml_vector(m.row(0)), toml_vector(m.row(1)),
                     toml_vector(m.row(2)));
}

/// Converts a number in SI, or a text with a unit. Throws UnitError.
double read_quantity(const toml::node& node, const std::string& si_unit) {
  if (const auto text = node.as_string()) return to_si(text->get(), si_unit);
  std::optional<double> x;
  if (const auto number = node.as_floating_point()) x = number->get();
  if (const auto number = node.as_integer()) x = static_cast<double>(number->get());
  const std::string expected =
      si_unit == "1" ? describe_unit(si_unit)
                     : fmt::format("{}, or a text with a unit", describe_unit(si_unit));
  if (!x || !std::isfinite(*x)) throw UnitError(describe(&node), expected);
  return *x;
}

/// Converts an array of three quantities. Throws UnitError.
Vec3 read_three(const toml::node& node, const std::string& si_unit, const std::string& expected) {
  const toml::array* array = node.as_array();
  if (array == nullptr || array->size() != 3) throw UnitError(describe(&node), expected);
  return {read_quantity((*array)[0], si_unit), read_quantity((*array)[1], si_unit),
          read_quantity((*array)[2], si_unit)};
}

/// Describes how values of one type are read.
template <class T>
struct Kind {
  std::string expected;                          ///< in words
  std::string unit;                              ///< for the resolved file; may be empty
  T harmless;                                    ///< returned if the value is wrong or missing
  std::function<T(const toml::node&)> convert;   ///< throws UnitError
  std::function<std::string(const T&)> to_toml;  ///< empty: not expressible in TOML
};

/// The common part of all reads: finds the key, converts its value, records a problem if that
/// fails, and stores the value for the resolved file.
template <class T>
T read_value(ConfigDocument& document, const std::string& key, const std::optional<T>& fallback,
             const Kind<T>& kind) {
  T value = fallback.value_or(kind.harmless);
  if (const toml::node* node = document.find(key)) {
    try {
      value = kind.convert(*node);
    } catch (const UnitError& error) {
      document.add_problem(key, error.found, error.expected);
    }
  } else if (!fallback) {
    document.add_problem(key, "nothing", kind.expected + " (the key is required)");
  }
  document.values.try_emplace(key, ResolvedValue{kind.to_toml(value), kind.unit, ""});
  return value;
}

/// Suggests units for a bare number outside the range.
std::string unit_question(const toml::node& node, double x, const std::string& si_unit,
                          const Range& range, const Range& usual) {
  if (node.is_string()) return "";
  const std::string meant = units_meant(x, si_unit, range, usual_values(si_unit, range, usual));
  if (meant.empty()) return "";
  return si_unit == "1"
             ? fmt::format("; did you mean {}?", meant)
             : fmt::format("; without a unit it is in {}: did you mean {}?", si_unit, meant);
}

/// Stores the doubt about a bare number, at most one for each key.
void note_doubt(ConfigDocument& document, const std::string& key, const toml::node& node, double x,
                const std::string& si_unit, const Range& allowed, const Range& usual) {
  if (node.is_string() || (document.is_resolved && !document.overridden.contains(key))) return;
  const std::string doubt = bare_number_doubt(x, si_unit, allowed, usual);
  if (!doubt.empty()) document.doubts.try_emplace(key, doubt);
}

/// The usual values of the elements of an array. Small ones are usual: they may be components.
Range usual_elements(const std::string& si_unit, const Range& declared) {
  const Range usual = usual_values(si_unit, {}, declared);
  return Range::within(0.0, usual.hi);
}

/// A number in the range, with which a caller can continue until finish() reports the problem.
double harmless_number(const Range& range) {
  for (const double x : {1.0, range.lo, range.hi})
    if (std::isfinite(x) && range.contains(x)) return x;
  return 1.0;
}

}  // namespace

std::string Range::text() const {
  const bool below = std::isfinite(hi);
  if (ends == Ends::open_lo && below) return fmt::format(", in ({}, {}]", lo, hi);
  if (ends == Ends::open_lo) return fmt::format(", > {}", lo);
  if (std::isfinite(lo))
    return below ? fmt::format(", in [{}, {}]", lo, hi) : fmt::format(", >= {}", lo);
  return below ? fmt::format(", <= {}", hi) : "";
}

double Config::quantity(std::string_view key, const std::string& si_unit,
                        std::optional<double> fallback, Range range, Range usual) {
  const std::string expected = describe_unit(si_unit) + range.text();
  const auto convert = [&](const toml::node& node) {
    const double x = read_quantity(node, si_unit);
    if (!range.contains(x))
      throw UnitError(describe(&node), expected + unit_question(node, x, si_unit, range, usual));
    note_doubt(*document_, full(key), node, x, si_unit, range, usual);
    return x;
  };
  const double value =
      read_value<double>(*document_, full(key), fallback,
                         {expected, si_unit, harmless_number(range), convert, number_text});
  if (std::isfinite(value)) document_->values[full(key)].quantity = value;
  return value;
}

Vec3 Config::vector(std::string_view key, const std::string& si_unit,
                    std::optional<Vec3> fallback) {
  const std::string expected = fmt::format("an array of three: {}", describe_unit(si_unit));
  const auto convert = [&](const toml::node& node) {
    const Vec3 x = read_three(node, si_unit, expected);
    for (int i = 0; i < 3; ++i)
      note_doubt(*document_, full(key), (*node.as_array())[static_cast<std::size_t>(i)], x[i],
                 si_unit, {}, usual_elements(si_unit, {}));
    return x;
  };
  return read_value<Vec3>(*document_, full(key), fallback,
                          {expected, si_unit, Vec3::UnitZ(), convert, toml_vector});
}

std::vector<double> Config::list(std::string_view key, const std::string& si_unit,
                                 std::optional<std::vector<double>> fallback, Range usual) {
  const std::string expected = fmt::format("an array: {}", describe_unit(si_unit));
  const auto convert = [&](const toml::node& node) {
    const toml::array* array = node.as_array();
    if (array == nullptr) throw UnitError(describe(&node), expected);
    std::vector<double> list;
    for (const toml::node& element : *array) {
      list.push_back(read_quantity(element, si_unit));
      note_doubt(*document_, full(key), element, list.back(), si_unit, {},
                 usual_elements(si_unit, usual));
    }
    return list;
  };
  return read_value<std::vector<double>>(*document_, full(key), fallback,
                                         {expected, si_unit, {}, convert, list_text});
}

std::vector<std::string> Config::texts(std::string_view key,
                                       const std::optional<std::vector<std::string>>& fallback) {
  const std::string expected = "an array of texts";
  const auto convert = [&](const toml::node& node) {
    const toml::array* array = node.as_array();
    if (array == nullptr) throw UnitError(describe(&node), expected);
    std::vector<std::string> list;
    for (const toml::node& element : *array) {
      if (!element.is_string()) throw UnitError(describe(&element), expected);
      list.push_back(element.as_string()->get());
    }
    return list;
  };
  return read_value<std::vector<std::string>>(*document_, full(key), fallback,
                                              {expected, "", {}, convert, toml_texts});
}

std::vector<std::pair<double, double>> Config::pairs(
    std::string_view key, const std::string& si_unit,
    std::optional<std::vector<std::pair<double, double>>> fallback, Range usual) {
  using Pairs = std::vector<std::pair<double, double>>;
  const std::string expected = fmt::format("an array of pairs: {}", describe_unit(si_unit));
  const auto convert = [&](const toml::node& node) {
    const toml::array* array = node.as_array();
    if (array == nullptr) throw UnitError(describe(&node), expected);
    Pairs pairs;
    for (const toml::node& element : *array) {
      const toml::array* pair = element.as_array();
      if (pair == nullptr || pair->size() != 2) throw UnitError(describe(&element), expected);
      pairs.emplace_back(read_quantity((*pair)[0], si_unit), read_quantity((*pair)[1], si_unit));
      for (const double x : {pairs.back().first, pairs.back().second})
        note_doubt(*document_, full(key), (*pair)[x == pairs.back().first ? 0 : 1], x, si_unit, {},
                   usual_elements(si_unit, usual));
    }
    return pairs;
  };
  return read_value<Pairs>(*document_, full(key), fallback,
                           {expected, si_unit, {}, convert, pairs_text});
}

Mat3 Config::matrix(std::string_view key, const std::string& si_unit,
                    std::optional<Mat3> fallback) {
  const std::string expected = fmt::format("three rows of three: {}", describe_unit(si_unit));
  const auto convert = [&](const toml::node& node) {
    const toml::array* rows = node.as_array();
    if (rows == nullptr || rows->size() != 3) throw UnitError(describe(&node), expected);
    Mat3 m;
    for (int i = 0; i < 3; ++i)
      m.row(i) = read_three((*rows)[static_cast<std::size_t>(i)], si_unit, expected);
    return m;
  };
  return read_value<Mat3>(*document_, full(key), fallback,
                          {expected, si_unit, Mat3::Identity(), convert, matrix_text});
}

long Config::integer(std::string_view key, std::optional<long> fallback, long lo, long hi) {
  const std::string expected = fmt::format("a whole number from {} to {}", lo, hi);
  const auto convert = [&](const toml::node& node) {
    const auto value = node.as_integer();
    if (value == nullptr || value->get() < lo || value->get() > hi)
      throw UnitError(describe(&node), expected);
    return static_cast<long>(value->get());
  };
  const auto write = [](long n) { return fmt::format("{}", n); };
  return read_value<long>(*document_, full(key), fallback, {expected, "", lo, convert, write});
}

bool Config::flag(std::string_view key, std::optional<bool> fallback) {
  const std::string expected = "true, false, \"on\" or \"off\"";
  const auto convert = [&](const toml::node& node) {
    if (const auto value = node.as_boolean()) return value->get();
    const auto text = node.as_string();
    if (text == nullptr || (text->get() != "on" && text->get() != "off"))
      throw UnitError(describe(&node), expected);
    return text->get() == "on";
  };
  const auto write = [](bool b) { return std::string(b ? "true" : "false"); };
  return read_value<bool>(*document_, full(key), fallback, {expected, "", false, convert, write});
}

std::string Config::text(std::string_view key, std::optional<std::string> fallback) {
  const std::string expected = "a text in quotes";
  const auto convert = [&](const toml::node& node) {
    const auto text = node.as_string();
    if (text == nullptr) throw UnitError(describe(&node), expected);
    return text->get();
  };
  return read_value<std::string>(*document_, full(key), fallback,
                                 {expected, "", "", convert, toml_string});
}

std::string Config::path(std::string_view key, std::optional<std::string> fallback) {
  const std::string expected = "the path of an existing file, from the case file's folder";
  const auto absolute = [&](const std::string& given) -> std::string {
    if (given.empty()) return "";
    return (std::filesystem::path(document_->folder) / given).lexically_normal().string();
  };
  if (fallback) fallback = absolute(*fallback);
  const auto convert = [&](const toml::node& node) {
    const auto text = node.as_string();
    if (text == nullptr) throw UnitError(describe(&node), expected);
    if (text->get().empty() && fallback == "") return std::string();
    const std::string file = absolute(text->get());
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
      throw UnitError(fmt::format("{} (there is no {})", describe(&node), file), expected);
    return file;
  };
  const std::string file = read_value<std::string>(*document_, full(key), fallback,
                                                   {expected, "", "", convert, toml_string});
  document_->values[full(key)].file = file;
  return file;
}

std::size_t Config::choice_index(std::string_view key, const std::vector<std::string>& names,
                                 std::optional<std::size_t> fallback) {
  const std::string expected = "one of " + joined(names);
  const auto convert = [&](const toml::node& node) {
    const auto text = node.as_string();
    if (text == nullptr) throw UnitError(describe(&node), expected);
    const auto at = std::find(names.begin(), names.end(), text->get());
    if (at != names.end()) return static_cast<std::size_t>(at - names.begin());
    const auto near = nearest_name(text->get(), names);
    throw UnitError(describe(&node),
                    near ? fmt::format("{} (did you mean {}?)", expected, *near) : expected);
  };
  const auto write = [&](std::size_t i) { return toml_string(names[i]); };
  return read_value<std::size_t>(*document_, full(key), fallback,
                                 {expected, "", 0, convert, write});
}

}  // namespace tdbd
