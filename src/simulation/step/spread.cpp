#include "simulation/step/spread.hpp"

#include <cmath>

namespace tdbd::simulation {

void add(Spread& s, double x) {
  ++s.count;
  const double before = x - s.mean;
  s.mean += before / static_cast<double>(s.count);
  s.squares += before * (x - s.mean);
}

double deviation(const Spread& s) {
  return s.count > 0 ? std::sqrt(s.squares / static_cast<double>(s.count)) : 0.0;
}

double relative_deviation(const Spread& s) { return s.mean != 0.0 ? deviation(s) / s.mean : 0.0; }

}  // namespace tdbd::simulation
