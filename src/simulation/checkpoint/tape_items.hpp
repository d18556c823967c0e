#pragma once

#include <array>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/types.hpp"
#include "simulation/checkpoint/tape.hpp"

namespace tdbd::simulation {

/// The same functions write and read: what one archive may not change, the other one sets.
template <class Archive, class T>
using Of = std::conditional_t<Archive::writes, const T, T>;

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;
template <class T>
inline constexpr bool is_pair = false;
template <class T, class U>
inline constexpr bool is_pair<std::pair<T, U>> = true;
template <class T>
inline constexpr bool is_array = false;
template <class T, std::size_t n>
inline constexpr bool is_array<std::array<T, n>> = true;
template <class T>
concept Quaternion = requires(T& x) {
  x.coeffs().data();
};
template <class T>
concept Matrix = requires(T& x) {
  x.data();
  x.cols();
};

/// A tape has a column for numbers of these kinds.
template <class T>
inline constexpr bool is_column =
    std::is_same_v<T, double> || std::is_same_v<T, std::int32_t> || std::is_same_v<T, std::uint8_t>;

template <class A, class T>
void item(A& a, T& x);

template <class A, class T>
void vector_item(A& a, T& x) {
  if constexpr (is_column<typename T::value_type>) {
    a.all(x);
  } else {
    const std::size_t n = a.size(x.size());
    if constexpr (!A::writes) x.resize(n);
    for (auto& element : x) item(a, element);
  }
}

template <class A, class T>
void optional_item(A& a, T& x) {
  const bool is_there = a.size(x.has_value() ? 1 : 0) != 0;
  if constexpr (!A::writes) {
    x.reset();
    if (is_there) x.emplace();
  }
  if (is_there) item(a, *x);
}

/// Writes or reads a number, text, container, or small matrix; of a struct what its fields(a, x)
/// names, in that order.
template <class A, class T>
void item(A& a, T& x) {
  using Plain = std::remove_const_t<T>;
  if constexpr (std::is_arithmetic_v<Plain> || std::is_enum_v<Plain>) {
    a.number(x);
  } else if constexpr (std::is_same_v<Plain, std::string>) {
    a.text(x);
  } else if constexpr (is_vector<Plain>) {
    vector_item(a, x);
  } else if constexpr (is_optional<Plain>) {
    optional_item(a, x);
  } else if constexpr (is_array<Plain>) {
    for (auto& element : x) item(a, element);
  } else if constexpr (is_pair<Plain>) {
    item(a, x.first);
    item(a, x.second);
  } else if constexpr (Quaternion<T>) {
    for (int i = 0; i < 4; ++i) a.number(x.coeffs().data()[i]);
  } else if constexpr (Matrix<T>) {
    for (int i = 0; i < static_cast<int>(x.size()); ++i) a.number(x.data()[i]);
  } else {
    fields(a, x);
  }
}

}  // namespace tdbd::simulation
