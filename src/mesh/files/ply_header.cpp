#include "mesh/files/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.hpp"
#include "mesh/files/text_cursor.hpp"

namespace tdbd::mesh {
namespace {

constexpr std::array ply_types = {
    std::pair{"char", PlyType::int8},      std::pair{"int8", PlyType::int8},
    std::pair{"uchar", PlyType::uint8},    std::pair{"uint8", PlyType::uint8},
    std::pair{"short", PlyType::int16},    std::pair{"int16", PlyType::int16},
    std::pair{"ushort", PlyType::uint16},  std::pair{"uint16", PlyType::uint16},
    std::pair{"int", PlyType::int32},      std::pair{"int32", PlyType::int32},
    std::pair{"uint", PlyType::uint32},    std::pair{"uint32", PlyType::uint32},
    std::pair{"float", PlyType::float32},  std::pair{"float32", PlyType::float32},
    std::pair{"double", PlyType::float64}, std::pair{"float64", PlyType::float64}};
constexpr std::array ply_formats = {
    std::pair{"ascii", PlyFormat::ascii},
    std::pair{"binary_little_endian", PlyFormat::binary_little_endian},
    std::pair{"binary_big_endian", PlyFormat::binary_big_endian}};

/// Returns the value of the next word of this line, which must be one of the names.
template <class Names>
auto named(TextCursor& in, const Names& names, std::string_view expected) {
  const std::string_view word = in.word(expected);
  for (const auto& [name, value] : names)
    if (word == name) return value;
  in.fail(fmt::format("'{}'", word), expected);
}

PlyType whole_type(TextCursor& in) {
  const PlyType type = named(in, ply_types, "the type of a list's length");
  if (type == PlyType::float32 || type == PlyType::float64)
    in.fail("a list with a length that is no whole number", "a type such as uchar");
  return type;
}

PlyProperty read_property(TextCursor& in) {
  PlyProperty p;
  if (in.word_on_this_line() == "list") {
    in.word("list");
    p.count = whole_type(in);
  }
  p.type = named(in, ply_types, "a type such as double");
  p.name = in.word("the name of a property");
  return p;
}

/// Smallest size of a record, bytes. In a text file a value takes at least a digit and a separator.
std::size_t least_record(const PlyElement& e, PlyFormat format) {
  std::size_t bytes = 0;
  for (const PlyProperty& p : e.properties)
    bytes += format == PlyFormat::ascii ? 2 : byte_size(p.count.value_or(p.type));
  return bytes;
}

void demand_records(const PlyHeader& header, std::size_t bytes, const std::string& path) {
  for (const PlyElement& e : header.elements) {
    const std::size_t least = least_record(e, header.format);
    const std::size_t most = least == 0 ? 0 : (bytes + 1) / least;
    if (e.count > most)
      throw InputError(
          fmt::format("{}:{}: element {}: found {} records, expected at most {}: {} bytes follow "
                      "the header",
                      path, e.line, e.name, e.count, most, bytes));
  }
}

/// Whether a statement of the header was the last one.
enum class Statement { one_of_many, last };
Statement read_statement(TextCursor& in, long line, PlyHeader& header) {
  constexpr auto expected = "element, property, comment, obj_info or end_header";
  const std::string_view word = in.word(expected);
  if (word == "end_header") return Statement::last;
  if (word == "element") {
    PlyElement& e = header.elements.emplace_back();
    e.name = in.word("the name of an element");
    e.count = static_cast<std::size_t>(in.whole("the number of records"));
    e.line = line;
  } else if (word == "property") {
    if (header.elements.empty()) in.fail("a property of no element", "an element before it");
    header.elements.back().properties.push_back(read_property(in));
  } else if (word != "comment" && word != "obj_info") {
    in.fail(fmt::format("'{}'", word), expected);
  }
  return Statement::one_of_many;
}

}  // namespace

std::size_t byte_size(PlyType type) {
  constexpr std::array<std::size_t, 8> sizes = {1, 1, 2, 2, 4, 4, 4, 8};
  return sizes[static_cast<std::size_t>(type)];
}

PlyHeader read_ply_header(std::string_view bytes, const std::string& path) {
  PlyHeader header;
  const auto next_line = [&] {  // one line at a time: a statement ends with its line
    ++header.lines;
    const std::size_t end = bytes.find('\n', header.size);
    const std::string_view line =
        bytes.substr(header.size, end == std::string_view::npos ? end : end - header.size);
    header.size = std::min(header.size + line.size() + 1, bytes.size());
    return TextCursor(line, path, header.lines);
  };
  if (TextCursor first = next_line(); first.word("'ply'") != "ply")
    first.fail("another word", "'ply'");
  TextCursor second = next_line();
  if (second.word("'format'") != "format") second.fail("another word", "'format'");
  header.format = named(second, ply_formats, "ascii, binary_little_endian or binary_big_endian");
  for (bool is_last = false; !is_last;) {
    if (header.size == bytes.size())
      TextCursor({}, path, header.lines).fail("the end of the file", "end_header");
    TextCursor line = next_line();
    if (line.word_on_this_line().empty()) continue;
    is_last = read_statement(line, header.lines, header) == Statement::last;
  }
  demand_records(header, bytes.size() - header.size, path);
  return header;
}

}  // namespace tdbd::mesh
