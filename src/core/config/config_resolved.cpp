#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <utility>

#include "core/config/config.hpp"
#include "core/config/config_document.hpp"
#include "core/config/toml_text.hpp"
#include "core/hash.hpp"

namespace tdbd {
namespace {

/// One step of a dotted key: a name, and the index in an array of tables (-1: a plain table).
using Step = std::pair<std::string, long>;

/// Splits a key: "layers[2].grading" into {layers, 2}, {grading, -1}.
std::vector<Step> steps(const std::string& key) {
  if (key.empty()) return {};
  std::vector<Step> path = steps(parent_key(key));
  const std::string last = last_key(key);
  const std::size_t bracket = last.find('[');
  const long index = bracket == std::string::npos ? -1 : std::stol(last.substr(bracket + 1));
  path.emplace_back(last.substr(0, bracket), index);
  return path;
}

/// Returns "[[layers]]" or "[layers.grading]"; empty for the top of the file.
std::string header(const std::vector<Step>& path) {
  if (path.empty()) return "";
  std::string dotted;
  for (const Step& step : path) dotted += (dotted.empty() ? "" : ".") + step.first;
  return path.back().second < 0 ? fmt::format("\n[{}]\n", dotted)
                                : fmt::format("\n[[{}]]\n", dotted);
}

std::string line(const std::string& name, const ResolvedValue& value) {
  if (value.toml.empty()) return fmt::format("# {}: no limit\n", name);
  if (value.comment.empty()) return fmt::format("{} = {}\n", name, value.toml);
  return fmt::format("{} = {}  # {}\n", name, value.toml, value.comment);
}

std::string text_of(const ConfigDocument& document,
                    const std::map<std::string, ResolvedValue>& values) {
  // Ordered by path: an element's tables follow it before the next element starts.
  std::map<std::vector<Step>, std::string> groups;
  for (const std::string& key : document.tables)
    if (document.find(key) != nullptr && document.find(key)->is_table()) groups[steps(key)];
  for (const auto& [key, value] : values)
    groups[steps(parent_key(key))] += line(last_key(key), value);
  std::string out;
  for (const auto& [path, lines] : groups) out += header(path) + lines;
  return out;
}

std::string bytes_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

std::string Config::resolved() const { return text_of(*document_, document_->values); }

std::string Config::fingerprint() const {
  std::map<std::string, ResolvedValue> values = document_->values;
  for (auto& [key, value] : values)
    if (!value.file.empty()) value.toml = toml_string(fnv1a_hex(bytes_of(value.file)));
  return text_of(*document_, values);
}

}  // namespace tdbd
