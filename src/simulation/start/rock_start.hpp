#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/measures.hpp"
#include "mesh/surface.hpp"
#include "rock/rock.hpp"
#include "simulation/case/case.hpp"
#include "simulation/case/run_settings.hpp"

namespace tdbd::simulation {

/// Origin of a rock file written at the end of a run, stored in comments of its PLY header.
struct RockStamp {
  long step = 0;          ///< number of steps of the motion before it was written
  double time = 0.0;      ///< s, time of the motion
  std::string case_hash;  ///< hash of the case of the run
};

/// The comment lines without the word `comment`: "tdbd unit m", "tdbd step 60", "tdbd time_s 0.06",
/// "tdbd case_hash 0123".
std::vector<std::string> comments_of(const RockStamp& stamp);

/// The stamp of a file. Nothing if it is no PLY file or lacks one of the comments.
std::optional<RockStamp> read_stamp(const std::filesystem::path& file);

/// If the run continues from a rock file, checks that the stamp of the rock has the time of the
/// motion after its first steps. Otherwise throws InputError that names time.first_step. Rocks
/// without a stamp and motions that start at t = 0 are not checked.
void require_same_time(const Case& c);

/// Estimated needs of a rock before it is created: triangles at the start and those that the wall
/// gains as the hole grows, cells of the index, and memory for both.
struct RockRequirements {
  double triangles = 0.0, cells = 0.0, bytes = 0.0;
};

/// Needs of a surface of this area (m2) within a box, with an index whose cells are two edge
/// lengths wide.
RockRequirements rock_requirements(double area, const mesh::Box& box_W, double edge_length);

/// Memory of a number of triangles, bytes, without the index.
double bytes_of_triangles(double triangles);

/// Needs of the wall that the run adds, and of the index along the path of the bit.
RockRequirements new_wall_requirements(const Case& c);

/// Box of the path of the bit's axis during the run, enlarged by the bit: start, end and the rows
/// of a path.
mesh::Box reach_W(const Case& c);

/// Checks that a rock with this area and box, including the wall that the run adds, fits into the
/// memory of the machine and 32-bit indices. Otherwise throws InputError that names
/// rock.edge_length, the need and a suitable edge length.
void require_memory(const Case& c, double area, mesh::Box box_W);

/// Lower bound of the distance between bit and rock during the motion, m: the distance between the
/// box of the rock and the box of the path of the bit, enlarged by the cutting point farthest from
/// the origin of the bit. 0 means that they may meet. In free motion, the path is that of a bit
/// that follows its top.
double gap_along_path(const Case& c, const mesh::Surface& rock);

/// A warning at `motion` when there is such a gap. A warning at `rock.unit` for a rock from a file
/// that is narrower than half the bit or wider than fifty bits.
std::vector<CaseWarning> reach_warnings(const Case& c, const mesh::Surface& rock);

/// Creates the rock of a case at t = 0 with its index. The surface conforms to the exposure profile
/// of the bit, is flat or rough, has a given meridian, or is read from a file. Throws InputError if
/// a file is not a single open oriented surface, if a file or meridian intersects itself (unless
/// the case disables this check), if the memory of the machine is too small, or if a file belongs
/// to another time than the start of the run (require_same_time).
rock::Rock start_rock(const Case& c);

/// The surface of the rock, with its area and box for estimates of memory.
struct StartSurface {
  mesh::Surface surface;
  double area = 0.0;  ///< m2
  mesh::Box box_W;
};

/// start_rock in two steps. Cases with the same start_surface_key have the same initial surface,
/// each with its own index.
StartSurface start_surface(const Case& c);
rock::Rock start_rock(const Case& c, StartSurface start);

/// A key of all inputs of start_surface except those that can only reject the case. Empty if the
/// surface is read from a file.
std::string start_surface_key(const Case& c);

/// Creates a rock from a surface of this case, with the index that start_rock makes.
rock::Rock indexed_rock(const Case& c, mesh::Surface surface);

}  // namespace tdbd::simulation
