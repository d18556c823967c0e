#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "simulation/case/run_settings.hpp"
#include "simulation/result/run.hpp"
#include "simulation/study/convergence_output.hpp"
#include "verification/simulation/result_files.hpp"

namespace tdbd::simulation::studied_convergence_test {

using Json = nlohmann::json;

/// Weight 10 + 4 h, h from 1 to 1/4, uncertain by 0.75 at the finest; torque a tenth of the weight.
Json of_weight() {
  Json study{{"keys", {"time.step"}}, {"levels", Json::array()}};
  for (const double h : {1.0, 0.5, 0.25})
    study["levels"].push_back(
        {{"sizes", {h}},
         {"state",
          {{"wob_mean", {10.0 + 4.0 * h}}, {"tob_mean", {1.0 + 0.4 * h}}, {"y", {h, h}}}}});
  study["variables"] = {{"wob_mean", {{"uncertainty", {{"value", 0.75}}}}},
                        {"tob_mean", {{"uncertainty", nullptr}}},
                        {"y", {{"uncertainty", {{"value", 9.0}}}}}};
  return study;
}

std::string written(const Json& json) {
  const std::string file = (test_folder() / "convergence.json").string();
  std::ofstream(file) << json;
  return file;
}

StudiedConvergence studied() { return read_studied_convergence(written(of_weight())).front(); }

TEST(StudiedConvergence, reads_one_study_or_a_list) {
  const StudiedConvergence s = studied();
  EXPECT_EQ(s.keys, (std::vector<std::string>{"time.step"}));
  ASSERT_EQ(s.levels.size(), 3U);
  EXPECT_EQ(s.levels[1].sizes, (std::vector{0.5}));
  EXPECT_EQ(s.levels[1].figures, (Figures{{"wob_mean_n", 12.0}, {"tob_mean_n_m", 1.2}}));
  EXPECT_EQ(s.left, (Figures{{"wob_mean_n", 0.75}})) << "an uncertainty of null is not known";
  EXPECT_EQ(read_studied_convergence(written({of_weight(), of_weight()})).size(), 2U);
}

/// The distance from the finest level, and what is left there.
TEST(NumericalUncertainty, adds_the_distance_from_the_finest_level) {
  for (const auto& [h, u] : {std::pair(1.0, 3.75), std::pair(0.5, 1.75), std::pair(0.25, 0.75)}) {
    const auto found =
        numerical_uncertainty(studied(), {{"time.step", h}}, {{"wob_mean_n", 10.0 + 4.0 * h}});
    EXPECT_EQ(found.figures, (Figures{{"wob_mean_n", u}}));
    EXPECT_EQ(found.reason, "");
  }
}

TEST(NumericalUncertainty, is_not_known_between_levels_or_of_another_case) {
  const auto reason = [](double step, const Figures& figures) {
    const auto found = numerical_uncertainty(studied(), {{"time.step", step}}, figures);
    EXPECT_TRUE(found.figures.empty());
    return found.reason;
  };
  EXPECT_EQ(reason(0.3, {{"wob_mean_n", 11.2}}), "no level of the study has time.step = 0.3");
  const std::string other = "the study is of another case: its level has wob_mean_n = 12, the run ";
  EXPECT_EQ(reason(0.5, {{"wob_mean_n", 13.76}}), other + "13.76");
  EXPECT_EQ(reason(0.5, {{"wob_mean_n", 10.24}}), other + "10.24");
  EXPECT_EQ(reason(0.5, {{"wob_mean_n", NAN}}), other + "nan");
  EXPECT_EQ(reason(0.5, {}), "the study has none of these figures");
  for (const double near : {10.26, 13.74}) {
    const auto found =
        numerical_uncertainty(studied(), {{"time.step", 0.5}}, {{"wob_mean_n", near}});
    EXPECT_EQ(found.figures.at("wob_mean_n"), std::abs(near - 11.0) + 0.75);
  }
}

/// The message after the file's name.
std::string refusal(const Json& json) {
  const std::string file = written(json);
  try {
    read_studied_convergence(file);
  } catch (const InputError& e) {
    const std::string text = e.what();
    EXPECT_EQ(text.rfind(file + ": found ", 0), 0U) << text;
    EXPECT_NE(text.find(", expected a convergence.json, or a list of such objects"),
              std::string::npos)
        << text;
    return text;
  }
  return "";
}

TEST(StudiedConvergence, of_another_file_is_rejected) {
  const auto without = [](const char* key) {
    Json json = of_weight();
    json.erase(key);
    return refusal(json);
  };
  for (const char* key : {"keys", "levels", "variables"})
    EXPECT_NE(without(key).find(std::string("key '") + key + "' not found"), std::string::npos);
  Json json = of_weight();
  json["levels"][0]["sizes"] = {1.0, 2.0};
  EXPECT_NE(refusal(json).find("found 2 sizes for 1 keys"), std::string::npos);
  json = of_weight();
  json["levels"] = Json::array();
  EXPECT_NE(refusal(json).find("found no key or no level"), std::string::npos);
  json = of_weight();
  json["levels"][0]["state"]["wob_mean"] = {"heavy"};
  EXPECT_NE(refusal(json), "");
  const std::string file = (test_folder() / "text").string();
  std::ofstream(file) << "no JSON";
  EXPECT_THROW(read_studied_convergence(file), InputError);
}

/// Every shipped case that names a study is one of its levels.
TEST(StudiedConvergence, of_shipped_cases_has_a_level_of_their_sizes) {
  int found = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(TDBD_SOURCE_DIR "/cases/convergence")) {
    const std::string name = file.path().stem().string();
    const Case c = read_case(TDBD_SOURCE_DIR "/cases/" + name + ".toml", {});
    EXPECT_EQ(c.output.convergence.size(), 2U) << name << ": by step and by edges";
    std::map<std::string, double> sizes = c.quantities;
    sizes["time.step"] = c.time.step;
    for (const StudiedConvergence& study : c.output.convergence) {
      const auto level = std::ranges::find_if(study.levels, [&](const auto& l) {
        return numerical_uncertainty(study, sizes, l.figures).reason.empty();
      });
      EXPECT_NE(level, study.levels.end()) << name << ": " << study.keys.front();
    }
    ++found;
  }
  EXPECT_EQ(found, 9);
}

std::string short_case() { return TDBD_SOURCE_DIR "/cases/drill-bit-b.toml"; }

std::vector<std::string> short_settings() {
  return {"rock.edge_length='6 mm'", "time.duration='40 ms'", "time.step='2 ms'",
          "output.energy_order=off", "output.convergence=''"};
}

/// A study, written and read by runs of its levels, whose summaries contain the uncertainty of
/// their means. The output of `tdbd converge` is read here in another way.
TEST(NumericalUncertainty, is_stored_with_the_means_of_a_run) {
  ConvergencePlan plan{short_case(), short_settings(), {"time.step"}, 3, 2.0, {}};
  const std::filesystem::path folder = test_folder();
  const Convergence c = converge(plan, {});
  write_convergence(folder, c);
  const Json study = Json::parse(to_json(c));
  for (int level = 0; level < 3; ++level) {
    std::vector<std::string> settings = short_settings();
    settings.back() = "output.convergence='" + (folder / "convergence.json").string() + "'";
    settings.push_back("time.step=" + std::to_string(2e-3 / (1 << level)));
    const Json summary = Json::parse(to_json(
        run(read_case(short_case(), settings), {.folder = folder / std::to_string(level)})));
    ASSERT_EQ(summary["uncertainty"]["numerical"].size(), 1U);
    const Json& found = summary["uncertainty"]["numerical"][0];
    EXPECT_EQ(found["of"], Json::array({"time.step"}));
    EXPECT_FALSE(found.contains("reason")) << found;
    for (const auto& [name, key] :
         {std::pair("wob_mean", "wob_mean_n"), std::pair("rop_mean", "rop_mean_m_per_s"),
          std::pair("stick_slip_severity", "stick_slip_severity")}) {
      const double own = study["levels"][at(level)]["state"][name][0],
                   finest = study["levels"][2]["state"][name][0],
                   left = study["variables"][name]["uncertainty"]["value"];
      EXPECT_EQ(found[key].get<double>(), std::abs(own - finest) + left) << name;
    }
  }
  const auto other = read_case(
      short_case(), {"rock.edge_length='6 mm'", "time.duration='40 ms'", "output.energy_order=off",
                     "output.convergence='" + (folder / "convergence.json").string() + "'",
                     "motion.weight_on_bit='20 kN'", "time.step='1 ms'"});
  const Json summary = Json::parse(to_json(run(other, {.folder = folder / "other"})));
  const std::string reason = summary["uncertainty"]["numerical"][0]["reason"];
  EXPECT_EQ(reason.rfind("the study is of another case: its level has ", 0), 0U) << reason;
}

}  // namespace tdbd::simulation::studied_convergence_test
