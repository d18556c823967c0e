#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "reference/compare/model.hpp"
#include "reference/compare/models/answers.hpp"

namespace tdbd::reference {
namespace {

constexpr std::array all_models{
    Model{"tdbd", "TDBD", "this program", SupportedBits::both, run_tdbd_model, run_tdbd_model},
    Model{"warren-sinor", "Warren and Sinor", "[75]", SupportedBits::drag_bits,
          run_warren_sinor_model},
    Model{"behr", "Behr et al.", "[6]", SupportedBits::drag_bits, run_behr_model},
    Model{"glowka", "Glowka", "[28], [29], [30]", SupportedBits::drag_bits, run_glowka_model},
    Model{"langeveld", "Langeveld", "[49], [50]", SupportedBits::drag_bits, run_langeveld_model,
          run_free_langeveld_model, "depth-of-cut"},
    Model{"hanson-hansen", "Hanson and Hansen", "[33], [20]", SupportedBits::both,
          run_hanson_hansen_model, run_free_hanson_hansen_model, "hanson-hansen"},
    Model{"briggs", "Briggs", "[13], [14]", SupportedBits::roller_bits, run_briggs_model},
    Model{"winters", "Winters, Warren and Onyia", "[77]", SupportedBits::roller_bits,
          run_winters_model},
    Model{"ma-azar", "Ma and Azar", "[56], [54]", SupportedBits::roller_bits, run_ma_azar_model},
    Model{"ma-zhou-deng", "Ma, Zhou and Deng", "[58]", SupportedBits::roller_bits,
          run_ma_zhou_deng_model},
    Model{"huang-cawthorne-1", "Huang and Cawthorne, first way", "[38]", SupportedBits::roller_bits,
          run_huang_cawthorne_1_model},
    Model{"huang-cawthorne-2", "Huang and Cawthorne, second way", "[38]",
          SupportedBits::roller_bits, run_huang_cawthorne_2_model},
    Model{"sheppard-lesage", "Sheppard and Lesage", "[72]", SupportedBits::roller_bits,
          run_sheppard_lesage_model},
};

const Model* find(const std::string& name) {
  const auto found = std::find_if(all_models.begin(), all_models.end(),
                                  [&](const Model& m) { return m.name == name; });
  return found == all_models.end() ? nullptr : &*found;
}

/// Whether the model can use the law of the case's faces.
bool supports_face_law(const Model& model, const CompareCase& c) {
  if (c.rock) return true;
  if (model.own_law == "hanson-hansen") return c.edges.has_value();
  return model.own_law == "depth-of-cut" && c.tips.has_value();
}

/// The law of faces, and properties of the rock, that the model requires.
std::string needed_law(const Model& model) {
  std::string text = "forces.law = \"detournay\"";
  if (!model.own_law.empty()) text += fmt::format(" or \"{}\"", model.own_law);
  if (model.own_law == "hanson-hansen") text += " in rock of one strength";
  if (model.own_law == "depth-of-cut") text += " with kt above 0";
  return text;
}

std::string names_of_all() {
  std::string text;
  for (const Model& m : all_models) text += fmt::format("{}{}", text.empty() ? "" : ", ", m.name);
  return text;
}

}  // namespace

std::span<const Model> models() { return all_models; }

std::string exclusion_reason(const Model& model, const CompareCase& c) {
  const bool cones = !c.ours.bit.cones.empty(), is_earlier = model.name != "tdbd";
  if (model.knows == SupportedBits::drag_bits && cones)
    return fmt::format("{}: found a bit with cones, needs a bit with fixed cutters", model.title);
  if (is_earlier && !cones && model.knows != SupportedBits::roller_bits &&
      c.ours.bit.cutters.empty())
    return fmt::format("{}: found a bit without cutters, needs a table of cutters", model.title);
  if (is_earlier && c.ours.motion.tilt.angle > 0.0)
    return fmt::format("{}: found a bit that leans, needs an upright one", model.title);
  if (is_earlier && !cones && model.knows != SupportedBits::roller_bits &&
      !supports_face_law(model, c))
    return fmt::format("{}: found faces under a law that it does not know, needs {}", model.title,
                       needed_law(model));
  if (is_free(c) && model.free == nullptr)
    return fmt::format("{}: found motion.kind = \"drilling\", needs a bit whose motion is given",
                       model.title);
  if (model.knows == SupportedBits::roller_bits && !cones)
    return fmt::format("{}: found a bit without cones, needs a roller cone bit", model.title);
  return {};
}

std::vector<const Model*> chosen_models(const CompareCase& c,
                                        const std::vector<std::string>& names) {
  std::vector<const Model*> chosen;
  for (const std::string& name : names) {
    if (name == "all") {
      for (const Model& m : all_models)
        if (exclusion_reason(m, c).empty()) chosen.push_back(&m);
      continue;
    }
    const Model* model = find(name);
    if (model == nullptr)
      throw InputError(fmt::format("compare.models: found '{}', expected all or some of: {}", name,
                                   names_of_all()));
    if (const std::string why = exclusion_reason(*model, c); !why.empty()) throw InputError(why);
    chosen.push_back(model);
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  return chosen;
}

}  // namespace tdbd::reference
