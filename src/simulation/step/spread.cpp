#include "simulation/step/spread.hpp"

#include <cmath>

namespace tdbd::simulation {

void add(Spread& s, double x) {
  ++s.count;
  const double before = x - s.mean;
  s.mean += before / static_cast<double>(s.count);
  s.squares += before * (x - s.mean);
}

double relative_rms(const Spread& s) {
  if (s.count == 0 || s.mean == 0.0) return 0.0;
  return std::sqrt(s.squares / static_cast<double>(s.count)) / s.mean;
}

}  // namespace tdbd::simulation
