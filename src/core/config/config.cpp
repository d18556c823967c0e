#include "core/config/config.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <sstream>

#include "core/config/config_document.hpp"
#include "core/error.hpp"

namespace tdbd {
namespace {

std::string place_of(const ConfigDocument& document, long line, const std::string& key) {
  return line == 0 ? fmt::format("{}: {}", document.origin, key)
                   : fmt::format("{}:{}: {}", document.file, line, key);
}

std::string message(const ConfigDocument& document, const ConfigProblem& p) {
  return fmt::format("{}: found {}, expected {}", place_of(document, p.line, p.key), p.found,
                     p.expected);
}

/// Messages are shown as C strings, which end at a zero byte.
std::string shown(const std::string& text) {
  std::string all;
  for (const char c : text)
    if (c == '\0')
      all += "\\u0000";
    else
      all += c;
  return all;
}

/// Throws with one line for each problem, sorted. Mistakes of other files follow.
void throw_if_any(const ConfigDocument& document, std::vector<ConfigProblem> problems) {
  if (problems.empty() && document.other_mistakes.empty()) return;
  std::sort(problems.begin(), problems.end());
  problems.erase(std::unique(problems.begin(), problems.end()), problems.end());
  std::string lines;
  const auto add = [&lines](const std::string& text) {
    if (!lines.empty()) lines += '\n';
    lines += text;
  };
  for (const ConfigProblem& p : problems) add(message(document, p));
  for (const std::string& mistake : document.other_mistakes) add(mistake);
  throw InputError(shown(lines));
}

}  // namespace

Config::Config(std::shared_ptr<ConfigDocument> document, std::string prefix)
    : document_(std::move(document)), prefix_(std::move(prefix)) {}

Config Config::read_file(const std::string& path, const std::vector<std::string>& overrides,
                         const std::string& origin) {
  auto document = std::make_shared<ConfigDocument>(read_document(path));
  document->origin = origin;
  for (const std::string& assignment : overrides) apply_override(*document, assignment);
  return {std::move(document), ""};
}

Config Config::read_text(const std::string& text, const std::string& path) {
  return {std::make_shared<ConfigDocument>(parse_document(text, path)), ""};
}

std::vector<std::string> Config::given() const {
  const toml::node* node = prefix_.empty() ? &document_->root : document_->find(prefix_);
  std::vector<std::string> names;
  if (node == nullptr || !node->is_table()) return names;
  for (const auto& [name, value] : *node->as_table()) names.emplace_back(name.str());
  return names;  // sorted, like the table
}

std::string Config::full(std::string_view key) const {
  if (key.empty()) return prefix_;
  return prefix_.empty() ? std::string(key) : fmt::format("{}.{}", prefix_, key);
}

bool Config::has(std::string_view key) const { return document_->find(full(key)) != nullptr; }

bool Config::is_text(std::string_view key) const {
  const toml::node* node = document_->find(full(key));
  return node != nullptr && node->is_string();
}

Config Config::table(std::string_view key) {
  const std::string name = full(key);
  const toml::node* node = document_->find(name);
  if (node != nullptr && !node->is_table()) document_->add_problem(name, describe(node), "a table");
  document_->tables.insert(name);
  return {document_, name};
}

std::vector<Config> Config::tables(std::string_view key) {
  const std::string name = full(key);
  std::vector<Config> elements;
  document_->tables.insert(name);
  const toml::node* node = document_->find(name);
  if (node == nullptr) return elements;
  const toml::array* array = node->as_array();
  if (array == nullptr || (!array->empty() && !array->is_homogeneous<toml::table>())) {
    document_->add_problem(name, describe(node), fmt::format("an array of tables, [[{}]]", name));
    return elements;
  }
  for (std::size_t i = 0; i < array->size(); ++i)
    elements.push_back(table(fmt::format("{}[{}]", key, i)));
  return elements;
}

void Config::problem(std::string_view key, const std::string& found, const std::string& expected) {
  const std::string name = full(key);
  const auto same = [&](const ConfigProblem& p) { return p.key == name; };
  if (std::none_of(document_->problems.begin(), document_->problems.end(), same))
    document_->add_problem(name, found, expected);
}

std::string Config::place(std::string_view key) const {
  const std::string name = full(key);
  return place_of(*document_, document_->line_of(name), name);
}

void Config::other_file(const std::string& message) {
  document_->other_mistakes.push_back(message);
}

std::size_t Config::problem_count() const {
  return document_->problems.size() + document_->other_mistakes.size();
}

void Config::doubt(const std::string& key, const std::string& text) {
  document_->doubts.try_emplace(full(key), text);
}

std::vector<ConfigDoubt> Config::doubts() const {
  std::vector<ConfigDoubt> doubts;
  for (const auto& [key, text] : document_->doubts)
    doubts.push_back({place_of(*document_, document_->line_of(key), key), key, text});
  return doubts;
}

std::map<std::string, double> Config::quantities() const {
  std::map<std::string, double> quantities;
  for (const auto& [key, value] : document_->values)
    if (value.quantity) quantities[key] = *value.quantity;
  return quantities;
}

std::vector<std::string> Config::files() const {
  std::vector<std::string> files{document_->file};
  for (const auto& [key, value] : document_->values)
    if (!value.file.empty()) files.push_back(value.file);
  return files;
}

void Config::finish() const {
  std::vector<ConfigProblem> problems = document_->problems;
  const std::vector<ConfigProblem> unknown = unknown_keys(*document_);
  problems.insert(problems.end(), unknown.begin(), unknown.end());
  throw_if_any(*document_, std::move(problems));
}

void Config::finish_before(const std::string& later) const {
  std::vector<ConfigProblem> problems = document_->problems;
  const std::string inside = later + ".";
  for (const ConfigProblem& p : unknown_keys(*document_))
    if (p.key != later && !p.key.starts_with(inside)) problems.push_back(p);
  throw_if_any(*document_, std::move(problems));
}

void Config::stop_at_problems() const { throw_if_any(*document_, document_->problems); }

std::string toml_string(std::string_view text) {
  std::ostringstream out;
  out << toml::toml_formatter{toml::array{text}, toml::format_flags::none};
  const std::string array = out.str();  // [ "text" ]
  const std::size_t first = array.find('"');
  return array.substr(first, array.rfind('"') + 1 - first);
}

std::string toml_texts(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + toml_string(text);
  return "[" + list + "]";
}

std::string toml_vector(const Vec3& v) {
  if (!v.allFinite()) return "";
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

}  // namespace tdbd
