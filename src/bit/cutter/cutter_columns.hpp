#pragma once

#include <span>
#include <string_view>

#include "bit/bit.hpp"

namespace tdbd::bit {

/// A column of the cutter table that holds a number: where it goes, in which unit, and which
/// values make sense. Bounds are in the column's own unit.
struct NumberColumn {
  std::string_view name;
  double Cutter::*member;
  double unit;  ///< SI per unit of the column
  bool required;
  double lowest;
  double highest;
  std::string_view expected;  ///< the bounds in words, for messages
};

/// Every number column. Thesis: 3.2.2.
std::span<const NumberColumn> number_columns();

}  // namespace tdbd::bit
