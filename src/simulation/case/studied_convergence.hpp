#pragma once

#include <map>
#include <string>
#include <vector>

namespace tdbd::simulation {

/// mean: over the steps that count. diagnosed: by simulation::Diagnosis; of a steady bit this is noise.
enum class FigureKind { mean, diagnosed };

/// A figure of summary.json that a study of convergence knows too.
struct StudiedFigure {
  const char* in_study;
  const char* in_summary;
  FigureKind kind = FigureKind::mean;
};

inline constexpr StudiedFigure studied_figures[] = {
    {"wob_mean", "wob_mean_n"},
    {"tob_mean", "tob_mean_n_m"},
    {"rop_mean", "rop_mean_m_per_s"},
    {"rotary_speed_mean", "rotary_speed_mean_rad_per_s"},
    {"stick_slip_severity", "stick_slip_severity", FigureKind::diagnosed},
    {"torsional_frequency", "torsional_frequency_hz", FigureKind::diagnosed},
    {"orbit_radius", "orbit_radius_m", FigureKind::diagnosed},
    {"orbit_frequency", "orbit_frequency_hz", FigureKind::diagnosed}};

/// By their names in summary.json, SI.
using Figures = std::map<std::string, double>;

/// What `tdbd converge` found of a case: the figures at every level, and how uncertain those of the
/// finest are.
struct StudiedConvergence {
  struct Level {
    std::vector<double> sizes;  ///< of the keys, SI
    Figures figures;
  };
  std::vector<std::string> keys;  ///< dotted, of what was divided: "time.step"
  std::vector<Level> levels;      ///< the finest last
  Figures left;                   ///< numerical uncertainty of the finest level
};

/// Reads a convergence.json, or a list of such objects in one file. Only what StudiedConvergence
/// holds is looked at. Throws InputError: "FILE: found ..., expected ...".
std::vector<StudiedConvergence> read_studied_convergence(const std::string& file);

/// The numerical uncertainty of a run's figures x by one study, ours: that of the finest level n, and the
/// distance from that,
///   U = |x - x_n| + U_n.
struct NumericalUncertainty {
  std::vector<std::string> keys;
  Figures figures;     ///< U by name; empty: not known
  std::string reason;  ///< why not
};

/// `quantities`: of the case, by dotted key, SI; `figures`: of the run. Not known where no level has
/// the case's sizes, and where a mean of the run differs from that of its level by more than the level's
/// own U: then the study is of another case.
NumericalUncertainty numerical_uncertainty(const StudiedConvergence& study,
                                           const std::map<std::string, double>& quantities,
                                           const Figures& figures);

}  // namespace tdbd::simulation
