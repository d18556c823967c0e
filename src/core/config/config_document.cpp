#include "core/config/config_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <optional>
#include <sstream>

#include "core/config/config.hpp"
#include "core/config/number_doubts.hpp"
#include "core/error.hpp"
#include "core/read_file.hpp"
#include "core/text.hpp"

namespace tdbd {
namespace {

/// "8.5", "true" and "[1, 2]" are TOML values; anything else is a bare string.
void insert_value(toml::table& table, const std::string& name, const std::string& text) {
  try {
    toml::table parsed = toml::parse("v = " + text);
    if (parsed.size() == 1) {
      table.insert_or_assign(name, std::move(*parsed.get("v")));
      return;
    }
  } catch (const toml::parse_error&) {  // not TOML: a bare string
  }
  table.insert_or_assign(name, text);
}

/// The key that contains a key: "a.b" for "a.b[2]", "a" for "a.b", the file ("") for "a". Always
/// shorter, because a name may end with a bracket without an opening one.
std::string enclosing_key(const std::string& key) {
  const std::size_t open = key.back() == ']' ? key.rfind('[') : std::string::npos;
  return open == std::string::npos ? parent_key(key) : key.substr(0, open);
}

/// Returns the table of a dotted key, and creates the missing ones on the way. Null if one of them
/// is a value.
toml::table* table_at(toml::table& root, const std::string& key) {
  if (key.empty()) return &root;
  if (toml::node* node = toml::at_path(root, key).node()) return node->as_table();
  toml::table* parent = table_at(root, parent_key(key));
  if (parent == nullptr || key.back() == ']') return nullptr;
  return parent->insert_or_assign(last_key(key), toml::table{}).first->second.as_table();
}

/// The names of the values and tables directly in a table that the program knows.
std::vector<std::string> known_names(const ConfigDocument& document, const std::string& table) {
  const std::string start = table.empty() ? "" : table + ".";
  std::set<std::string> names;
  const auto add = [&](const std::string& key) {
    if (key.size() > start.size() && key.compare(0, start.size(), start) == 0)
      names.insert(key.substr(start.size(), key.find_first_of(".[", start.size()) - start.size()));
  };
  for (const auto& [key, value] : document.values) add(key);
  for (const std::string& key : document.tables) add(key);
  return {names.begin(), names.end()};
}

/// Returns "one of a, b" for the innermost known table around a key. If the key is not directly in
/// that table, also the name that these replace.
std::string known_around(const ConfigDocument& document, const std::string& key) {
  std::string place = key;
  while (place.find_first_of(".[") != std::string::npos &&
         known_names(document, enclosing_key(place)).empty())
    place = enclosing_key(place);
  const std::vector<std::string> names = known_names(document, parent_key(place));
  if (names.empty()) return "no key here";
  return place == key ? "one of " + joined(names)
                      : fmt::format("one of {} in place of {}", joined(names), last_key(place));
}

/// Suggestions take time, and are not useful for more than so many mistakes.
constexpr std::size_t most_suggestions = 1000;

/// Suggests what an unknown key may mean: a similar name in its table, a similar key elsewhere, or
/// all names of its table. `earlier`: number of unknown keys before it.
std::string suggestion(const ConfigDocument& document, const std::string& key,
                       std::size_t earlier) {
  if (earlier >= most_suggestions) return "a known one";
  const std::vector<std::string> siblings = known_names(document, parent_key(key));
  if (const auto name = nearest_name(last_key(key), siblings)) return *name;
  std::vector<std::string> everywhere;
  for (const auto& [known, value] : document.values) everywhere.push_back(known);
  if (const auto other = nearest_name(key, everywhere)) return *other;
  return known_around(document, key);
}

/// A table is known if it, or any key in it, was read.
bool is_known_table(const ConfigDocument& document, const std::string& key) {
  const auto inside = document.values.lower_bound(key + ".");
  return document.tables.count(key) != 0 ||
         (inside != document.values.end() && inside->first.rfind(key + ".", 0) == 0);
}

/// Whether a value already has a problem, for example a wrong type. Its contents are then not
/// reported.
bool has_problem(const ConfigDocument& document, const std::string& key) {
  return std::any_of(document.problems.begin(), document.problems.end(),
                     [&key](const ConfigProblem& p) { return p.key == key; });
}

/// Searches depth first. A value that was not read is unknown, and so is an empty table that was
/// not read.
void collect_unknown(const ConfigDocument& document, const toml::node& node, const std::string& key,
                     std::vector<ConfigProblem>& unknown) {
  const toml::table* table = node.as_table();
  const toml::array* array = node.as_array();
  const bool is_tables =
      array != nullptr && !array->empty() && array->is_homogeneous<toml::table>();
  const bool is_reachable = document.find(key) == &node;  // false if a name contains a dot
  if (is_reachable && (document.values.count(key) != 0 || has_problem(document, key))) return;
  if (table != nullptr && !table->empty()) {
    for (const auto& [name, child] : *table) {
      const std::string dot = key.empty() ? "" : ".";
      const std::string_view shown = name.str().empty() ? "\"\"" : name.str();
      collect_unknown(document, child, fmt::format("{}{}{}", key, dot, shown), unknown);
    }
  } else if (is_tables) {
    for (std::size_t i = 0; i < array->size(); ++i)
      collect_unknown(document, (*array)[i], fmt::format("{}[{}]", key, i), unknown);
  } else if (!key.empty() && !(is_reachable && is_known_table(document, key))) {
    unknown.push_back(
        {document.line_of(key), key, "an unknown key", suggestion(document, key, unknown.size())});
  }
}

/// The shortest digits that read back to the same number, with a decimal point or exponent.
std::string decimal(double x) {
  const std::string text = fmt::format("{}", x);
  return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

}  // namespace

std::string parent_key(const std::string& key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? "" : key.substr(0, dot);
}

std::string last_key(const std::string& key) {
  const std::size_t dot = key.rfind('.');
  return dot == std::string::npos ? key : key.substr(dot + 1);
}

const toml::node* ConfigDocument::find(const std::string& key) const {
  return key.empty() ? &root : toml::at_path(root, key).node();
}

long ConfigDocument::line_of(const std::string& key) const {
  for (std::string k = key; !k.empty(); k = enclosing_key(k))
    if (overridden.count(k) != 0) return 0;
  for (std::string k = key; !k.empty(); k = enclosing_key(k))
    if (const toml::node* node = find(k); node != nullptr && node->source().begin.line != 0)
      return static_cast<long>(node->source().begin.line);
  return 1;
}

void ConfigDocument::add_problem(const std::string& key, const std::string& found,
                                 const std::string& expected) {
  problems.push_back({line_of(key), key, found, expected});
}

namespace {

/// The parser creates a table for every name of a dotted key, and functions that traverse a
/// document recurse as deep.
constexpr int most_names = 32, most_tables = 256;

[[noreturn]] void refuse_deep(const std::string& path, long line, const char* found, int most) {
  throw InputError(fmt::format("{}:{}: found {}, expected at most {}", path, line, found, most));
}

/// Throws InputError at the first key with too many names.
void demand_short_keys(const std::string& text, const std::string& path) {
  int names = 1;
  long line = 1;
  char quote = 0;
  bool in_comment = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') {
      ++line;
      names = 1;
      quote = 0;
      in_comment = false;
    } else if (in_comment) {
      continue;
    } else if (quote != 0) {
      if (c == '\\' && quote == '"') ++i;
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '=' || c == ',' || c == '[' || c == '{') {
      names = 1;
    } else if (c == '.' && ++names > most_names) {
      refuse_deep(path, line, "a key of more names", most_names);
    }
    in_comment = quote == 0 && c == '#';
  }
}

/// Throws InputError at the first value that is nested too deeply in tables and arrays.
void demand_shallow(const toml::node& node, const std::string& path, int depth) {
  if (depth > most_tables)
    refuse_deep(path, static_cast<long>(node.source().begin.line), "a value in more tables",
                most_tables);
  if (const toml::table* table = node.as_table())
    for (const auto& [name, child] : *table) demand_shallow(child, path, depth + 1);
  if (const toml::array* array = node.as_array())
    for (const toml::node& child : *array) demand_shallow(child, path, depth + 1);
}

/// Whether a dotted key lacks a name: at its start, at its end, or between two dots.
bool has_empty_name(const std::string& key) {
  return key.empty() || key.front() == '.' || key.back() == '.' ||
         key.find("..") != std::string::npos;
}

}  // namespace

namespace {

/// What a syntax error in this line probably is: a text without quotes, or with one of them.
std::string syntax_hint(const std::string& text, long line) {
  constexpr std::size_t longest = 200;
  std::istringstream in(text);
  std::string found;
  for (long k = 0; k < line; ++k) std::getline(in, found);
  const std::size_t equals = found.find('=');
  if (equals == std::string::npos || found.size() > longest) return "";
  const std::string key(trimmed(found.substr(0, equals))), value(trimmed(found.substr(equals + 1)));
  const bool has_letter = std::ranges::any_of(
      value, [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; });
  if (std::ranges::count(value, '"') == 1) return "; a text has a quote at both ends";
  if (!has_letter || value.find_first_of("\"'#[{") != std::string::npos) return "";
  return fmt::format("; texts and values with a unit have quotes: {} = \"{}\"", key, value);
}

}  // namespace

ConfigDocument parse_document(const std::string& text, const std::string& path) {
  demand_short_keys(text, path);
  ConfigDocument document;
  document.file = path;
  document.folder = std::filesystem::absolute(path).parent_path().string();
  document.is_resolved = text.starts_with(resolved_head);
  try {
    document.root = toml::parse(text, path);
  } catch (const toml::parse_error& error) {
    const toml::source_position at = error.source().begin;
    throw InputError(fmt::format("{}:{}:{}: found a syntax error, expected TOML: {}{}", path,
                                 at.line, at.column, error.description(),
                                 syntax_hint(text, static_cast<long>(at.line))));
  }
  demand_shallow(document.root, path, 0);
  return document;
}

ConfigDocument read_document(const std::string& path) {
  return parse_document(read_text_file(path, "a TOML file"), path);
}

void apply_override(ConfigDocument& document, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string key = assignment.substr(0, equals);
  if (equals == std::string::npos || has_empty_name(key)) {
    document.problems.push_back({0, assignment, "no key=value", "key=value"});
    return;
  }
  if (std::count(key.begin(), key.end(), '.') >= most_names) {
    document.problems.push_back(
        {0, key, "a key of more names", fmt::format("at most {}", most_names)});
    return;
  }
  document.overridden.insert(key);
  toml::table* table = table_at(document.root, parent_key(key));
  if (table == nullptr) {
    document.add_problem(key, "a value where its table should be", "a key inside a table");
    return;
  }
  insert_value(*table, last_key(key), assignment.substr(equals + 1));
}

std::string joined(const std::vector<std::string>& names) {
  std::string all;
  for (const std::string& name : names) all += (all.empty() ? "" : ", ") + name;
  return all;
}

std::string describe(const toml::node* node) {
  if (node == nullptr) return "nothing";
  if (node->is_table()) return "a table";
  if (const toml::array* array = node->as_array())
    return fmt::format("an array of {}", array->size());
  if (const auto text = node->as_string()) return toml_string(text->get());
  if (const auto number = node->as_floating_point()) return decimal(number->get());
  std::ostringstream out;
  node->visit([&out](const auto& value) {
    if constexpr (toml::is_value<decltype(value)>) out << value;
  });
  return out.str();
}

std::vector<ConfigProblem> unknown_keys(const ConfigDocument& document) {
  std::vector<ConfigProblem> unknown;
  collect_unknown(document, document.root, "", unknown);
  return unknown;
}

}  // namespace tdbd
