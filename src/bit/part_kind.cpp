#include "bit/part_kind.hpp"

namespace tdbd::bit {

std::string kind_name(PartKind kind) {
  switch (kind) {
    case PartKind::face:
      return "face";
    case PartKind::chamfer:
      return "chamfer";
    case PartKind::cse:
      return "cse";
    case PartKind::cutter_body:
      return "cutter-body";
    case PartKind::gage_pad:
      return "gage-pad";
    case PartKind::bit_body:
      return "bit-body";
    case PartKind::cone:
      return "cone";
    case PartKind::tooth:
      return "tooth";
  }
  return "unknown";
}

bool belongs_to_a_cutter(PartKind kind) {
  return kind == PartKind::face || kind == PartKind::chamfer || kind == PartKind::cse ||
         kind == PartKind::cutter_body;
}

std::string cutting_name(Cutting cutting) {
  switch (cutting) {
    case Cutting::cuts:
      return "yes";
    case Cutting::rubs:
      return "rubs";
    case Cutting::never:
      break;
  }
  return "no";
}

}  // namespace tdbd::bit
