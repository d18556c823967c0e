#pragma once

#include <optional>
#include <vector>

namespace tdbd::reference {

/// Winters, Warren and Onyia (1987), thesis 2.2: rate of penetration of a roller bit from weight,
/// speed and the rock's confined strength, or the strength from the rate, without the geometry of
/// the bit or of teeth. Known: what the model accounts for (offset, ductility, indentation,
/// sliding; from the thesis and the abstract of SPE 16696), and that ductility matters most. The
/// formula is from memory (confidence 0.6) and made dimensionless, because without the diameter in
/// the term of the offset the units are inconsistent:
///   1/delta = (1/w) (a eps_d/w + phi) + b + c,  w = W/(sigma D^2),  delta = R/(N D)
/// with N in revolutions per second. Whether the paper's last term contains D is unknown.
struct WintersConstants {
  double ductility = 0.0;  ///< a eps_d: indentation of a rock of ductility eps_d (a strain)
  double offset = 0.0;     ///< phi: offset and sliding
  double teeth = 0.0;      ///< b: largest depth that teeth can dig per turn
  double cleaning = 0.0;   ///< c: fluid
};

/// Operating conditions of the bit.
struct WintersRun {
  double weight = 0.0;        ///< W, N
  double diameter = 0.0;      ///< D, m
  double rotary_speed = 0.0;  ///< rad/s
};

/// The terms of 1/delta, in the order of the constants.
struct WintersTerms {
  double ductility = 0.0, offset = 0.0, teeth = 0.0, cleaning = 0.0;
  double sum() const { return ductility + offset + teeth + cleaning; }
};

/// The terms at a dimensionless weight w > 0.
WintersTerms winters_terms(const WintersConstants& constants, double w);

/// w of a weight on rock of this confined strength, Pa.
double winters_weight(const WintersRun& run, double strength);

/// Rate of penetration, m/s. Throws InputError for no weight, strength, diameter or speed, or a sum
/// that is not > 0.
double winters_rate(const WintersConstants& constants, const WintersRun& run, double strength);

/// The inverse: the confined strength (Pa) at which the bit drills at this rate. Throws InputError
/// if the rate is not below that of perfect indentation, N D/(b + c), or if the constants (negative
/// ones of a fit) give no strength.
double winters_strength(const WintersConstants& constants, const WintersRun& run, double rate);

/// d ln R/d ln W at constant strength: 2 in hard ductile rock, 1 where offset or brittleness
/// dominates, 0 in the limit of teeth and cleaning.
double winters_exponent(const WintersConstants& constants, double w);

/// One measured rate.
struct WintersPoint {
  WintersRun run{};
  double strength = 0.0;  ///< Pa
  double rate = 0.0;      ///< m/s
};

/// Constants fitted to rates of penetration. 1/delta is linear in a eps_d, phi and b + c, so three
/// rates at three different w determine these exactly; more rates are fitted by least squares of
/// their relative errors. They cannot separate a from eps_d, nor b from c: `constants` has b + c as
/// `teeth`. If the strength is only known up to a factor f, a eps_d is known up to f^-2, phi up to
/// f^-1, and strengths in other rocks up to f.
struct WintersFit {
  WintersConstants constants{};
  double condition = 0.0;  ///< of the matrix with unit columns: amplification of errors
  double residual = 0.0;   ///< rms, relative to the rate
};

/// `teeth_and_cleaning`: b + c if it is known; then two rates are sufficient. A constant may be
/// negative: then the rates contradict the form. Throws InputError for too few points, or too few
/// different w.
WintersFit fit_winters(const std::vector<WintersPoint>& points,
                       std::optional<double> teeth_and_cleaning = std::nullopt);

}  // namespace tdbd::reference
