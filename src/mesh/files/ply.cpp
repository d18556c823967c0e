#include "mesh/files/ply.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include "core/error.hpp"
#include "core/simd.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/text_reader.hpp"

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

void check_record_counts(const PlyHeader& header, std::size_t bytes, const std::string& path) {
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

/// Which statement of the header was read.
enum class Statement { format, last, other };
Statement read_statement(TextCursor& in, long line, PlyHeader& header) {
  constexpr auto expected = "format, element, property, comment, obj_info or end_header";
  const std::string_view word = in.word(expected);
  if (word == "end_header") return Statement::last;
  if (word == "format") {
    header.format = named(in, ply_formats, "ascii, binary_little_endian or binary_big_endian");
    return Statement::format;
  }
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
  return Statement::other;
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
  bool has_format = false;
  for (Statement found = Statement::other; found != Statement::last;) {
    if (header.size == bytes.size())
      TextCursor({}, path, header.lines).fail("the end of the file", "end_header");
    TextCursor line = next_line();
    if (line.word_on_this_line().empty()) continue;
    found = read_statement(line, header.lines, header);
    has_format = has_format || found == Statement::format;
    if (found == Statement::last && !has_format) line.fail("no format", "'format ascii 1.0' above");
  }
  check_record_counts(header, bytes.size() - header.size, path);
  return header;
}

namespace {

static_assert(std::endian::native == std::endian::little, "records are written as they lie");

static_assert(sizeof(Triangle) == 3 * sizeof(std::int32_t));

/// Writes facets as the number of corners in one byte and the corners, some thousands at a time.
void write_facets(std::ostream& out, const std::vector<Triangle>& triangles) {
  constexpr std::size_t at_once = 4096;
  std::string some;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    some += '\3';
    some.append(reinterpret_cast<const char*>(&triangles[i]), sizeof(Triangle));
    if ((i + 1) % at_once != 0 && i + 1 < triangles.size()) continue;
    out.write(some.data(), static_cast<std::streamsize>(some.size()));
    some.clear();
  }
}

}  // namespace

void write_ply(std::ostream& out, const TriangleMesh& m, const std::vector<std::string>& comments) {
  out << "ply\nformat binary_little_endian 1.0\n";
  for (const std::string& comment : comments) out << "comment " << comment << '\n';
  out << fmt::format(
      "element vertex {}\nproperty double x\n"
      "property double y\nproperty double z\nelement face {}\n"
      "property list uchar int vertex_indices\nend_header\n",
      m.positions.size(), m.triangles.size());
  out.write(reinterpret_cast<const char*>(m.positions.data()),
            static_cast<std::streamsize>(m.positions.size() * sizeof(Vec3)));
  write_facets(out, m.triangles);
}

namespace {

bool is_whole(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

/// Reads the values of a text or binary file. Each value is converted to double.
class PlyValues {
 public:
  PlyValues(std::string_view records, const std::string& path, const PlyHeader& header)
      : text_(records, path, header.lines + 1),
        bytes_(records),
        path_(path),
        size_(records.size()),
        format_(header.format) {}

  double value(PlyType type) {
    constexpr std::array readers = {&PlyValues::next<std::int8_t>,  &PlyValues::next<std::uint8_t>,
                                    &PlyValues::next<std::int16_t>, &PlyValues::next<std::uint16_t>,
                                    &PlyValues::next<std::int32_t>, &PlyValues::next<std::uint32_t>,
                                    &PlyValues::next<Single>,       &PlyValues::next<double>};
    if (!is_text()) return (this->*readers[static_cast<std::size_t>(type)])();
    const double x = text_.number();
    if (is_whole(type) && x != std::floor(x)) fail(fmt::format("'{}'", x), "a whole number");
    return type == PlyType::float32 ? static_cast<double>(static_cast<Single>(x)) : x;
  }
  /// Skips a value, which may be anything in a text file.
  void skip(PlyType type) {
    if (is_text())
      text_.word("a value");
    else
      value(type);
  }
  /// Upper bound on the length of a list.
  std::size_t most(PlyType type) const {
    return is_text() ? text_.left() : bytes_.size() / byte_size(type);
  }
  [[noreturn]] void fail(const std::string& found, const char* expected) const {
    if (is_text()) text_.fail(found, expected);
    throw InputError(fmt::format("{}: byte {} of {} after the header: found {}, expected {}", path_,
                                 size_ - bytes_.size(), size_, found, expected));
  }

 private:
  bool is_text() const { return format_ == PlyFormat::ascii; }

  template <class Number>
  double next() {
    std::array<char, sizeof(Number)> raw;
    if (bytes_.size() < raw.size()) fail("the end of the file", "a number");
    std::copy_n(bytes_.begin(), raw.size(), raw.begin());
    bytes_.remove_prefix(raw.size());
    if (format_ == PlyFormat::binary_big_endian) std::reverse(raw.begin(), raw.end());
    return static_cast<double>(std::bit_cast<Number>(raw));
  }

  TextCursor text_;
  std::string_view bytes_;
  const std::string& path_;
  std::size_t size_;
  PlyFormat format_;
};

/// What a property is used for.
enum class Use { x, y, z, corners, ignored };

Use use_of(const PlyElement& e, const PlyProperty& p) {
  if (e.name == "vertex" && !p.count)
    return p.name == "x" ? Use::x : p.name == "y" ? Use::y : p.name == "z" ? Use::z : Use::ignored;
  const bool is_corners = p.name == "vertex_indices" || p.name == "vertex_index";
  return e.name == "face" && p.count && is_corners ? Use::corners : Use::ignored;
}

/// Returns the use of each property of an element. Throws InputError unless a vertex has three
/// coordinates and a face has corners, each exactly once.
std::vector<Use> uses_of(const PlyElement& e, const std::string& path) {
  std::vector<Use> uses;
  uses.reserve(e.properties.size());
  for (const PlyProperty& p : e.properties) uses.push_back(use_of(e, p));
  const auto demand = [&](Use use, const char* name) {
    if (const auto n = std::count(uses.begin(), uses.end(), use); n != 1)
      throw InputError(fmt::format("{}:{}: element {}: found {} properties {}, expected one", path,
                                   e.line, e.name, n, name));
  };
  if (e.name == "vertex")
    for (const auto& [use, name] : {std::pair{Use::x, "x"}, {Use::y, "y"}, {Use::z, "z"}})
      demand(use, name);
  if (e.name == "face") demand(Use::corners, "'list vertex_indices'");
  return uses;
}

int corner_of(const PlyValues& in, double x) {
  if (!(x >= 0.0 && x <= std::numeric_limits<int>::max() && x == std::floor(x)))
    in.fail(fmt::format("{}", x), "the number of a vertex, 0 or more");
  return static_cast<int>(x);
}

/// Reads the length of a list with elements of type `type`.
std::size_t length_of(PlyValues& in, PlyType count, PlyType type) {
  const double n = in.value(count);
  if (!(n >= 0.0 && n <= static_cast<double>(in.most(type))))
    in.fail(fmt::format("a list of {}", n), "one that fits into the rest of the file");
  return static_cast<std::size_t>(n);
}

void read_value(PlyValues& in, const PlyProperty& p, Use use, Vec3& place,
                std::vector<int>& polygon) {
  if (!p.count && use == Use::ignored) return in.skip(p.type);
  if (!p.count) {
    place[static_cast<Eigen::Index>(use)] = in.value(p.type);
    return;
  }
  const std::size_t n = length_of(in, *p.count, p.type);
  if (use == Use::corners && n < 3)
    in.fail(fmt::format("a polygon with {} corners", n), "three or more");
  if (use == Use::corners) polygon.reserve(n);
  for (std::size_t k = 0; k < n; ++k)
    if (use == Use::corners)
      polygon.push_back(corner_of(in, in.value(p.type)));
    else
      in.skip(p.type);
}

void read_element(PlyValues& in, const PlyElement& e, const std::vector<Use>& uses,
                  FacetFile& file) {
  for (std::size_t i = 0; i < e.count; ++i) {
    Vec3 place = Vec3::Zero();
    std::vector<int> polygon;
    for (std::size_t k = 0; k < uses.size(); ++k)
      read_value(in, e.properties[k], uses[k], place, polygon);
    if (e.name == "vertex") file.points.push_back(place);
    if (e.name == "face") file.polygons.push_back(std::move(polygon));
  }
}

/// Scans may consist of triangle strips, which most programs no longer write.
void reject_strips(const PlyHeader& header, const std::string& path) {
  const auto named = [](std::string_view name) {
    return [name](const PlyElement& e) { return e.name == name && e.count > 0; };
  };
  const auto strips = std::ranges::find_if(header.elements, named("tristrips"));
  if (strips != header.elements.end() && std::ranges::none_of(header.elements, named("face")))
    throw InputError(fmt::format(
        "{}:{}: found triangle strips (element tristrips), expected an element face: save the mesh "
        "as triangles",
        path, strips->line));
}

}  // namespace

FacetFile read_ply(std::string_view bytes, const std::string& path) {
  const PlyHeader header = read_ply_header(bytes, path);
  reject_strips(header, path);
  PlyValues in(bytes.substr(header.size), path, header);
  FacetFile file;
  for (const PlyElement& e : header.elements) read_element(in, e, uses_of(e, path), file);
  return file;
}

}  // namespace tdbd::mesh
