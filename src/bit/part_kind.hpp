#pragma once

#include <array>
#include <string>

namespace tdbd::bit {

/// What a part is; the kind selects data (name, colour, force law), not a class. Thesis: 3.1.
enum class PartKind { face, chamfer, cse, cutter_body, gage_pad, bit_body, cone, tooth };

inline constexpr std::array part_kinds{PartKind::face,        PartKind::chamfer,  PartKind::cse,
                                       PartKind::cutter_body, PartKind::gage_pad, PartKind::bit_body,
                                       PartKind::cone,        PartKind::tooth};

/// The name of a kind in results and bit files: "face", "cutter-body", "gage-pad", ...
std::string kind_name(PartKind kind);

/// Whether cutters are made of parts of this kind.
bool belongs_to_a_cutter(PartKind kind);

/// A part's say in whether it removes rock. Thesis: 3.1. A part that rubs leaves the rock as it is;
/// how near it comes to the rock that the cutters leave is measured (body/rubbing.hpp).
enum class Cutting { cuts, rubs, never };

/// "yes", "rubs" or "no".
std::string cutting_name(Cutting cutting);

}  // namespace tdbd::bit
