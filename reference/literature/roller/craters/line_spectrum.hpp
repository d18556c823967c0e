#pragma once

#include <span>
#include <vector>

namespace tdbd::reference {

/// Amplitudes of a series' Fourier components at given frequencies (Hz), in its unit: a sine of amplitude A
/// at one of them, over a whole number of its periods, gives A. `step` (s) is that of the series; its mean is
/// taken away first. By Goertzel's recursion: one multiplication for each reading and frequency.
std::vector<double> line_spectrum(std::span<const double> series, double step,
                                  std::span<const double> frequencies);

}  // namespace tdbd::reference
