#pragma once

#include <toml++/toml.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace tdbd {

/// One mistake of the input. Line 0: it came from --set.
struct ConfigProblem {
  long line = 0;
  std::string key;
  std::string found;
  std::string expected;

  auto operator<=>(const ConfigProblem&) const = default;
};

/// A value as it goes into the resolved file.
struct ResolvedValue {
  std::string toml;     ///< empty: TOML cannot say it (a default without limit)
  std::string comment;  ///< the unit
  std::string file;     ///< of a path: the file that it names; empty otherwise
  std::optional<double> quantity = std::nullopt;  ///< of a single quantity: its value in SI
};

/// What all Configs of one file share: the tree, what was read of it, what was wrong with it.
/// Only config*.cpp include this file, and with it toml++.
struct ConfigDocument {
  std::string file;    ///< as given
  std::string folder;  ///< absolute, of the file
  toml::table root;
  std::set<std::string> overridden;             ///< keys given by overrides
  std::string origin = "--set";                 ///< of the overrides, for messages
  std::map<std::string, ResolvedValue> values;  ///< every key that was read
  std::set<std::string> tables;                 ///< every table that was asked for
  std::set<std::string> renamed;  ///< keys that the file gives by a former name: not missing
  std::vector<ConfigProblem> problems;
  std::vector<std::string> other_mistakes;  ///< messages about files that this one names

  /// The value at a dotted key ("layers[1].depth"), or null.
  const toml::node* find(const std::string& key) const;
  /// Line of the key, or of the nearest table around it that is in the file; 0 for --set.
  long line_of(const std::string& key) const;
  void add_problem(const std::string& key, const std::string& found, const std::string& expected);
};

/// Parses the file. Throws InputError.
ConfigDocument read_document(const std::string& path);

/// Parses a text that stands for a file of this path: messages name it, and paths in the text are
/// relative to its folder. Throws InputError.
ConfigDocument parse_document(const std::string& text, const std::string& path);

/// Sets one "key=value" in the tree; a malformed one becomes a problem.
void apply_override(ConfigDocument& document, const std::string& assignment);

/// A value in words, for messages: "\"abc\"", "3", "a table".
std::string describe(const toml::node* node);

/// Keys of the file that were never read, as problems with the nearest key that was.
std::vector<ConfigProblem> unknown_keys(const ConfigDocument& document);

/// The part of a dotted key before and after the last dot.
std::string parent_key(const std::string& key);
std::string last_key(const std::string& key);

/// "a, b, c".
std::string joined(const std::vector<std::string>& names);

}  // namespace tdbd
