#pragma once

#include <span>
#include <vector>

namespace tdbd::reference {

/// Amplitudes of a series' Fourier components at given frequencies (Hz), in its unit: a sine of
/// amplitude A at one of them, over an integer number of its periods, gives A. `step` (s): sampling
/// interval of the series, whose mean is subtracted first. Uses Goertzel's recursion, with one
/// multiplication per sample and frequency.
std::vector<double> line_spectrum(std::span<const double> series, double step,
                                  std::span<const double> frequencies);

}  // namespace tdbd::reference
