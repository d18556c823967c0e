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

/// What stands in place of a fixed fallback.
std::string other_fallback(std::string_view usual) {
  return usual.empty() ? "required" : std::string(usual);
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

KeyRow array_row(std::string_view name, const std::string& kind, std::string_view usual,
                 std::string_view meaning) {
  return {std::string(name), kind, other_fallback(usual), "", std::string(meaning)};
}

/// The row with a fixed fallback, as it stands in a file.
KeyRow with_fallback(KeyRow row, const std::string& toml) {
  row.fallback = row.toml = toml;
  return row;
}

}  // namespace

KeyRow row(const QuantityKey& key) {
  KeyRow r = array_row(key.name, in_unit(key.unit), key.usual, key.meaning);
  r.allowed = in_words(key.range);
  if (!key.fallback) return r;
  if (!std::isfinite(*key.fallback)) return with_fallback(std::move(r), "no limit");
  r.toml = fmt::format("{}", *key.fallback);
  r.fallback = with_unit(r.toml, key.unit);
  return r;
}

KeyRow row(const VectorKey& key) {
  KeyRow r = array_row(key.name, "three " + in_unit(key.unit), key.usual, key.meaning);
  if (!key.fallback) return r;
  const auto& [x, y, z] = *key.fallback;
  return with_fallback(std::move(r), fmt::format("[{}, {}, {}]", x, y, z));
}

KeyRow row(const ListKey& key) {
  return array_row(key.name, "list of " + in_unit(key.unit), key.usual, key.meaning);
}

KeyRow row(const TextsKey& key) {
  return array_row(key.name, "list of texts", key.usual, key.meaning);
}

KeyRow row(const PairsKey& key) {
  return array_row(key.name, "pairs of " + in_unit(key.unit), key.usual, key.meaning);
}

KeyRow row(const MatrixKey& key) {
  return array_row(key.name, "3 x 3 " + in_unit(key.unit), key.usual, key.meaning);
}

KeyRow row(const IntegerKey& key) {
  KeyRow r = array_row(key.name, "whole number", key.usual, key.meaning);
  r.allowed = key.hi == std::numeric_limits<long>::max() ? fmt::format(">= {}", key.lo)
                                                         : fmt::format("{} to {}", key.lo, key.hi);
  return key.fallback ? with_fallback(std::move(r), fmt::format("{}", *key.fallback)) : r;
}

KeyRow row(const FlagKey& key) {
  KeyRow r = array_row(key.name, "on or off", key.usual, key.meaning);
  if (!key.fallback) return r;
  r.toml = *key.fallback ? "true" : "false";
  r.fallback = *key.fallback ? "on" : "off";
  return r;
}

KeyRow row(const TextKey& key) {
  KeyRow r = array_row(key.name, "text", key.usual, key.meaning);
  return key.fallback ? with_fallback(std::move(r), fmt::format("\"{}\"", *key.fallback)) : r;
}

KeyRow row(const WordKey& key) {
  return array_row(key.name, "value with unit", key.usual, key.meaning);
}

KeyRow row(const WordsKey& key) {
  return array_row(key.name, "list of values", key.usual, key.meaning);
}

KeyRow row(const AnyKey& key) {
  return array_row(key.name, std::string(key.kind), key.usual, key.meaning);
}

KeyRow row(const PathKey& key) { return array_row(key.name, "file", key.usual, key.meaning); }

KeyRow row(const NameKey& key) {
  return choice_row(key.name, key.names(), "", key.usual, key.meaning);
}

KeyRow choice_row(std::string_view name, const std::vector<std::string_view>& names,
                  std::string_view fallback, std::string_view usual, std::string_view meaning) {
  KeyRow r = array_row(name, "one of", usual, meaning);
  r.allowed = comma_list(names);
  return fallback.empty() ? r : with_fallback(std::move(r), fmt::format("\"{}\"", fallback));
}

KeyTable key_table(const std::string& command, const TableKey& key, std::vector<KeyRow> rows) {
  return {command, std::string(key.name), std::string(key.meaning), key.repeats, std::move(rows)};
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
    if (!table.name.empty()) names.push_back(table.name);  // the top of a file has none
    if (table.name == name || table.name.starts_with(name + ".")) found.push_back(table);
  }
  if (!found.empty()) return found;
  const auto near = nearest_name(name, names);
  throw InputError(fmt::format("TABLE: found \"{}\", expected {}", name,
                               near ? *near : fmt::format("a table that `{}` lists", listed_by)));
}

}  // namespace tdbd
