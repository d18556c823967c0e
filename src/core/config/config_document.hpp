#pragma once

#include <toml++/toml.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tdbd {

/// A mistake of the input. Line 0: from --set.
struct ConfigProblem {
  long line = 0;
  std::string key;
  std::string found;
  std::string expected;

  auto operator<=>(const ConfigProblem&) const = default;
};

/// A value for the resolved file.
struct ResolvedValue {
  std::string toml;     ///< empty: not expressible in TOML (a default without limit)
  std::string comment;  ///< the unit
  std::string file;     ///< for a path: the file that it names; otherwise empty
  std::optional<double> quantity = std::nullopt;  ///< for a single quantity: its value in SI
};

/// The state that all Configs of one file share: the tree, what was read of it, and its problems.
/// Only config*.cpp include this file, and with it toml++.
struct ConfigDocument {
  std::string file;          ///< as given
  std::string folder;        ///< of the file, absolute
  bool is_resolved = false;  ///< begins with resolved_head
  toml::table root;
  std::set<std::string> overridden;             ///< keys set by overrides
  std::string origin = "--set";                 ///< of the overrides, for messages
  std::map<std::string, ResolvedValue> values;  ///< every key that was read
  std::set<std::string> tables;                 ///< every table that was read
  std::vector<ConfigProblem> problems;
  std::map<std::string, std::string> doubts;  ///< about values that were read, by key
  std::vector<std::string> other_mistakes;    ///< messages about files that this one names

  /// Returns the value at a dotted key ("layers[1].depth"), or null.
  const toml::node* find(const std::string& key) const;
  /// Returns the line of the key, or of the nearest enclosing table in the file; 0 for --set.
  long line_of(const std::string& key) const;
  void add_problem(const std::string& key, const std::string& found, const std::string& expected);
};

/// Parses the file. Throws InputError.
ConfigDocument read_document(const std::string& path);

/// Parses a text as if it were in a file at this path: messages name that file, and paths in the
/// text are relative to its folder. Throws InputError.
ConfigDocument parse_document(const std::string& text, const std::string& path);

/// Sets one "key=value" in the tree. Records a problem if it is malformed.
void apply_override(ConfigDocument& document, const std::string& assignment);

/// Describes a value for messages: "\"abc\"", "3", "a table".
std::string describe(const toml::node* node);

/// Returns the keys of the file that were not read, as problems that suggest the nearest known key.
std::vector<ConfigProblem> unknown_keys(const ConfigDocument& document);

/// Returns the part of a dotted key before or after its last dot.
std::string parent_key(const std::string& key);
std::string last_key(const std::string& key);

/// Joins names with commas: "a, b, c".
std::string joined(const std::vector<std::string>& names);

}  // namespace tdbd
