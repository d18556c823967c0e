#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "bit/files/bit_file.hpp"
#include "core/config/config.hpp"
#include "rock/cut/cutting_bit.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/start/borehole.hpp"
#include "simulation/case/case_warning.hpp"
#include "simulation/case/motion.hpp"
#include "simulation/case/plans.hpp"
#include "simulation/case/rock_keys.hpp"
#include "simulation/case/run_keys.hpp"
#include "simulation/case/studied_convergence.hpp"

namespace tdbd::simulation {

/// The rock at the start.
struct RockStart {
  RockShape shape = *rock_keys::shape.fallback;
  double edge_length = 0.0;   ///< m
  double wall = 0.0;          ///< m, height of the cylindrical wall above the bottom's rim
  double radius = 0.0;        ///< m, flat and rough only; 0: the bit's gage radius
  rock::Roughness roughness;  ///< rough only
  std::vector<rock::MeridianPoint> profile;  ///< profile only: from the axis to the boundary
  std::string file;                          ///< file only
  double unit = 1.0;                         ///< m per unit of the file
  IntersectionCheck intersections =
      *rock_keys::intersection_check.fallback;  ///< file and profile only
  double trim = 0.0;  ///< m: wall higher than this above the bit's lowest point goes; 0: none
};

struct TimeGrid {
  double step = 0.0;  ///< s
  long steps = 0;     ///< from the motion's beginning to the run's end
  long first = 0;     ///< steps of the motion that were made before the run begins
};

/// s, after so many steps.
inline double time_at(const TimeGrid& grid, long steps) {
  return grid.step * static_cast<double>(steps);
}

/// Where the case gives what only the rock shows to be wrong: "FILE:LINE: KEY" (Config::place).
struct CasePlaces {
  std::string edge_length, motion, file, profile, first_step;
};

struct MaintenancePlan {
  long every = *maintenance_keys::every.fallback;  ///< steps between maintenances; 0: never
  long rest = *maintenance_keys::rest.fallback;    ///< steps left alone before maintenance
  long longest_wait = *maintenance_keys::longest_wait.fallback;      ///< steps
  long renumber_every = *maintenance_keys::renumber_every.fallback;  ///< steps; 0: never
  double shortest_edge = *maintenance_keys::shortest_edge.fallback;  ///< over edge_length
  double longest_edge = *maintenance_keys::longest_edge.fallback;    ///< over edge_length
  double worst_quality = *maintenance_keys::worst_quality.fallback;
  double flip_quality = *maintenance_keys::flip_quality.fallback;  ///< 0: no triangle flips
  rock::Smoothing smoothing = *maintenance_keys::smoothing.fallback;
  double smooth_quality = *maintenance_keys::smooth_quality.fallback;
};

/// How rock vertices leave the parts that cut.
struct UpdatePlan {
  rock::CuttingOptions cutting;
  int most_passes = static_cast<int>(*update_keys::most_passes.fallback);  ///< of a step
};

struct OutputPlan {
  long history_every = 1;  ///< steps between rows
  long frames_every =
      *output_keys::frames_every.fallback;  ///< steps between frames; 0: only the last
  long checkpoint_every = -1;  ///< steps; negative: as often as costs less than 1 % of the time
  double means_from = 0.0;     ///< s since the run's beginning: steps before do not count in means
  std::vector<StudiedConvergence> convergence = {};  ///< of this case
  EnergyOrderOption energy_order = *output_keys::energy_order.fallback;
  long energy_order_window = *output_keys::energy_order_window.fallback;  ///< steps
  ChainOutput chain = {};  ///< of a string on a chain
};

/// A checked case in SI: everything that a run needs, and its resolved text.
struct Case {
  std::string path;
  std::string title;  ///< as given, or the bit's name
  CasePlaces places;
  std::vector<std::string> files;  ///< all that were read: case, bit, tables, meshes
  bit::Bit bit;
  RockStart rock;
  Motion motion;
  TimeGrid time;
  UpdatePlan update;
  MaintenancePlan maintenance;
  MeasurePlan measure;
  ForcePlan forces;
  WearPlan wear;
  SpallingPlan spalling;
  DrillingPlan drilling;  ///< of a motion that is drilling
  OutputPlan output;
  std::vector<CaseWarning> warnings;
  std::string resolved;  ///< TOML: all defaults, SI; itself a case that gives the same result
  std::string hash;      ///< of the resolved values and the content of all files
  std::string
      bit_hash;  ///< of all that rock::prepare_cutting_bit looks at: bit file, [bit.set], [update]
  std::map<std::string, double> quantities;  ///< of the case file, by dotted key, in SI
};

/// Reads and checks everything, runs nothing. Throws InputError that lists every mistake.
Case read_case(const std::string& path, const std::vector<std::string>& overrides);

/// bit::read_bit, or what gives the same sooner.
using BitReader =
    std::function<bit::BitFile(const std::string& path, bit::DirectionRule, bit::InsideRule,
                               const std::vector<std::string>& overrides)>;
Case read_case(const std::string& path, const std::vector<std::string>& overrides,
               const BitReader& read_bit);

/// The same of a file or text that is parsed already; `path` names it.
Case read_case(Config config, const std::string& path);

}  // namespace tdbd::simulation
