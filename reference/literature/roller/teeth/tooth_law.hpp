#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tdbd::reference {

/// Force of a tooth pressed into flat rock as a power of its depth: F = factor depth^exponent. Its
/// crater is the cap of a sphere.
struct PowerTooth {
  double factor = 0.0;         ///< N/m^exponent
  double exponent = 1.5;       ///< 1
  double sphere_radius = 0.0;  ///< m, of the tooth's end
};

/// Tests of a single tooth: rows of ascending depth, starting at 0. Force and radius are linear
/// between two rows; beyond the last row they are constant, because there are no measurements.
struct ToothTable {
  std::vector<double> depth;                           ///< m
  std::vector<double> force;                           ///< N
  std::vector<double> radius;                          ///< m, of the crater
  std::string source = "table of single-tooth tests";  ///< the file, for messages
  std::vector<long> lines = {};                        ///< lines of that file, one per row
};

/// The force of the rock as a function of a tooth's depth. Texts available to us on Ma, Zhou and
/// Deng and on the patent of Huang and Cawthorne (thesis 2.2) do not give the law. Tables of
/// single-tooth tests are the patent's method (from memory). Depends only on the vertical depth,
/// not on the angle of entry or the speed.
using ToothLaw = std::variant<PowerTooth, ToothTable>;

/// Force, N; 0 above the rock.
double tooth_force(const ToothLaw& law, double depth);

/// Slope of the force with depth, N/m; 0 beyond a table.
double tooth_stiffness(const ToothLaw& law, double depth);

/// Radius, m, of the crater that a tooth of this depth leaves; 0 above the rock.
double crater_radius(const ToothLaw& law, double depth);

/// Depth of the last row of a table, m; infinite for a power law.
double deepest_known(const ToothLaw& law);

/// Throws InputError that begins with `model` ("Huang and Cawthorne") and names the wrong row:
/// depths must ascend from 0, forces and radii must begin at 0 and not decrease, all finite; a
/// power law must be positive.
void check_tooth_law(const ToothLaw& law, std::string_view model);

/// Reads `depth [mm], force [kN], crater_radius [mm]`, in any units, and checks it as above. Lines
/// that begin with '#' give the source of the table. Throws InputError with file, line, column,
/// found, expected.
ToothTable read_tooth_table(const std::string& path, std::string_view model);

}  // namespace tdbd::reference
