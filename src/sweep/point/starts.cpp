#include "sweep/point/starts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bit/files/bit_file.hpp"

namespace tdbd::sweep {
namespace {

namespace sim = simulation;

constexpr double most_bits = 16.0;      // some megabytes each
constexpr double most_triangles = 1e6;  // about 200 bytes each

double or_none(double most, Keeping keeping) { return keeping == Keeping::on ? most : 0.0; }

template <class T>
double one(const T&) {
  return 1.0;
}

double triangles(const sim::StartSurface& s) {
  return static_cast<double>(s.surface.triangle_count());
}

}  // namespace

Starts::Starts(Keeping keeping)
    : files(or_none(most_bits, keeping)),
      bits(or_none(most_bits, keeping)),
      surfaces(or_none(most_triangles, keeping)) {}

sim::Case read_case(const std::string& path, const std::vector<std::string>& overrides,
                    Starts& kept) {
  const auto reader = [&](const std::string& file, bit::DirectionRule directions,
                          bit::InsideRule inside, const std::vector<std::string>& changes) {
    const auto read = [&] {
      return bit::read_bit(file, directions, inside, bit::Densities::as_given, changes);
    };
    const std::string key = fmt::format("{}\n{} {}\n{}", file, static_cast<int>(directions),
                                        static_cast<int>(inside), fmt::join(changes, "\n"));
    return *kept.files.get(key, read, one<bit::BitFile>);
  };
  return sim::read_case(path, overrides, reader);
}

sim::Simulation start(const sim::Case& c, Starts& kept, rock::CuttingBit reused_bit) {
  const auto bit = kept.bits.get(
      c.bit_hash, [&] { return rock::prepare_cutting_bit(c.bit, c.update.cutting); },
      one<rock::CuttingBit>);
  const auto surface = kept.surfaces.get(
      sim::start_surface_key(c), [&] { return sim::start_surface(c); }, triangles);
  reused_bit = *bit;
  return sim::start(c, std::move(reused_bit), *surface);
}

}  // namespace tdbd::sweep
