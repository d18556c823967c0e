#pragma once

#include <map>
#include <string>
#include <vector>

#include "bit/bit.hpp"
#include "core/config/config.hpp"
#include "rock/cut/cutting_bit.hpp"
#include "rock/maintain/maintain.hpp"
#include "rock/start/borehole.hpp"
#include "rock/start/rough_bottom.hpp"
#include "simulation/case/drilling_plan.hpp"
#include "simulation/case/force_plan.hpp"
#include "simulation/case/measure_plan.hpp"
#include "simulation/case/motion.hpp"

namespace tdbd::simulation {

enum class RockShape { conforming, flat, rough, profile, file };
enum class IntersectionCheck { full, none };

/// The rock at the start.
struct RockStart {
  RockShape shape = RockShape::conforming;
  double edge_length = 0.0;   ///< m
  double wall = 0.0;          ///< m, height of the cylindrical wall above the bottom's rim
  double radius = 0.0;        ///< m, flat and rough only; 0: the bit's gage radius
  rock::Roughness roughness;  ///< rough only
  std::vector<rock::MeridianPoint> profile;  ///< profile only: from the axis to the boundary
  std::string file;                          ///< file only
  double unit = 1.0;                         ///< m per unit of the file
  IntersectionCheck intersections = IntersectionCheck::full;  ///< file and profile only
  double trim = 0.0;  ///< m: wall higher above the bit's lowest point goes; 0: none does
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

/// Where a case says what shows to be wrong only with the rock: "FILE:LINE: KEY" (Config::place).
struct CasePlaces {
  std::string edge_length, motion, file, profile;
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

/// How a step is found, and which way it goes where the bit leans.
struct UpdatePlan {
  rock::CuttingOptions cutting;
  int most_passes = 1000;  ///< of a step; more are an error
};

/// Whether a bit that forces move observes the order of its energy's residual.
enum class EnergyOrderWish {
  off,
  on,      ///< where that costs at most a tenth of the run's steps
  always,  ///< whatever it costs
};

struct OutputPlan {
  long history_every = 1;   ///< steps between rows
  long frames_every = 0;    ///< steps between frames; 0: only the last
  double means_from = 0.0;  ///< s since the run's beginning: steps before do not count in means
  EnergyOrderWish energy_order = EnergyOrderWish::on;
  long energy_order_window = 24;  ///< steps
};

/// A checked case in SI: everything that a run needs, and its resolved text.
struct Case {
  std::string path;
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
  DrillingPlan drilling;  ///< of a motion that is drilling
  OutputPlan output;
  std::string resolved;  ///< TOML: all defaults, SI; itself a case that gives the same result
  std::string hash;      ///< of the resolved values and the content of all files
  std::map<std::string, double> quantities;  ///< of the case file, by dotted key, in SI
};

/// Reads and checks everything, runs nothing. Throws InputError that lists every mistake.
Case read_case(const std::string& path, const std::vector<std::string>& overrides);

}  // namespace tdbd::simulation
