#include "reference/literature/roller/craters/weight_balance.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace tdbd::reference {

void throw_no_balance(std::string_view model, const WeightBracket& tried, double reached,
                      double weight) {
  throw InputError(fmt::format(
      "{}: no root for z: found {:.6g} N at the end of the bracket, [{:.6g}, {:.6g}] m, expected "
      "the "
      "weight on bit, {:.6g} N; it needs a law that carries the weight with the teeth it has",
      model, reached, tried.low, tried.high, weight));
}

double next_place(const WeightBracket& in, double first_width, double room) {
  const double middle = 0.5 * (in.low + in.high), half = 0.5 * (in.high - in.low);
  const double line = in.low - in.under * (in.high - in.low) / (in.over - in.under);
  const double off = middle - line;
  // 0.2/width and the square are the constants in the tests of the method's authors.
  const double nudge = std::min(0.2 / first_width * 4.0 * half * half, std::abs(off));
  const double z = std::clamp(line + std::copysign(nudge, off), middle - room, middle + room);
  return z > in.low && z < in.high ? z : middle;
}

}  // namespace tdbd::reference
