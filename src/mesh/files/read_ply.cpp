#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>

#include "core/error.hpp"
#include "core/single.hpp"
#include "mesh/files/facet_file.hpp"
#include "mesh/files/ply_header.hpp"
#include "mesh/files/text_cursor.hpp"

namespace tdbd::mesh {
namespace {

bool is_whole(PlyType type) { return type != PlyType::float32 && type != PlyType::float64; }

/// Reads the values of a text file. Each value is converted to double.
class PlyText {
 public:
  PlyText(std::string_view bytes, const std::string& path, const PlyHeader& header)
      : in_(bytes, path, header.lines + 1) {}

  double value(PlyType type) {
    const double x = in_.number();
    if (is_whole(type) && x != std::floor(x)) fail(fmt::format("'{}'", x), "a whole number");
    return type == PlyType::float32 ? static_cast<double>(static_cast<Single>(x)) : x;
  }
  /// Upper bound on the length of a list.
  std::size_t most(PlyType) const { return in_.left(); }
  [[noreturn]] void fail(const std::string& found, const char* expected) const {
    in_.fail(found, expected);
  }

 private:
  TextCursor in_;
};

/// Reads the values of a binary file.
class PlyBytes {
 public:
  PlyBytes(std::string_view bytes, const std::string& path, const PlyHeader& header)
      : bytes_(bytes), path_(path), size_(bytes.size()), format_(header.format) {}

  double value(PlyType type) {
    switch (type) {
      case PlyType::int8:
        return next<std::int8_t>();
      case PlyType::uint8:
        return next<std::uint8_t>();
      case PlyType::int16:
        return next<std::int16_t>();
      case PlyType::uint16:
        return next<std::uint16_t>();
      case PlyType::int32:
        return next<std::int32_t>();
      case PlyType::uint32:
        return next<std::uint32_t>();
      case PlyType::float32:
        return next<Single>();
      case PlyType::float64:
        return next<double>();
    }
    fail("no type", "one of the eight types");
  }
  std::size_t most(PlyType type) const { return bytes_.size() / byte_size(type); }
  [[noreturn]] void fail(const std::string& found, const char* expected) const {
    throw InputError(fmt::format("{}: byte {} of {} after the header: found {}, expected {}", path_,
                                 size_ - bytes_.size(), size_, found, expected));
  }

 private:
  template <class Number>
  double next() {
    std::array<char, sizeof(Number)> raw;
    if (bytes_.size() < raw.size()) fail("the end of the file", "a number");
    std::copy_n(bytes_.begin(), raw.size(), raw.begin());
    bytes_.remove_prefix(raw.size());
    static_assert(std::endian::native == std::endian::little);
    if (format_ == PlyFormat::binary_big_endian) std::reverse(raw.begin(), raw.end());
    return static_cast<double>(std::bit_cast<Number>(raw));
  }

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
  if (e.name == "vertex") {
    demand(Use::x, "x");
    demand(Use::y, "y");
    demand(Use::z, "z");
  }
  if (e.name == "face") demand(Use::corners, "'list vertex_indices'");
  return uses;
}

template <class Values>
int corner_of(const Values& in, double x) {
  if (!(x >= 0.0 && x <= std::numeric_limits<int>::max() && x == std::floor(x)))
    in.fail(fmt::format("{}", x), "the number of a vertex, 0 or more");
  return static_cast<int>(x);
}

/// Reads the length of a list with elements of type `type`.
template <class Values>
std::size_t length_of(Values& in, PlyType count, PlyType type) {
  const double n = in.value(count);
  if (!(n >= 0.0 && n <= static_cast<double>(in.most(type))))
    in.fail(fmt::format("a list of {}", n), "one that fits into the rest of the file");
  return static_cast<std::size_t>(n);
}

template <class Values>
void read_value(Values& in, const PlyProperty& p, Use use, Vec3& place, std::vector<int>& polygon) {
  if (!p.count) {
    const double value = in.value(p.type);
    if (use != Use::ignored) place[static_cast<Eigen::Index>(use)] = value;
    return;
  }
  const std::size_t n = length_of(in, *p.count, p.type);
  if (use == Use::corners && n < 3)
    in.fail(fmt::format("a polygon with {} corners", n), "three or more");
  if (use == Use::corners) polygon.reserve(n);
  for (std::size_t k = 0; k < n; ++k) {
    const double value = in.value(p.type);
    if (use == Use::corners) polygon.push_back(corner_of(in, value));
  }
}

template <class Values>
void read_element(Values& in, const PlyElement& e, const std::vector<Use>& uses, FacetFile& file) {
  for (std::size_t i = 0; i < e.count; ++i) {
    Vec3 place = Vec3::Zero();
    std::vector<int> polygon;
    for (std::size_t k = 0; k < uses.size(); ++k)
      read_value(in, e.properties[k], uses[k], place, polygon);
    if (e.name == "vertex") file.points.push_back(place);
    if (e.name == "face") file.polygons.push_back(std::move(polygon));
  }
}

template <class Values>
FacetFile read_records(std::string_view bytes, const std::string& path, const PlyHeader& header) {
  Values in(bytes.substr(header.size), path, header);
  FacetFile file;
  for (const PlyElement& e : header.elements) read_element(in, e, uses_of(e, path), file);
  return file;
}

}  // namespace

FacetFile read_ply(std::string_view bytes, const std::string& path) {
  const PlyHeader header = read_ply_header(bytes, path);
  return header.format == PlyFormat::ascii ? read_records<PlyText>(bytes, path, header)
                                           : read_records<PlyBytes>(bytes, path, header);
}

}  // namespace tdbd::mesh
