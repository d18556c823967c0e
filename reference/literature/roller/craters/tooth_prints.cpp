#include "reference/literature/roller/craters/tooth_prints.hpp"

#include <algorithm>

namespace tdbd::reference {
namespace {

Crater crater_of(const ToothLaw& law, const PrintOptions& options, const Vec3& tip_W,
                 double depth) {
  const double radius =
      options.shape == CraterShape::cone ? crater_radius(law, depth) : options.sphere_radius;
  return {tip_W, depth, radius, options.shape};
}

double dig_print(const ToothLaw& law, const PrintOptions& options, const Vec3& tip_W, double depth,
                 ZMap& bottom, PrintVolumes& volumes) {
  const double dug = dig(bottom, crater_of(law, options, tip_W, depth));
  volumes.dug += dug;
  return dug;
}

double dig_oldest(ToothPrint& print, const ToothLaw& law, const PrintOptions& options, ZMap& bottom,
                  PrintVolumes& volumes) {
  const std::size_t i = at(print.first);
  print.first = (print.first + 1) % ToothPrint::capacity;
  --print.count;
  return dig_print(law, options, print.way[i], print.depths[i], bottom, volumes);
}

/// Adds a place to the path, unless the tooth has hardly moved since the last one.
void remember(ToothPrint& print, const Vec3& tip_W, double depth, double spacing) {
  if (print.count > 0) {
    const std::size_t last = at((print.first + print.count - 1) % ToothPrint::capacity);
    if ((print.way[last] - tip_W).head<2>().norm() < spacing) {
      if (depth > print.depths[last]) {
        print.way[last] = tip_W;
        print.depths[last] = depth;
      }
      return;
    }
  }
  const std::size_t next = at((print.first + print.count) % ToothPrint::capacity);
  print.way[next] = tip_W;
  print.depths[next] = depth;
  ++print.count;
}

double deepest_of_way(const ToothPrint& print) {
  double deepest = 0.0;
  for (int i = 0; i < print.count; ++i)
    deepest = std::max(deepest, print.depths[at((print.first + i) % ToothPrint::capacity)]);
  return deepest;
}

/// Digs places of the path that are farther behind than the reach of their crater: the tooth has
/// left that rock.
double follow_way(ToothPrint& print, const ToothLaw& law, const PrintOptions& options,
                  const Vec3& tip_W, double depth, ZMap& bottom, PrintVolumes& volumes) {
  double dug = 0.0;
  const bool out = depth <= 0.0;
  while (print.count > 0) {
    const std::size_t i = at(print.first);
    const double reach = std::max(crater_radius(law, print.depths[i]), bottom.cell());
    const bool left = (print.way[i] - tip_W).head<2>().norm() > reach;
    if (!out && !left && print.count < ToothPrint::capacity) break;
    dug += dig_oldest(print, law, options, bottom, volumes);
  }
  if (!out) remember(print, tip_W, depth, 0.5 * bottom.cell());
  if (dug > 0.0 && !out) print.deepest = deepest_of_way(print);
  return dug;
}

/// Volume of the isolated crater of a tooth that has left the rock.
double isolated_print(const ToothPrint& print, const ToothLaw& law, const PrintOptions& options) {
  return isolated_volume(crater_of(law, options, print.deepest_tip, print.deepest));
}

}  // namespace

double print_share(const PrintOptions& options, const ToothPrint& print, double depth) {
  if (depth <= 0.0) return 0.0;
  if (options.release == ToothRelease::elastic || depth >= print.deepest) return 1.0;
  return std::max(0.0, 1.0 - (print.deepest - depth) / options.release_distance);
}

double follow_print(ToothPrint& print, const ToothLaw& law, const PrintOptions& options,
                    const Vec3& tip_W, double depth, ZMap& bottom, PrintVolumes& volumes) {
  double dug = 0.0;
  if (options.path == PrintPath::swept)
    dug = follow_way(print, law, options, tip_W, depth, bottom, volumes);
  else if (depth <= 0.0 && print.deepest > 0.0)
    dug = dig_print(law, options, print.deepest_tip, print.deepest, bottom, volumes);
  if (depth <= 0.0) {
    if (print.deepest > 0.0) volumes.isolated += isolated_print(print, law, options);
    print.deepest = 0.0;
  } else if (depth > print.deepest) {
    print.deepest = depth;
    print.deepest_tip = tip_W;
  }
  return dug;
}

}  // namespace tdbd::reference
