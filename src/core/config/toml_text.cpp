#include "core/config/toml_text.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <sstream>

namespace tdbd {

std::string toml_string(std::string_view text) {
  std::ostringstream out;
  out << toml::toml_formatter{toml::array{text}, toml::format_flags::none};
  const std::string array = out.str();  // [ "text" ]
  const std::size_t first = array.find('"');
  return array.substr(first, array.rfind('"') + 1 - first);
}

std::string toml_texts(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + toml_string(text);
  return "[" + list + "]";
}

std::string toml_vector(const Vec3& v) {
  if (!v.allFinite()) return "";
  return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z());
}

}  // namespace tdbd
