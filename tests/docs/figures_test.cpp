// builds: clang++ all
// Figures: docs/figures.md and the pages with figures. Each figure is the one that the code on its page
// draws.
#include "docs/joints_loop.hpp"
#include "docs/printed.hpp"
#include "docs/text.hpp"

#include <docs/figures/crane.cpp>
#include <docs/guide/forces/carriage.cpp>
#include <docs/guide/frames/crane.cpp>
#include <docs/guide/kanes-equations/pendulums.cpp>
#include <docs/guide/masses/hammer.cpp>
#include <docs/guide/points/slider.cpp>
#include <docs/guide/vectors/kite.cpp>
#include <docs/tutorials/controller-on-a-board/pendulum.hpp>
#include <docs/tutorials/first-pendulum/pendulum.hpp>
#include <docs/tutorials/optimal-control/crane.hpp>
#include <docs/tutorials/ten-thousand-runs/ball.hpp>

#include <kanexpr/beams.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <kanexpr/robots.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <sstream>
#include <string>

namespace {

using namespace kanexpr;

namespace arm {
#include <docs/guide/joints/arm.cpp>
} // namespace arm

namespace flexible_arm {
#include <docs/guide/beams/arm.cpp>
} // namespace flexible_arm

// The committed figure is what the model of its page draws now; if not, the new one is in the folder of this
// test.
void expect_on_page(const std::string& file, const figure& f) {
  ASSERT_TRUE(f) << file << ": " << f.cause();
  std::ostringstream page;
  page << std::ifstream(KANEXPR_DOCS "/" + file).rdbuf();
  std::string drawn = file;
  for (char& each : drawn)
    if (each == '/') each = '.';
  ASSERT_TRUE(f.write(drawn));
  EXPECT_EQ(f.svg(), page.str()) << "copy " << drawn << " from the folder of this test to docs/" << file;
}

TEST(figures, are_those_of_the_page) {
#include <docs/figures/drawn.cpp>
  expect_on_page("figures/crane.svg", f);
}

TEST(figures, are_those_of_the_guide) {
  expect_on_page("guide/vectors/kite.svg",
                 draw<kite::System>({{"x", 1.5}, {"y", 1.1}, {"u", 0}, {"v", 0}}, {{"m", 1}, {"theta", 0.4}},
                                    {{"D", 1}, {"L", 1}}));
  expect_on_page("guide/frames/crane.svg",
                 draw<jib_crane::System>({{"psi", 0.8}, {"theta", 0.4}, {"u1", 0}, {"u2", 0}},
                                         {{"h", 1}, {"l", 1.4}, {"m", 1}}));
  expect_on_page("guide/points/slider.svg", draw<slider::System>({{"q", 0.5}, {"s", 1.2}, {"u", 0}, {"v", 0}},
                                                                 {{"a", 0.7}, {"m", 1}, {"J", 1}}));
  expect_on_page(
      "guide/masses/hammer.svg",
      draw<hammer::System>({{"q", -1}, {"u", 0}}, {{"d", 0.7}, {"l", 1.5}, {"m", 1}, {"M", 1}, {"J", 0.2}}));
  expect_on_page("guide/forces/carriage.svg",
                 draw<carriage::System>({{"x", 1.5}, {"q", 0.4}, {"u", 0}, {"w", 0}},
                                        {{"m1", 1}, {"m2", 1}, {"l", 1}, {"k", 1}, {"c", 1}, {"g", 9.81}},
                                        {{"F", 1}, {"T", 1}}));
  expect_on_page("guide/kanes-equations/pendulums.svg",
                 draw<pendulums::System>({{"q1", 0.4}, {"q2", 0.9}, {"u1", 0}, {"u2", 0}},
                                         {{"m", 1}, {"l", 1}, {"g", 9.81}}));
}

TEST(figures, are_those_of_beams) {
  expect_on_page("guide/beams/arm.svg",
                 draw<flexible_arm::System>({{"q", 0.3}, {"u", 0}, {"q_Arm", 0.4}, {"u_Arm", 0}},
                                            {{"L", 2}, {"rho", 1}, {"EI", 1}}, {{"T", 1}}));
}

TEST(figures, are_those_of_joints) {
  expect_on_page("guide/joints/arm.svg",
                 draw<arm::System>({{"q_Upper", -0.6}, {"q_Lower", 1}, {"u_Upper", 0}, {"u_Lower", 0}}, {},
                                   {{"T_Upper", 1}, {"T_Lower", 1}},
                                   {.eye = Eigen::Vector3d(0, -1, 0), .names = false}));
  expect_on_page("guide/joints/four_bar.svg", draw<docs::loop::Linkage>({{"q_Crank", 1.2},
                                                                         {"q_Coupler", -0.9266},
                                                                         {"q_Rocker", -2.0374},
                                                                         {"u_Crank", 0},
                                                                         {"u_Coupler", 0},
                                                                         {"u_Rocker", 0}},
                                                                        {{"l0", 2},
                                                                         {"l1", 1},
                                                                         {"l2", 2},
                                                                         {"l3", 1.5},
                                                                         {"d1", 0.5},
                                                                         {"d2", 1},
                                                                         {"d3", 0.75},
                                                                         {"m1", 1},
                                                                         {"m2", 1},
                                                                         {"m3", 1},
                                                                         {"I1", 0.1},
                                                                         {"I2", 0.1},
                                                                         {"I3", 0.1},
                                                                         {"g", 9.81}},
                                                                        {}, {.names = false}));
}

TEST(figures, are_those_of_the_tutorials) {
  expect_on_page(
      "tutorials/first-pendulum/pendulum.svg",
      draw<pendulum::System>({{"q", 0.6}, {"u", 0}}, {{"m", 1}, {"l", 0.5}, {"g", 9.81}, {"c", 0.05}}));
  expect_on_page(
      "tutorials/controller-on-a-board/pendulum.svg",
      draw<inverted::System>({{"q", 0.3}, {"u", 0}}, {{"m", 0.5}, {"l", 0.4}, {"g", 9.81}}, {{"T", 1}}));
  expect_on_page("tutorials/optimal-control/crane.svg",
                 draw<overhead::System>({{"x", 2}, {"q", -0.4}, {"v", 0}, {"w", 0}}, {}, {{"F", 100}}));
  expect_on_page("tutorials/ten-thousand-runs/ball.svg",
                 draw<ball::System>({{"x", 2}, {"y", 1.6}, {"u", 4}, {"v", 1}}, {{"m", 0.62}, {"c", 0.013}}));
  robots::robot_builder arm(
      robots::read_urdf(KANEXPR_SNIPPETS "/docs/tutorials/robot-from-urdf/arm.urdf.xml").robot);
  auto model = derive(arm);
  auto x = arm.at_rest();
  x["q_shoulder"] = 0.5, x["q_elbow"] = 1;
  expect_on_page("tutorials/robot-from-urdf/arm.svg",
                 draw(model, x, {}, {}, {.eye = Eigen::Vector3d(0, -1, 0), .names = false}));
}

TEST(figures, show_the_system_of_these_equations) {
  docs::printed output;
#include <docs/guide/kanes-equations/derived.cpp>
  EXPECT_EQ(output.text(), docs::text("docs/guide/kanes-equations/printed.text"));
}

} // namespace
