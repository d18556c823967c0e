#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <sstream>
#include <utility>

#include "core/config/config.hpp"
#include "core/config/config_document.hpp"
#include "core/provenance.hpp"

namespace tdbd {
namespace {

std::string text_of(std::string_view text) { return std::string(text); }

Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// The last name of a key: "whirl" for "motion.whirl".
std::string_view last_part(const TableKey& key) { return key.name.substr(key.name.rfind('.') + 1); }

}  // namespace

double Config::read(const QuantityKey& key, std::optional<double> fallback) {
  return quantity(key, text_of(key.unit), fallback, key.range, key.usual);
}

Vec3 Config::read(const VectorKey& key) {
  return read(key, key.fallback ? std::optional(vector_of(*key.fallback)) : std::nullopt);
}

Vec3 Config::read(const VectorKey& key, const std::optional<Vec3>& fallback) {
  return vector(key, text_of(key.unit), fallback);
}

std::vector<double> Config::read(const ListKey& key, std::optional<std::vector<double>> fallback) {
  return list(key, text_of(key.unit), std::move(fallback), key.usual);
}

std::vector<std::pair<double, double>> Config::read(
    const PairsKey& key, std::optional<std::vector<std::pair<double, double>>> fallback) {
  return pairs(key, text_of(key.unit), std::move(fallback), key.usual);
}

Mat3 Config::read(const MatrixKey& key, const std::optional<Mat3>& fallback) {
  return matrix(key, text_of(key.unit), fallback);
}

std::vector<std::string> Config::read(const TextsKey& key,
                                      const std::optional<std::vector<std::string>>& fallback) {
  return texts(key, fallback);
}

long Config::read(const IntegerKey& key, std::optional<long> fallback) {
  return integer(key, fallback, key.lo, key.hi);
}

bool Config::read(const FlagKey& key, std::optional<bool> fallback) { return flag(key, fallback); }

std::string Config::read(const TextKey& key) {
  return text(key, key.fallback ? std::optional(text_of(*key.fallback)) : std::nullopt);
}

std::string Config::read(const PathKey& key) { return path(key, std::nullopt); }

std::string Config::read(const NameKey& key, const std::optional<std::string>& fallback) {
  std::vector<std::pair<std::string, std::string>> names;
  for (const std::string_view name : key.names()) names.emplace_back(text_of(name), text_of(name));
  return choice<std::string>(key, names, fallback);
}

Config Config::table(const TableKey& key) { return table(last_part(key)); }

std::vector<Config> Config::tables(const TableKey& key) { return tables(last_part(key)); }

bool Config::has(const TableKey& key) const { return has(last_part(key)); }

/// Whether to read the key. Records a mistake if it is given and refused.
bool FieldReader::reads(std::string_view name, Need need) {
  if (refusal_ && table_.has(name))
    table_.problem(name, text_of(refusal_->found), text_of(refusal_->expected));
  return !refusal_ && (need != Need::optional || table_.has(name));
}

void FieldReader::operator()(double& x, const QuantityKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(Vec3& x, const VectorKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(std::vector<double>& x, const ListKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(std::vector<std::pair<double, double>>& x, const PairsKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(Mat3& x, const MatrixKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(std::vector<std::string>& x, const TextsKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(long& x, const IntegerKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(bool& x, const FlagKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

void FieldReader::operator()(std::string& x, const TextKey& key) {
  if (reads(key, key.need)) x = table_.text(key, fallback(key.need, x));
}

void FieldReader::operator()(ConfigScalar& x, const ScalarKey& key) {
  if (reads(key.name, key.need)) x = table_.word(key, fallback(key.need, x));
}

void FieldReader::operator()(std::vector<ConfigScalar>& x, const ScalarsKey& key) {
  if (reads(key, key.need)) x = table_.words(key);
}

void FieldReader::path(std::string& x, const PathKey& key) {
  if (reads(key, key.need)) x = table_.path(key, fallback(key.need, x));
}

void FieldReader::name(std::string& x, const NameKey& key) {
  if (reads(key, key.need)) x = table_.read(key, fallback(key.need, x));
}

std::optional<std::size_t> FieldReader::choose(const NamedChoice& choice) {
  if (!reads(choice.name, choice.need)) return std::nullopt;
  std::vector<std::pair<std::string, std::size_t>> names;
  for (std::size_t i = 0; i < choice.names.size(); ++i) names.emplace_back(choice.names[i], i);
  const bool required = choice.need == Need::required;
  return table_.choice<std::size_t>(choice.name, names, required ? std::nullopt : choice.index);
}

namespace {

constexpr const char* a_word = "a text, a number, or true or false";

/// Returns nothing for a table or an array.
std::optional<ConfigScalar> word_of(const toml::node& node) {
  if (!node.is_string() && !node.is_number() && !node.is_boolean()) return std::nullopt;
  const auto text = node.as_string();
  return ConfigScalar{text != nullptr ? text->get() : describe(&node), describe(&node)};
}

/// Formats a value of any type as one line of TOML.
std::string one_line(const toml::node& node) {
  std::ostringstream out;
  if (const toml::array* array = node.as_array()) {
    const char* comma = "";
    out << "[";
    for (const toml::node& element : *array) {
      out << comma << one_line(element);
      comma = ", ";
    }
    out << "]";
    return out.str();
  }
  return describe(&node);
}

}  // namespace

ConfigScalar Config::word(std::string_view key, const std::optional<ConfigScalar>& fallback) {
  const std::string name = full(key);
  const toml::node* node = document_->find(name);
  if (node == nullptr) {
    if (!fallback)
      document_->add_problem(name, "nothing", fmt::format("{} (the key is required)", a_word));
    const ConfigScalar word = fallback.value_or(ConfigScalar{"", "\"\""});
    document_->values.try_emplace(name, ResolvedValue{word.toml, "", ""});
    return word;
  }
  const std::optional<ConfigScalar> word = word_of(*node);
  if (!word) document_->add_problem(name, describe(node), a_word);
  document_->values.try_emplace(name, ResolvedValue{word ? word->toml : "\"\"", "", ""});
  return word.value_or(ConfigScalar{"", "\"\""});
}

std::vector<ConfigScalar> Config::words(std::string_view key) {
  const std::string name = full(key);
  const toml::node* node = document_->find(name);
  std::vector<ConfigScalar> words;
  const toml::array* array = node == nullptr ? nullptr : node->as_array();
  if (array == nullptr || array->empty())
    document_->add_problem(name, array == nullptr ? describe(node) : "no value",
                           fmt::format("an array of at least one value, each {}", a_word));
  if (array != nullptr)
    for (const toml::node& element : *array) {
      const std::optional<ConfigScalar> word = word_of(element);
      if (!word) document_->add_problem(name, describe(&element), a_word);
      words.push_back(word.value_or(ConfigScalar{"", "\"\""}));
    }
  document_->values.try_emplace(name,
                                ResolvedValue{node == nullptr ? "[]" : one_line(*node), "", ""});
  return words;
}

std::vector<std::string> Config::assignments() {
  std::vector<std::string> all;
  for (const std::string& name : given()) {
    const toml::node* node = document_->find(full(name));
    if (node == nullptr) continue;
    if (node->is_table()) {
      for (const std::string& below : table(name).assignments()) all.push_back(name + "." + below);
      continue;
    }
    const std::string value = one_line(*node);
    document_->values.try_emplace(full(name), ResolvedValue{value, "", ""});
    all.push_back(name + "=" + value);
  }
  return all;
}

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
