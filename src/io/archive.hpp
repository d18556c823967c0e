#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/types.hpp"

// A struct that can be stored lists its members in a member function:
//
//   template <class Archive>
//   void serialize(Archive& a) { a(time, X_WB); }

namespace tdbd {

/// A sequence of values in the binary representation of this machine, and a hash of their types,
/// which detects archives of another program.
struct Archive {
  std::string bytes;
  std::uint64_t layout = 0;

  template <class A>
  void serialize(A& a) {
    a(bytes, layout);
  }
};

template <class T>
inline constexpr bool is_plain =
    (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) || std::is_enum_v<T>;
template <class T, std::size_t n>
inline constexpr bool is_plain<std::array<T, n>> = is_plain<T>;
template <class T, int rows, int columns>
inline constexpr bool is_plain<Eigen::Matrix<T, rows, columns>> = rows > 0 && columns > 0;
template <class T>
inline constexpr bool is_plain<Eigen::Quaternion<T>> = true;

/// What writers and readers share: the order of values in a container, and the layout.
template <class Own>
class ArchiveVisitor {
 public:
  /// Visits values in the given order: numbers, texts, containers, small matrices, and structs with
  /// a member `serialize`.
  template <class... T>
  void visit(T&... values) {
    note(sizeof...(values));
    (item(values), ...);
  }

 protected:
  /// FNV-1a, applied to numbers rather than bytes.
  void note(std::uint64_t kind) { layout_ = (layout_ ^ kind) * 0x100000001b3U; }

  std::uint64_t layout_ = 0xcbf29ce484222325U;

 private:
  static constexpr std::uint64_t real = 256, text = 512, list = 1024, option = 2048;

  Own& own() { return static_cast<Own&>(*this); }

  template <class T>
  void item(T& x) {
    if constexpr (is_plain<T>) {
      note(sizeof(T) + (std::is_integral_v<T> || std::is_enum_v<T> ? 0 : real));
      own().raw(&x, sizeof(T));
    } else {
      other_item(x);
    }
  }
  void other_item(bool& x) {
    auto byte = static_cast<std::uint8_t>(x ? 1 : 0);
    item(byte);
    if (const bool read = byte != 0; read != x) x = read;
  }
  void other_item(std::string& x) {
    note(text);
    own().raw_list(x);
  }
  template <class T>
  void other_item(std::vector<T>& x) {
    note(list);
    if constexpr (is_plain<T>) {
      note(sizeof(T));
      own().raw_list(x);
    } else {
      own().each(x, [this](T& element) { item(element); });
    }
  }
  template <class T>
  void other_item(std::optional<T>& x) {
    bool is_there = x.has_value();
    note(option);
    item(is_there);
    if (is_there && !x) x.emplace();
    if (is_there)
      item(*x);
    else
      x.reset();
  }
  template <class T, std::size_t n>
  void other_item(std::array<T, n>& x) {
    for (T& element : x) item(element);
  }
  template <class T, class U>
  void other_item(std::pair<T, U>& x) {
    visit(x.first, x.second);
  }
  template <class T>
  void other_item(T& x) {
    x.serialize(own());
  }
};

class ArchiveWriter : public ArchiveVisitor<ArchiveWriter> {
 public:
  /// `head`: bytes that precede the values.
  explicit ArchiveWriter(std::string head = {}) : bytes_(std::move(head)) {}

  /// Appends values without changing them. `serialize` is not const because readers use it, too.
  template <class... T>
  void operator()(const T&... values) {
    visit(const_cast<T&>(values)...);
  }

  Archive archive() && { return {std::move(bytes_), layout_}; }

 private:
  friend class ArchiveVisitor<ArchiveWriter>;

  void raw(const void* from, std::size_t n) { bytes_.append(static_cast<const char*>(from), n); }
  void size(std::uint64_t n) { raw(&n, sizeof(n)); }
  template <class List>
  void raw_list(const List& x) {
    size(x.size());
    if (!x.empty()) raw(x.data(), x.size() * sizeof(x[0]));
  }
  template <class T, class Visit>
  void each(std::vector<T>& x, Visit&& visit_one) {
    size(x.size());
    for (T& element : x) visit_one(element);
  }

  std::string bytes_;
};

/// Reads values in the order in which they were written. The archive must outlive the reader.
class ArchiveReader : public ArchiveVisitor<ArchiveReader> {
 public:
  explicit ArchiveReader(std::string_view bytes) : bytes_(bytes) {}

  /// Throws RunError if the archive ends too early.
  template <class... T>
  void operator()(T&... values) {
    visit(values...);
  }

  /// Throws RunError unless everything was read.
  void require_end() const {
    if (!bytes_.empty()) refuse();
  }
  /// Throws RunError unless everything was read, as values of the types that were written.
  void require_end(std::uint64_t layout) const {
    require_end();
    if (layout != layout_) refuse();
  }

 private:
  friend class ArchiveVisitor<ArchiveReader>;

  [[noreturn]] static void refuse() {
    throw RunError("does not hold the state of this version of tdbd");
  }
  void raw(void* to, std::size_t n) {
    if (n > bytes_.size()) refuse();
    if (n > 0) std::memcpy(to, bytes_.data(), n);
    bytes_.remove_prefix(n);
  }
  std::uint64_t size() {
    std::uint64_t n = 0;
    raw(&n, sizeof(n));
    return n;
  }
  template <class List>
  void raw_list(List& x) {
    const std::uint64_t n = size();
    if (n > bytes_.size() / sizeof(x[0])) refuse();
    x.resize(static_cast<std::size_t>(n));
    raw(x.data(), x.size() * sizeof(x[0]));
  }
  /// Grows the container value by value: a corrupt size then runs out of bytes before it allocates
  /// much memory.
  template <class T, class Visit>
  void each(std::vector<T>& x, Visit&& visit_one) {
    x.clear();
    for (std::uint64_t n = size(); n > 0; --n) visit_one(x.emplace_back());
  }

  std::string_view bytes_;
};

}  // namespace tdbd
