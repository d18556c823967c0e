#pragma once

#include <array>
#include <cstddef>

namespace tdbd::reference {

/// One step of the classical Runge-Kutta method for y' = f(t, y) with a fixed number of unknowns:
/// f(t, y, dydt). Without allocations, so that benchmarks measure the model and not the method.
/// (ode.hpp has the same method for whole intervals of vectors.)
template <std::size_t n, class Rates>
void rk4_step(const Rates& f, double t, double h, std::array<double, n>& y) {
  std::array<double, n> k1{}, k2{}, k3{}, k4{}, z{};
  const auto shifted = [&](const std::array<double, n>& k, double by) -> const auto& {
    for (std::size_t i = 0; i < n; ++i) z[i] = y[i] + by * k[i];
    return z;
  };
  f(t, y, k1);
  f(t + 0.5 * h, shifted(k1, 0.5 * h), k2);
  f(t + 0.5 * h, shifted(k2, 0.5 * h), k3);
  f(t + h, shifted(k3, h), k4);
  for (std::size_t i = 0; i < n; ++i) y[i] += h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]);
}

}  // namespace tdbd::reference
