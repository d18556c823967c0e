#pragma once

#include <optional>
#include <vector>

namespace tdbd::reference {

/// Winters, Warren and Onyia (1987), thesis 2.2: rate of penetration of a roller bit from weight,
/// speed and the rock's confined strength, or the strength from the rate, without the bit's or a
/// tooth's shape. Seen: what the model accounts for (offset, ductility, indentation, sliding; the
/// thesis, and the abstract of SPE 16696), and that ductility matters most. The formula is from memory
/// of it (confidence 0.6) and made dimensionless, since without the diameter in the term of the
/// offset the units do not agree:
///   1/delta = (1/w) (a eps_d/w + phi) + b + c,  w = W/(sigma D^2),  delta = R/(N D)
/// with N in revolutions per second. Whether the paper's last term carries D is unknown.
struct WintersConstants {
  double ductility = 0.0;  ///< a eps_d: indentation of a rock of ductility eps_d (a strain)
  double offset = 0.0;     ///< phi: offset and sliding
  double teeth = 0.0;      ///< b: the most that teeth can dig in a turn
  double cleaning = 0.0;   ///< c: fluid
};

/// How the bit is run.
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

/// At a dimensionless weight w > 0.
WintersTerms winters_terms(const WintersConstants& constants, double w);

/// w of a weight on rock of this confined strength, Pa.
double winters_weight(const WintersRun& run, double strength);

/// Rate of penetration, m/s. Throws InputError: no weight, strength, diameter or speed; a sum that is not > 0.
double winters_rate(const WintersConstants& constants, const WintersRun& run, double strength);

/// The other way: the confined strength (Pa) at which the bit drills at this rate. Throws InputError
/// if the rate is not below that of perfect indentation, N D/(b + c), or the constants (negative ones
/// of a fit) give no strength.
double winters_strength(const WintersConstants& constants, const WintersRun& run, double rate);

/// d ln R/d ln W at constant strength: 2 in hard ductile rock, 1 where offset or brittleness rules,
/// 0 at the limit of teeth and cleaning.
double winters_exponent(const WintersConstants& constants, double w);

/// One measured rate.
struct WintersPoint {
  WintersRun run{};
  double strength = 0.0;  ///< Pa
  double rate = 0.0;      ///< m/s
};

/// What rates of penetration determine. 1/delta is linear in a eps_d, phi and b + c, so three rates
/// at three different w give these exactly and more give the least squares of relative errors of the
/// rate. They never part a from eps_d, nor b from c: `constants` has b + c as `teeth`. If the strength
/// is only known up to a factor f, a eps_d is known up to f^-2 and phi up to f^-1, and strengths in
/// other rocks up to f.
struct WintersFit {
  WintersConstants constants{};
  double condition = 0.0;  ///< of the matrix with columns scaled to 1: how errors of rates grow
  double residual = 0.0;   ///< rms, relative to the rate
};

/// `teeth_and_cleaning`: b + c where it is known, and then two rates do. A constant may come out
/// negative: the rates then contradict the form. Throws InputError: too few points, or too few
/// different w.
WintersFit fit_winters(const std::vector<WintersPoint>& points,
                       std::optional<double> teeth_and_cleaning = std::nullopt);

}  // namespace tdbd::reference
