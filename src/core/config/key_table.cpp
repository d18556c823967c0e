#include "core/config/key_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"

namespace tdbd {
namespace {

std::string in_unit(std::string_view unit) { return unit == "1" ? "number" : std::string(unit); }

std::string with_unit(const std::string& number, std::string_view unit) {
  return unit == "1" ? number : fmt::format("{} {}", number, unit);
}

/// The default of a key without a fixed fallback, in words.
std::string other_fallback(std::string_view computed_default) {
  return computed_default.empty() ? "required" : std::string(computed_default);
}

std::string in_words(const Range& range) {
  const std::string text = range.text();  // ", > 0"
  return text.empty() ? text : text.substr(2);
}

std::string comma_list(const std::vector<std::string_view>& names) {
  std::string all;
  for (const std::string_view name : names)
    all += fmt::format("{}{}", all.empty() ? "" : ", ", name);
  return all;
}

KeyRow array_row(std::string_view name, const std::string& kind, std::string_view computed_default,
                 std::string_view meaning) {
  return {std::string(name), kind, other_fallback(computed_default), "", std::string(meaning)};
}

/// The row of a key with a fixed fallback, formatted as in a file.
KeyRow with_fallback(KeyRow row, const std::string& toml) {
  row.fallback = row.toml = toml;
  return row;
}

}  // namespace

KeyRow row(const QuantityKey& key) {
  KeyRow r = array_row(key.name, in_unit(key.unit), key.computed_default, key.meaning);
  r.allowed = in_words(key.range);
  if (!key.fallback) return r;
  if (!std::isfinite(*key.fallback)) return with_fallback(std::move(r), "no limit");
  r.toml = fmt::format("{}", *key.fallback);
  r.fallback = with_unit(r.toml, key.unit);
  return r;
}

KeyRow row(const VectorKey& key) {
  KeyRow r = array_row(key.name, "three " + in_unit(key.unit), key.computed_default, key.meaning);
  if (!key.fallback) return r;
  const auto& [x, y, z] = *key.fallback;
  return with_fallback(std::move(r), fmt::format("[{}, {}, {}]", x, y, z));
}

KeyRow row(const ListKey& key) {
  return array_row(key.name, "list of " + in_unit(key.unit), key.computed_default, key.meaning);
}

KeyRow row(const TextsKey& key) {
  return array_row(key.name, "list of texts", key.computed_default, key.meaning);
}

KeyRow row(const PairsKey& key) {
  return array_row(key.name, "pairs of " + in_unit(key.unit), key.computed_default, key.meaning);
}

KeyRow row(const MatrixKey& key) {
  return array_row(key.name, "3 x 3 " + in_unit(key.unit), key.computed_default, key.meaning);
}

KeyRow row(const IntegerKey& key) {
  KeyRow r = array_row(key.name, "whole number", key.computed_default, key.meaning);
  r.allowed = key.hi == std::numeric_limits<long>::max() ? fmt::format(">= {}", key.lo)
                                                         : fmt::format("{} to {}", key.lo, key.hi);
  return key.fallback ? with_fallback(std::move(r), fmt::format("{}", *key.fallback)) : r;
}

KeyRow row(const FlagKey& key) {
  KeyRow r = array_row(key.name, "on or off", key.computed_default, key.meaning);
  if (!key.fallback) return r;
  r.toml = *key.fallback ? "true" : "false";
  r.fallback = *key.fallback ? "on" : "off";
  return r;
}

KeyRow row(const TextKey& key) {
  KeyRow r = array_row(key.name, "text", key.computed_default, key.meaning);
  return key.fallback ? with_fallback(std::move(r), fmt::format("\"{}\"", *key.fallback)) : r;
}

KeyRow row(const ScalarKey& key) {
  return array_row(key.name, "value with unit", key.computed_default, key.meaning);
}

KeyRow row(const ScalarsKey& key) {
  return array_row(key.name, "list of values", key.computed_default, key.meaning);
}

KeyRow row(const AnyKey& key) {
  return array_row(key.name, std::string(key.kind), key.computed_default, key.meaning);
}

KeyRow row(const PathKey& key) {
  return array_row(key.name, "file", key.computed_default, key.meaning);
}

KeyRow row(const NameKey& key) {
  return choice_row(key.name, key.names(), "", key.computed_default, key.meaning);
}

KeyRow choice_row(std::string_view name, const std::vector<std::string_view>& names,
                  std::string_view fallback, std::string_view computed_default,
                  std::string_view meaning) {
  KeyRow r = array_row(name, "one of", computed_default, meaning);
  r.allowed = comma_list(names);
  return fallback.empty() ? r : with_fallback(std::move(r), fmt::format("\"{}\"", fallback));
}

KeyTable key_table(const std::string& command, const TableKey& key, std::vector<KeyRow> rows) {
  return {command, std::string(key.name), std::string(key.meaning), key.repeats, std::move(rows)};
}

namespace {

/// Whether the initial value of the field is its default.
template <class Key>
bool shows_value(const Key& key) {
  return key.need != Need::required && key.computed_default.empty();
}

/// Returns the row of a key. If `fallback` is its default, the row shows it.
template <class Key, class Value>
KeyRow row_with(Key key, const Value& fallback) {
  if (shows_value(key)) key.fallback = fallback;
  return row(key);
}

}  // namespace

void FieldLister::operator()(double& x, const QuantityKey& key) {
  rows.push_back(row_with(key, x));
}

void FieldLister::operator()(Vec3& x, const VectorKey& key) {
  rows.push_back(row_with(key, std::array{x.x(), x.y(), x.z()}));
}

void FieldLister::operator()(std::vector<double>&, const ListKey& key) { rows.push_back(row(key)); }

void FieldLister::operator()(std::vector<std::pair<double, double>>&, const PairsKey& key) {
  rows.push_back(row(key));
}

void FieldLister::operator()(Mat3&, const MatrixKey& key) { rows.push_back(row(key)); }

void FieldLister::operator()(std::vector<std::string>&, const TextsKey& key) {
  rows.push_back(row(key));
}

void FieldLister::operator()(long& x, const IntegerKey& key) { rows.push_back(row_with(key, x)); }

void FieldLister::operator()(bool& x, const FlagKey& key) { rows.push_back(row_with(key, x)); }

void FieldLister::operator()(std::string& x, const TextKey& key) {
  rows.push_back(row_with(key, std::string_view(x)));
}

void FieldLister::operator()(ConfigScalar&, const ScalarKey& key) { rows.push_back(row(key)); }

void FieldLister::operator()(std::vector<ConfigScalar>&, const ScalarsKey& key) {
  rows.push_back(row(key));
}

void FieldLister::path(std::string&, const PathKey& key) { rows.push_back(row(key)); }

void FieldLister::name(std::string&, const NameKey& key) { rows.push_back(row(key)); }

std::optional<std::size_t> FieldLister::choose(const NamedChoice& c) {
  const std::string_view value = shows_value(c) && c.index ? c.names[*c.index] : "";
  rows.push_back(choice_row(c.name, c.names, value, c.computed_default, c.meaning));
  return std::nullopt;
}

std::string header_of(const KeyTable& table) {
  if (table.name.empty()) return "top of the file";
  return table.repeats == Repeats::yes ? fmt::format("[[{}]]", table.name)
                                       : fmt::format("[{}]", table.name);
}

std::string keys_as_text(std::span<const KeyTable> tables) {
  std::string out;
  for (const KeyTable& table : tables) {
    std::size_t name = 0, kind = 0, fallback = 0;
    for (const KeyRow& r : table.rows) {
      name = std::max(name, r.name.size());
      kind = std::max(kind, r.kind.size());
      fallback = std::max(fallback, r.fallback.size());
    }
    out += fmt::format("{}{} of tdbd {}: {}\n", out.empty() ? "" : "\n", header_of(table),
                       table.command, table.meaning);
    for (const KeyRow& r : table.rows)
      out += fmt::format("  {:<{}}  {:<{}}  {:<{}}  {}{}\n", r.name, name, r.kind, kind, r.fallback,
                         fallback, r.meaning, r.allowed.empty() ? "" : " (" + r.allowed + ")");
  }
  return out;
}

std::string keys_as_markdown(std::span<const KeyTable> tables) {
  std::string out;
  for (const KeyTable& table : tables) {
    out += fmt::format(
        "{}## `{}` of `tdbd {}`: {}\n\n| key | kind | default | allowed | meaning |\n"
        "|---|---|---|---|---|\n",
        out.empty() ? "" : "\n", header_of(table), table.command, table.meaning);
    for (const KeyRow& r : table.rows)
      out += fmt::format("| `{}` | {} | {} | {} | {} |\n", r.name, r.kind, r.fallback, r.allowed,
                         r.meaning);
  }
  return out;
}

std::vector<KeyTable> tables_named(std::span<const KeyTable> tables, const std::string& name,
                                   const std::string& listed_by) {
  std::vector<KeyTable> found;
  std::vector<std::string> names;
  for (const KeyTable& table : tables) {
    if (!table.name.empty()) names.push_back(table.name);  // the top of a file has no name
    if (table.name == name || table.name.starts_with(name + ".")) found.push_back(table);
  }
  if (!found.empty()) return found;
  const auto near = nearest_name(name, names);
  throw InputError(fmt::format("TABLE: found \"{}\", expected {}", name,
                               near ? *near : fmt::format("a table that `{}` lists", listed_by)));
}

}  // namespace tdbd
