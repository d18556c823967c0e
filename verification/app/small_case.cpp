#include "app/small_case.hpp"

#include <gtest/gtest.h>

namespace tdbd::app {
namespace {

constexpr const char* small_case_text = R"([bit]
file = "bit.toml"
[rock]
edge_length = "4 mm"
wall = "20 mm"
[motion]
rotary_speed = "120 rpm"
rate_of_penetration = "30 m/h"
[time]
step = "2 ms"
duration = "40 ms"
)";

constexpr const char* bit_text = R"(name = "small"
table = "bit.csv"
gage_diameter = "100 mm"
[mesh]
rim_segments = 24
)";

constexpr const char* table_text =
    R"(bit,cutter,blade,zone,dia_mm,r_tip_mm,phi_deg,h_tip_mm,profile_angle_deg,back_rake_deg,side_rake_deg
S,1,1,cone,16,5,0,6,-15,15,0
S,2,2,cone,16,15,180,3.3,-15,15,0
S,3,1,nose,16,25,10,1,0,15,0
S,4,2,nose,16,34,190,1.5,15,15,0
S,5,1,shoulder,16,42,20,5,45,15,0
S,6,2,shoulder,16,47,200,11,70,15,0
)";

}  // namespace

SmallCase::SmallCase() {
  write("case.toml", small_case_text);
  write("bit.toml", bit_text);
  write("bit.csv", table_text);
}

battery::Outcome SmallCase::run(std::vector<std::string> more, const std::string& out,
                                const battery::Surroundings& around) const {
  more.insert(more.begin(), {"run", path("case.toml"), "-o", path(out)});
  return battery::run_tdbd(more, around);
}

void expect_refused(const SmallCase& c, const std::string& message) {
  expect_refusal(c.check(), c.path(message).string());
  expect_refusal(c.run(), c.path(message).string());
  EXPECT_FALSE(std::filesystem::exists(c.path("out")));
}

SmallCaseWithForces::SmallCaseWithForces(const std::string& tables) {
  edit("case.toml", "wall = \"20 mm\"", "wall = \"20 mm\"\nmaterial = \"berea-sandstone\"");
  edit("case.toml", "duration = \"40 ms\"\n",
       "duration = \"40 ms\"\n[forces]\nlaw = \"detournay\"\neps = \"30 MPa\"\nzeta = 0.6\n\n" +
           tables);
}

}  // namespace tdbd::app
