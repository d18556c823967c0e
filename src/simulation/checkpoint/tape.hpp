#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace tdbd::simulation {

/// The numbers of a state one after another, by their kind, and the names of what was written.
struct Tape {
  std::vector<double> reals;
  std::vector<std::int64_t> wholes;
  std::vector<std::int32_t> ints;
  std::vector<std::uint8_t> bytes;
  std::string names;  ///< a line each
};

/// Writes named items to a tape (tape_items.hpp).
class TapeWriter {
 public:
  static constexpr bool writes = true;
  explicit TapeWriter(Tape& tape) : tape_(tape) {}

  template <class T>
  void operator()(const char* name, const T& x) {
    tape_.names.append(name).push_back('\n');
    item(*this, x);
  }
  void number(const double& x) { tape_.reals.push_back(x); }
  template <class T>
  void number(const T& x) {
    tape_.wholes.push_back(static_cast<std::int64_t>(x));
  }
  std::size_t size(std::size_t n) {
    tape_.wholes.push_back(static_cast<std::int64_t>(n));
    return n;
  }
  void text(const std::string& x) { all(std::vector<std::uint8_t>(x.begin(), x.end())); }
  void all(const std::vector<double>& x) { append(x, tape_.reals); }
  void all(const std::vector<std::int32_t>& x) { append(x, tape_.ints); }
  void all(const std::vector<std::uint8_t>& x) { append(x, tape_.bytes); }

 private:
  template <class T>
  void append(const std::vector<T>& x, std::vector<T>& column) {
    size(x.size());
    column.insert(column.end(), x.begin(), x.end());
  }

  Tape& tape_;
};

/// Reads them in the same order. Throws RunError where the tape ends too early.
class TapeReader {
 public:
  static constexpr bool writes = false;
  explicit TapeReader(const Tape& tape) : tape_(tape) {}

  template <class T>
  void operator()(const char* name, T& x) {
    names_.append(name).push_back('\n');
    item(*this, x);
  }
  void number(double& x) { x = next(tape_.reals, reals_); }
  template <class T>
  void number(T& x) {
    x = static_cast<T>(next(tape_.wholes, wholes_));
  }
  /// Each of the elements has at least one number: a size beyond all numbers is none.
  std::size_t size(std::size_t) {
    const auto n = static_cast<std::uint64_t>(next(tape_.wholes, wholes_));
    if (n > tape_.reals.size() + tape_.wholes.size() + tape_.ints.size() + tape_.bytes.size())
      refuse();
    return static_cast<std::size_t>(n);
  }
  void text(std::string& x) {
    std::vector<std::uint8_t> bytes;
    all(bytes);
    x.assign(bytes.begin(), bytes.end());
  }
  void all(std::vector<double>& x) { take(tape_.reals, reals_, x); }
  void all(std::vector<std::int32_t>& x) { take(tape_.ints, ints_, x); }
  void all(std::vector<std::uint8_t>& x) { take(tape_.bytes, bytes_, x); }

  /// Throws RunError unless all was read, under the names it was written under.
  void finish() const {
    if (names_ != tape_.names || reals_ != tape_.reals.size() || wholes_ != tape_.wholes.size() ||
        ints_ != tape_.ints.size() || bytes_ != tape_.bytes.size())
      refuse();
  }

 private:
  [[noreturn]] static void refuse() {
    throw RunError("does not hold the state of this version of tdbd");
  }
  template <class T>
  T next(const std::vector<T>& column, std::size_t& at) {
    if (at >= column.size()) refuse();
    return column[at++];
  }
  template <class T>
  void take(const std::vector<T>& column, std::size_t& at, std::vector<T>& x) {
    const std::size_t n = size(0);
    if (n > column.size() - at) refuse();
    const auto from = column.begin() + static_cast<std::ptrdiff_t>(at);
    x.assign(from, from + static_cast<std::ptrdiff_t>(n));
    at += n;
  }

  const Tape& tape_;
  std::string names_;
  std::size_t reals_ = 0, wholes_ = 0, ints_ = 0, bytes_ = 0;
};

}  // namespace tdbd::simulation
