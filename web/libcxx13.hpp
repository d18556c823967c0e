#pragma once

// What the standard library of emscripten 3.1.6 (libc++ 13) lacks of C++20, and src uses: algorithms of ranges, numbers
// from and to text, bit_cast, order of strings. Included before every source; later versions have it all.

#include <fast_float/fast_float.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <compare>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <numeric>
#include <ranges>
#include <string>
#include <type_traits>
#include <utility>

namespace std {

inline from_chars_result from_chars(const char* first, const char* last, double& value) {
  double read = 0.0;
  const auto [end, error] = fast_float::from_chars(first, last, read);
  if (error != errc()) return {end, error};
  const bool says_infinite =
      first != last && (*first == 'i' || *first == 'I' || first[*first == '-'] == 'i' ||
                        first[*first == '-'] == 'I');
  if (isinf(read) && !says_infinite) return {end, errc::result_out_of_range};
  value = read;
  return {end, error};
}

/// The shortest digits that are read back as the value, in scientific notation.
inline to_chars_result to_chars(char* first, char* last, double value, chars_format) {
  constexpr int most_digits = 16;  // after the point
  for (int digits = 0; digits <= most_digits; ++digits) {
    const int length = snprintf(first, static_cast<size_t>(last - first), "%.*e", digits, value);
    if (length < 0 || length >= last - first) return {last, errc::value_too_large};
    if (digits == most_digits || strtod(first, nullptr) == value) return {first + length, errc()};
  }
  return {last, errc::value_too_large};
}

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}

inline strong_ordering operator<=>(const string& a, const string& b) {
  const int order = a.compare(b);
  return order < 0   ? strong_ordering::less
         : order > 0 ? strong_ordering::greater
                     : strong_ordering::equal;
}

namespace ranges {

/// less(a, b) of what `projection` makes of both.
template <class Less, class Projection>
auto projected_less(Less less, Projection projection) {
  return [=](const auto& a, const auto& b) {
    return bool(std::invoke(less, std::invoke(projection, a), std::invoke(projection, b)));
  };
}

template <class R, class Test, class Projection = identity>
bool any_of(R&& r, Test test, Projection p = {}) {
  return std::any_of(std::begin(r), std::end(r),
                     [&](auto&& x) { return bool(std::invoke(test, std::invoke(p, x))); });
}
template <class R, class Test, class Projection = identity>
bool all_of(R&& r, Test test, Projection p = {}) {
  return std::all_of(std::begin(r), std::end(r),
                     [&](auto&& x) { return bool(std::invoke(test, std::invoke(p, x))); });
}
template <class R, class Test, class Projection = identity>
bool none_of(R&& r, Test test, Projection p = {}) {
  return !ranges::any_of(r, test, p);
}
template <class R, class Test, class Projection = identity>
auto find_if(R&& r, Test test, Projection p = {}) {
  return std::find_if(std::begin(r), std::end(r),
                      [&](auto&& x) { return bool(std::invoke(test, std::invoke(p, x))); });
}
template <class R, class T, class Projection = identity>
auto find(R&& r, const T& value, Projection p = {}) {
  return ranges::find_if(
      r, [&](const auto& x) { return x == value; }, p);
}
template <class R, class T, class Projection = identity>
auto count(R&& r, const T& value, Projection p = {}) {
  return std::count_if(std::begin(r), std::end(r),
                       [&](const auto& x) { return std::invoke(p, x) == value; });
}
template <class R, class Test, class Projection = identity>
auto count_if(R&& r, Test test, Projection p = {}) {
  return std::count_if(std::begin(r), std::end(r),
                       [&](const auto& x) { return bool(std::invoke(test, std::invoke(p, x))); });
}
template <class R, class Less = ranges::less, class Projection = identity>
void sort(R&& r, Less less = {}, Projection p = {}) {
  std::sort(std::begin(r), std::end(r), projected_less(less, p));
}
template <class R, class Less = ranges::less, class Projection = identity>
void stable_sort(R&& r, Less less = {}, Projection p = {}) {
  std::stable_sort(std::begin(r), std::end(r), projected_less(less, p));
}
template <class R, class Place, class Less = ranges::less, class Projection = identity>
void nth_element(R&& r, Place nth, Less less = {}, Projection p = {}) {
  std::nth_element(std::begin(r), nth, std::end(r), projected_less(less, p));
}
template <class R, class T, class Less = ranges::less, class Projection = identity>
auto lower_bound(R&& r, const T& value, Less less = {}, Projection p = {}) {
  return std::lower_bound(std::begin(r), std::end(r), value, [&](const auto& x, const T& v) {
    return bool(std::invoke(less, std::invoke(p, x), v));
  });
}
template <class R, class T, class Less = ranges::less, class Projection = identity>
auto upper_bound(R&& r, const T& value, Less less = {}, Projection p = {}) {
  return std::upper_bound(std::begin(r), std::end(r), value, [&](const T& v, const auto& x) {
    return bool(std::invoke(less, v, std::invoke(p, x)));
  });
}
template <class R, class T>
bool binary_search(R&& r, const T& value) {
  return std::binary_search(std::begin(r), std::end(r), value);
}
template <class A, class B, class Test = ranges::equal_to, class First = identity,
          class Second = identity>
bool equal(A&& a, B&& b, Test test = {}, First first = {}, Second second = {}) {
  return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b),
                    [&](const auto& x, const auto& y) {
                      return bool(std::invoke(test, std::invoke(first, x), std::invoke(second, y)));
                    });
}
template <class R, class Less = ranges::less, class Projection = identity>
auto min_element(R&& r, Less less = {}, Projection p = {}) {
  return std::min_element(std::begin(r), std::end(r), projected_less(less, p));
}
template <class R, class Less = ranges::less, class Projection = identity>
auto max_element(R&& r, Less less = {}, Projection p = {}) {
  return std::max_element(std::begin(r), std::end(r), projected_less(less, p));
}
template <class R, class Less = ranges::less, class Projection = identity>
auto min(R&& r, Less less = {}, Projection p = {}) {
  return *ranges::min_element(r, less, p);
}
template <class R, class Less = ranges::less, class Projection = identity>
auto max(R&& r, Less less = {}, Projection p = {}) {
  return *ranges::max_element(r, less, p);
}
/// The last of several greatest, as the standard has it.
template <class R, class Less = ranges::less, class Projection = identity>
auto minmax(R&& r, Less less = {}, Projection p = {}) {
  const auto [least, greatest] =
      std::minmax_element(std::begin(r), std::end(r), projected_less(less, p));
  return std::pair(*least, *greatest);
}
template <class R, class Function>
void for_each(R&& r, Function function) {
  std::for_each(std::begin(r), std::end(r), function);
}
template <class R, class Out>
void copy(R&& r, Out out) {
  std::copy(std::begin(r), std::end(r), out);
}
template <class R, class Out, class Test>
void copy_if(R&& r, Out out, Test test) {
  std::copy_if(std::begin(r), std::end(r), out,
               [&](const auto& x) { return bool(std::invoke(test, x)); });
}
template <class R, class Out>
void move(R&& r, Out out) {
  std::move(std::begin(r), std::end(r), out);
}
template <class R, class Out, class Function>
void transform(R&& r, Out out, Function function) {
  std::transform(std::begin(r), std::end(r), out,
                 [&](const auto& x) { return std::invoke(function, x); });
}
template <class A, class B, class Out, class Function>
void transform(A&& a, B&& b, Out out, Function function) {
  std::transform(std::begin(a), std::end(a), std::begin(b), out, function);
}
template <class R, class T>
void fill(R&& r, const T& value) {
  std::fill(std::begin(r), std::end(r), value);
}
template <class R, class T>
void replace(R&& r, const T& old, const T& now) {
  std::replace(std::begin(r), std::end(r), old, now);
}

}  // namespace ranges
}  // namespace std
