#include "bit/part_kind.hpp"

#include <algorithm>

namespace tdbd::bit {
namespace {

std::string joined_by(char sign, std::string words) {
  std::ranges::replace(words, ' ', sign);
  return words;
}

}  // namespace

std::string_view kind_words(PartKind kind) {
  switch (kind) {
    case PartKind::face:
      return "face";
    case PartKind::chamfer:
      return "chamfer";
    case PartKind::cse:
      return "cse";
    case PartKind::cutter_body:
      return "cutter body";
    case PartKind::gage_pad:
      return "gage pad";
    case PartKind::bit_body:
      return "bit body";
    case PartKind::cone:
      return "cone";
    case PartKind::tooth:
      return "tooth";
  }
  return "unknown";
}

std::string kind_name(PartKind kind) { return joined_by('-', std::string(kind_words(kind))); }

std::string kind_key(PartKind kind) { return joined_by('_', std::string(kind_words(kind))); }

std::vector<std::string_view> part_kind_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    all.reserve(part_kinds.size());
    for (const PartKind kind : part_kinds) all.push_back(kind_name(kind));
    return all;
  }();
  return {names.begin(), names.end()};
}

PartKind part_kind_named(std::string_view name) {
  for (const PartKind kind : part_kinds)
    if (kind_name(kind) == name) return kind;
  return PartKind::face;
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
