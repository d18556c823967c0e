#include "bit/profile/counted_cutters.hpp"

#include <algorithm>

namespace tdbd::bit {
namespace {

bool counts(const Bit& bit, int cutter) {
  bool has_face = false, face_cuts = false, any_cuts = false;
  for (const Part& part : bit.parts) {
    if (part.cutter != cutter) continue;
    const bool cuts = part.cutting == Cutting::cuts;
    any_cuts = any_cuts || cuts;
    has_face = has_face || part.kind == PartKind::face;
    face_cuts = face_cuts || (part.kind == PartKind::face && cuts);
  }
  return has_face ? face_cuts : any_cuts;
}

}  // namespace

std::vector<int> counted_cutters(const Bit& bit) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i)
    if (counts(bit, static_cast<int>(i))) indices.push_back(static_cast<int>(i));
  return indices;
}

std::vector<Cutter> cutters_at(const Bit& bit, std::span<const int> indices) {
  std::vector<Cutter> cutters;
  for (const int i : indices) cutters.push_back(bit.cutters[static_cast<std::size_t>(i)]);
  return cutters;
}

std::vector<double> among_all(const Bit& bit, std::span<const int> indices,
                              std::span<const double> values, double otherwise) {
  std::vector<double> all(bit.cutters.size(), otherwise);
  for (std::size_t k = 0; k < indices.size(); ++k)
    all[static_cast<std::size_t>(indices[k])] = values[k];
  return all;
}

std::string uncounted_names(const Bit& bit) {
  const std::vector<int> counted = counted_cutters(bit);
  std::string names;
  for (std::size_t i = 0; i < bit.cutters.size(); ++i)
    if (!std::ranges::binary_search(counted, static_cast<int>(i)))
      names += (names.empty() ? "cutter-" : ", cutter-") + std::to_string(bit.cutters[i].id);
  return names;
}

}  // namespace tdbd::bit
