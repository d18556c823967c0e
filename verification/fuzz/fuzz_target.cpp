#include "fuzz/fuzz_target.hpp"

#include <algorithm>
#include <array>

#include "fuzz/readers.hpp"

namespace tdbd::fuzz {
namespace {

/// PLY as text and with bytes have a corpus each: no change of single bytes leads from one to the other.
constexpr std::array<FuzzTarget, 17> targets{{
    {"case", take_case},
    {"rotate", take_rotate_case},
    {"calibration", take_calibration},
    {"bit", take_bit},
    {"set", take_set_words},
    {"cutters", take_cutter_table},
    {"motion", take_motion_table},
    {"torque", take_torque_table},
    {"records", take_records},
    {"stl_text", take_stl},
    {"stl_binary", take_binary_stl},
    {"ply_text", take_ply},
    {"ply_binary", take_ply},
    {"obj", take_obj},
    {"off", take_off},
    {"checkpoint", take_checkpoint},
    {"archive", take_archive},
}};

}  // namespace

std::span<const FuzzTarget> fuzz_targets() { return targets; }

const FuzzTarget* fuzz_target(std::string_view name) {
  const auto* const found = std::ranges::find(targets, name, &FuzzTarget::name);
  return found == targets.end() ? nullptr : found;
}

}  // namespace tdbd::fuzz
