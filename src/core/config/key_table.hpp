#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/config/field.hpp"

namespace tdbd {

/// The description of a declared key of any type.
struct KeyRow {
  std::string name;
  std::string kind;      ///< "m", "three rad/s", "whole number", "one of", ...
  std::string fallback;  ///< as in a file ("0.03 m"), in words ("one turn of the bit"), "required"
  std::string allowed;   ///< "> 0", "steady, whirl, ..."; empty: any value of the kind
  std::string meaning;
  std::string toml = {};  ///< a fixed fallback as written to the resolved file; empty: none
};

/// A table with its keys, for `tdbd keys` and KEYS.md.
struct KeyTable {
  std::string command;  ///< that reads it: "run", "rotate"
  std::string name;     ///< dotted, from the top of the file; empty: the top of the file
  std::string meaning;
  Repeats repeats = Repeats::no;
  std::vector<KeyRow> rows;
};

/// Makes a table with these rows.
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
KeyRow row(const ScalarKey& key);
KeyRow row(const ScalarsKey& key);
KeyRow row(const AnyKey& key);

/// Makes the row of a choice. `fallback`: the name of the fallback, or empty.
KeyRow choice_row(std::string_view name, const std::vector<std::string_view>& names,
                  std::string_view fallback, std::string_view computed_default,
                  std::string_view meaning);

template <class E>
KeyRow row(const ChoiceKey<E>& key) {
  std::vector<std::string_view> names;
  std::string_view fallback;
  for (const auto& named : key.values) {
    if (named.name.empty()) continue;
    names.push_back(named.name);
    if (key.fallback && *key.fallback == named.value) fallback = named.name;
  }
  return choice_row(key.name, names, fallback, key.computed_default, key.meaning);
}

/// Makes the rows of keys of any types.
template <class... Keys>
std::vector<KeyRow> rows(const Keys&... keys) {
  return {row(keys)...};
}

/// Lists the fields of a settings struct. Their initial values are the defaults.
class FieldLister final : public FieldVisitor {
 public:
  std::vector<KeyRow> rows;

  using FieldVisitor::operator();
  void operator()(double& x, const QuantityKey& key) override;
  void operator()(Vec3& x, const VectorKey& key) override;
  void operator()(std::vector<double>& x, const ListKey& key) override;
  void operator()(std::vector<std::pair<double, double>>& x, const PairsKey& key) override;
  void operator()(Mat3& x, const MatrixKey& key) override;
  void operator()(std::vector<std::string>& x, const TextsKey& key) override;
  void operator()(long& x, const IntegerKey& key) override;
  void operator()(bool& x, const FlagKey& key) override;
  void operator()(std::string& x, const TextKey& key) override;
  void operator()(ConfigScalar& x, const ScalarKey& key) override;
  void operator()(std::vector<ConfigScalar>& x, const ScalarsKey& key) override;
  void path(std::string& x, const PathKey& key) override;
  void name(std::string& x, const NameKey& key) override;
  void any(const AnyKey& key) override { rows.push_back(row(key)); }
  void any(const QuantityKey& key) override { rows.push_back(row(key)); }
  bool when(bool) override { return true; }
  bool gives(std::string_view) override { return false; }

 protected:
  std::optional<std::size_t> choose(const NamedChoice& choice) override;
  std::optional<Refusal> refuse(std::optional<Refusal>) override { return std::nullopt; }
};

/// Lists the keys of one or more settings structs that share a table.
template <class... S>
KeyTable table_of(const std::string& command, const TableKey& key) {
  FieldLister lister;
  const auto list = [&](auto settings) { settings.visit(lister); };
  (list(S{}), ...);
  return key_table(command, key, std::move(lister.rows));
}

/// Lists the tables of settings structs, each under its own name.
template <class... S>
std::vector<KeyTable> tables_of(const std::string& command) {
  return {table_of<S>(command, S::table)...};
}

/// Returns "[motion.whirl]", "[[rock.layers]]" or "top of the file".
std::string header_of(const KeyTable& table);

/// Formats the tables for a terminal.
std::string keys_as_text(std::span<const KeyTable> tables);

/// Formats the tables in Markdown.
std::string keys_as_markdown(std::span<const KeyTable> tables);

/// Returns the tables of this name and those inside them ("motion": also "motion.whirl"). If there
/// are none, throws InputError with the nearest name or the command that lists them.
std::vector<KeyTable> tables_named(std::span<const KeyTable> tables, const std::string& name,
                                   const std::string& listed_by = "tdbd keys");

}  // namespace tdbd
