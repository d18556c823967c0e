#include "reference/simulation/round_cutters.hpp"

#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "core/error.hpp"
#include "core/types.hpp"

namespace tdbd::reference {
namespace {

constexpr double mm = 1e-3;

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream in(line);
  for (std::string word; std::getline(in, word, ',');) {
    if (!word.empty() && word.back() == '\r') word.pop_back();
    words.push_back(word);
  }
  return words;
}

/// Rotations about the cutter's own axes, starting from a cutter whose face normal is along the
/// motion.
Mat3 turned(int axis, double angle) {
  return Eigen::AngleAxisd(angle, Vec3::Unit(axis)).toRotationMatrix();
}

RoundCutter cutter_of(const std::map<std::string, double>& row, double chamfer,
                      double chamfer_angle, int corners) {
  const double phi = row.at("phi_deg") * degree, theta = row.at("profile_angle_deg") * degree;
  RoundCutter c;
  c.radius = 0.5 * row.at("dia_mm") * mm;
  c.corners = corners;
  c.chamfer_width = chamfer;
  c.chamfer_depth = chamfer / std::tan(chamfer_angle);
  const Vec3 radial(std::cos(phi), std::sin(phi), 0.0), forward(-std::sin(phi), std::cos(phi), 0.0);
  c.normal_B = std::sin(theta) * radial + std::cos(theta) * Vec3::UnitZ();
  Mat3 level;  // no rake: X along the motion, -Z into the rock
  level.col(0) = forward;
  level.col(2) = -c.normal_B;
  level.col(1) = level.col(2).cross(forward);
  const Mat3 R = level * turned(1, row.at("back_rake_deg") * degree) *
                 turned(2, row.at("side_rake_deg") * degree);
  const Vec3 tip = row.at("r_tip_mm") * mm * radial - row.at("h_tip_mm") * mm * Vec3::UnitZ();
  c.X_BF = {R, tip + c.radius * R.col(2)};
  return c;
}

}  // namespace

std::vector<RoundCutter> read_round_cutters(const std::string& path, double chamfer,
                                            double chamfer_angle, int corners) {
  std::ifstream in(path);
  std::string line;
  if (!std::getline(in, line)) throw RunError(path + " cannot be read");
  const std::vector<std::string> names = cells(line);
  std::vector<RoundCutter> cutters;
  while (std::getline(in, line)) {
    const std::vector<std::string> words = cells(line);
    std::map<std::string, double> row;
    for (std::size_t i = 0; i < words.size() && i < names.size(); ++i)
      if (names[i].find('_') != std::string::npos) row[names[i]] = std::stod(words[i]);
    if (!row.empty()) cutters.push_back(cutter_of(row, chamfer, chamfer_angle, corners));
  }
  return cutters;
}

double rim_radius(const RoundCutter& cutter, double a) {
  const double side = full_turn / cutter.corners, inner = std::cos(0.5 * side);
  const double from_corner = a - side * std::floor(a / side);
  return cutter.radius * inner / std::cos(from_corner - 0.5 * side);
}

Vec3 rim_point(const RoundCutter& cutter, double a, double up) {
  const double r = rim_radius(cutter, a);
  return cutter.X_BF * Vec3(0.0, r * std::sin(a), -r * std::cos(a) + up);
}

}  // namespace tdbd::reference
