#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tdbd::reference {

/// Force of a tooth pressed into flat rock as a power of its depth: F = factor depth^exponent. Its crater is
/// the cap of a sphere.
struct PowerTooth {
  double factor = 0.0;         ///< N/m^exponent
  double exponent = 1.5;       ///< 1
  double sphere_radius = 0.0;  ///< m, of the tooth's end
};

/// Tests of a single tooth: rows of rising depth, from nothing. Between two rows force and radius are
/// linear; deeper than the last row they stay what they are there, because nobody measured more.
struct ToothTable {
  std::vector<double> depth;                           ///< m
  std::vector<double> force;                           ///< N
  std::vector<double> radius;                          ///< m, of the crater
  std::string source = "table of single-tooth tests";  ///< for messages: the file
  std::vector<long> lines = {};                        ///< of that file, one for each row
};

/// What rock answers to a tooth's depth. Ma, Zhou and Deng and the patent of Huang and Cawthorne (thesis
/// 2.2) leave the law open in what we could read; tables of single-tooth tests are the patent's way (from
/// memory). Vertical depth only: neither the angle of entry nor the speed enters.
using ToothLaw = std::variant<PowerTooth, ToothTable>;

/// N; 0 above the rock.
double tooth_force(const ToothLaw& law, double depth);

/// N/m, slope of the force over the depth; 0 beyond a table.
double tooth_stiffness(const ToothLaw& law, double depth);

/// m, of the crater that a tooth of this depth leaves; 0 above the rock.
double crater_radius(const ToothLaw& law, double depth);

/// Depth of the last row of a table, m; infinite for a power.
double deepest_known(const ToothLaw& law);

/// Throws InputError that begins with `model` ("Huang and Cawthorne") and says which row is wrong: depths
/// must rise from 0, forces and radii must begin at 0 and not fall, all finite; a power must be positive.
void check_tooth_law(const ToothLaw& law, std::string_view model);

/// Reads `depth [mm], force [kN], crater_radius [mm]`, in any units, and checks it as above. Lines with '#'
/// tell where the table is from. Throws InputError with file, line, column, found, expected.
ToothTable read_tooth_table(const std::string& path, std::string_view model);

}  // namespace tdbd::reference
