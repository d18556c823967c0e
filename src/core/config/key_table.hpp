#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/config/key.hpp"

namespace tdbd {

/// A declared key in words, whatever its type.
struct KeyRow {
  std::string name;
  std::string kind;      ///< "m", "three rad/s", "whole number", "one of", ...
  std::string fallback;  ///< as in a file ("0.03 m"), in words ("one turn of the bit"), "required"
  std::string allowed;   ///< "> 0", "steady, whirl, ..."; empty: anything of its kind
  std::string meaning;
  std::string toml = {};  ///< a fixed fallback as the resolved file writes it; empty: there is none
};

/// A table with its keys, for `tdbd keys` and KEYS.md.
struct KeyTable {
  std::string command;  ///< that reads it: "run", "rotate"
  std::string name;     ///< dotted, from the top of the file; empty: the top itself
  std::string meaning;
  Repeats repeats = Repeats::no;
  std::vector<KeyRow> rows;
};

/// The table with its rows.
KeyTable key_table(const std::string& command, const TableKey& key, std::vector<KeyRow> rows);

KeyRow row(const QuantityKey& key);
KeyRow row(const VectorKey& key);
KeyRow row(const ListKey& key);
KeyRow row(const PairsKey& key);
KeyRow row(const MatrixKey& key);
KeyRow row(const IntegerKey& key);
KeyRow row(const FlagKey& key);
KeyRow row(const TextKey& key);
KeyRow row(const PathKey& key);
KeyRow row(const NameKey& key);
KeyRow row(const TextsKey& key);
KeyRow row(const WordKey& key);
KeyRow row(const WordsKey& key);
KeyRow row(const AnyKey& key);

/// A choice with its names; `fallback` is the name of the fallback, or empty.
KeyRow choice_row(std::string_view name, const std::vector<std::string_view>& names,
                  std::string_view fallback, std::string_view usual, std::string_view meaning);

template <class E>
KeyRow row(const ChoiceKey<E>& key) {
  std::vector<std::string_view> names;
  std::string_view fallback;
  for (const auto& named : key.values) {
    if (named.name.empty()) continue;
    names.push_back(named.name);
    if (key.fallback && *key.fallback == named.value) fallback = named.name;
  }
  return choice_row(key.name, names, fallback, key.usual, key.meaning);
}

/// The rows of keys of any types.
template <class... Keys>
std::vector<KeyRow> rows(const Keys&... keys) {
  return {row(keys)...};
}

/// "[motion.whirl]", "[[rock.layers]]", "top of the file".
std::string header_of(const KeyTable& table);

/// The tables for a terminal, one under the other.
std::string keys_as_text(std::span<const KeyTable> tables);

/// The tables in Markdown.
std::string keys_as_markdown(std::span<const KeyTable> tables);

/// The tables of this name and those inside them ("motion": also "motion.whirl"). Throws InputError
/// with the nearest name, or the command that lists them, when there is none.
std::vector<KeyTable> tables_named(std::span<const KeyTable> tables, const std::string& name,
                                   const std::string& listed_by = "tdbd keys");

}  // namespace tdbd
