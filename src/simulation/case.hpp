#pragma once

#include <map>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config.hpp"
#include "rock/maintain.hpp"
#include "simulation/measure_plan.hpp"
#include "simulation/motion.hpp"

namespace tdbd::simulation {

enum class RockShape { conforming, flat, file };

/// The rock at the start.
struct RockStart {
  RockShape shape = RockShape::conforming;
  double edge_length = 0.0;  ///< m
  double wall = 0.0;         ///< m, height of the cylindrical wall above the bottom's rim
  double radius = 0.0;       ///< m, flat only; 0: the bit's gage radius
  std::string file;          ///< file only
  double unit = 1.0;         ///< m per unit of the file
  double trim = 0.0;         ///< m: wall higher above the bit's lowest point goes; 0: none does
};

struct TimeGrid {
  double step = 0.0;  ///< s
  long steps = 0;
};

struct MaintenancePlan {
  long every = 5;              ///< steps between maintenances; 0: never
  double shortest_edge = 0.4;  ///< over edge_length
  double longest_edge = 1.6;   ///< over edge_length
  double worst_quality = 0.1;
  double flip_quality = 0.6;  ///< triangles below may flip their longest edge; 0: none does
  rock::Smoothing smoothing = rock::Smoothing::tangential;
  double smooth_quality = 0.5;  ///< vertices of triangles below are smoothed
};

struct OutputPlan {
  long history_every = 1;  ///< steps between rows
  long frames_every = 0;   ///< steps between frames; 0: only the last
};

/// A checked case in SI: everything that a run needs, and its resolved text.
struct Case {
  std::string path;
  std::vector<std::string> files;  ///< all that were read: case, bit, tables, meshes
  bit::Bit bit;
  RockStart rock;
  Motion motion;
  TimeGrid time;
  MaintenancePlan maintenance;
  MeasurePlan measure;
  OutputPlan output;
  std::string resolved;  ///< TOML: all defaults, SI; itself a case that gives the same result
  std::string hash;      ///< of the resolved values and the content of all files
  std::map<std::string, double> quantities;  ///< of the case file, by dotted key, in SI
};

/// Reads and checks everything, runs nothing. Throws InputError that lists every mistake.
Case read_case(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace tdbd::simulation
