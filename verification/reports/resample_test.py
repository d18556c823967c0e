"""reports/figures/signals.py on tones: what passes, what is gone, what a naive way folds back."""

import pathlib
import sys
import unittest

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "reports"))
from figures import signals  # noqa: E402

RATE, UP, DOWN = 1000.0, 64, 125
LOW = RATE * UP / DOWN  # Hz
ENDS = 100  # samples at either end that the filter makes up
PASSED = 1e-3  # of the amplitude; seen 3e-4, of a tone that is no line of the transform
SHIFT = 2e-3  # samples; seen 7e-4: a windowed sinc keeps no straight line exactly
GONE = 1e-4  # of the amplitude; seen 5e-5 at 280 Hz, the filter's edge, 7e-6 at 400 Hz


def tone(frequency, rate=RATE, count=10000):
    return np.sin(2.0 * np.pi * frequency * np.arange(count) / rate + 0.3)


def rms(samples):
    return np.sqrt(2.0 * np.mean(samples[ENDS:-ENDS]**2))


class Resampled(unittest.TestCase):
    def test_a_tone_below_220_hz_keeps_its_amplitude_and_its_place(self):
        for frequency in (5.0, 50.0, 100.0, 200.0, 220.0):
            made = signals.resampled(tone(frequency), UP, DOWN)
            exact = tone(frequency, LOW, len(made))
            error = np.abs(made - exact)[ENDS:-ENDS].max()
            self.assertLess(error, PASSED, frequency)

    def test_a_tone_above_half_of_the_low_rate_is_gone(self):
        for frequency in (300.0, 400.0, 490.0):
            self.assertLess(rms(signals.resampled(tone(frequency), UP, DOWN)), GONE, frequency)

    def test_without_a_low_pass_400_hz_comes_back_at_112(self):
        made = signals.interpolated(tone(400.0), UP, DOWN)
        frequency, amplitude = signals.strongest(made, LOW, 1)[0]
        self.assertAlmostEqual(frequency, LOW - 400.0, delta=0.05)
        self.assertGreater(amplitude, 0.5)

    def test_a_constant_stays_and_the_first_instant_is_the_first(self):
        np.testing.assert_allclose(signals.resampled(np.full(500, 7.0), UP, DOWN), 7.0, rtol=1e-14)
        ramp = signals.resampled(np.arange(2001.0), UP, DOWN)
        self.assertEqual(len(ramp), 1025)
        np.testing.assert_allclose(ramp[ENDS:-ENDS], (np.arange(1025) * DOWN / UP)[ENDS:-ENDS], atol=SHIFT)

    def test_the_same_rate_changes_nothing(self):
        samples = np.cos(np.arange(300.0)**1.3)
        np.testing.assert_allclose(signals.resampled(samples, 1, 1), samples, atol=1e-14)

    def test_to_a_higher_rate_tones_keep_their_amplitude(self):
        made = signals.resampled(tone(50.0, LOW), DOWN, UP)
        np.testing.assert_allclose(made[2 * ENDS:-2 * ENDS], tone(50.0, RATE, len(made))[2 * ENDS:-2 * ENDS], atol=PASSED)


class Spectra(unittest.TestCase):
    def test_density_times_width_is_the_variance(self):
        noise = np.random.default_rng(1).normal(size=200000)
        frequency, density = signals.welch(noise, RATE)
        self.assertAlmostEqual(density.sum() * frequency[1], 1.0, delta=0.01)

    def test_density_of_noise_does_not_depend_on_the_rate(self):
        noise = np.random.default_rng(2).normal(size=400000)
        frequency, ratio = signals.ratios(signals.resampled(noise, UP, DOWN), LOW, noise, RATE)
        self.assertEqual((frequency[0], frequency[-1]), signals.BAND)
        self.assertLess(np.abs(ratio - 1.0).max(), 0.02)
        naive = signals.ratios(signals.interpolated(noise, UP, DOWN), LOW, noise, RATE)[1]
        self.assertGreater(np.abs(naive - 1.0).max(), 0.1)

    def test_lines_are_found_between_those_of_the_transform(self):
        samples = 3.0 * tone(12.34) + 0.2 * tone(77.7) + 5.0
        found = signals.strongest(samples, RATE, 2)
        for (frequency, amplitude), (at, height) in zip(found, ((12.34, 3.0), (77.7, 0.2))):
            self.assertAlmostEqual(frequency, at, delta=0.005)
            self.assertAlmostEqual(amplitude / height, 1.0, delta=0.15)


if __name__ == "__main__":
    unittest.main()
