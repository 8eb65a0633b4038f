// builds: clang++ sanitize
// Invalid robots from programs are rejected with a sentence.
#include <kanexpr/robots/header_writer.hpp>

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <string>

namespace {

using namespace kanexpr::robots;

kanexpr::robots::link massive(const std::string& name) {
  kanexpr::robots::link l;
  l.name = name;
  l.inertial = inertial{1, {}, {0.1, 0.1, 0.1}};
  return l;
}

joint between(int parent, int child, joint_kind is = joint_kind::revolute) {
  joint j;
  j.name = "j" + std::to_string(child);
  j.kind = is;
  j.parent = parent, j.child = child;
  return j;
}

/// A chain of revolute joints.
robot chain(int links, joint_kind is = joint_kind::revolute) {
  robot r;
  r.root = 0;
  for (int l = 0; l < links; ++l) {
    r.links.push_back(massive("l" + std::to_string(l)));
    if (l > 0) r.joints.push_back(between(l - 1, l, is));
  }
  return r;
}

std::string cause_of(const std::function<void(robot&)>& change) {
  robot r = chain(3);
  change(r);
  return header_writer(r, {}).cause();
}

TEST(check_robot, knows_what_is_no_tree) {
  EXPECT_EQ(cause_of([](robot&) {}), "");
  EXPECT_EQ(header_writer(robot(), {}).cause(), "the robot has no links");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].child = 3; }),
            "joint j2 has a parent or a child that is not among the links");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].parent = -1; }),
            "joint j2 has a parent or a child that is not among the links");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].parent = 2; }), "joint j2 connects a link to itself");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].child = 1; }), "joint j2 connects a link to itself");
  EXPECT_EQ(cause_of([](robot& r) { r.joints.pop_back(); }),
            "neither link l0 nor link l2 is the child of a joint; a robot has only one such link, its root");
  EXPECT_EQ(cause_of([](robot& r) { r.joints.push_back(between(2, 0)); }),
            "the joints form a loop: every link is the child of a joint");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[0].parent = 2; }),
            "the joints form a loop: link l1 is its own ancestor");
  EXPECT_EQ(cause_of([](robot& r) { r.root = 1; }),
            "the root of the robot must be link l0, which is not the child of any joint");
}

TEST(check_robot, knows_what_is_no_number) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                   inf = std::numeric_limits<double>::infinity();
  EXPECT_EQ(cause_of([](robot& r) { r.links[2].inertial->mass = nan; }),
            "the mass or the inertia of link l2 is not a finite number");
  EXPECT_EQ(cause_of([](robot& r) { r.links[2].inertial->inertia.zx = inf; }),
            "the mass or the inertia of link l2 is not a finite number");
  EXPECT_EQ(cause_of([](robot& r) { r.links[2].inertial->mass = -1; }), "the mass of link l2 is negative");
  EXPECT_EQ(cause_of([](robot& r) { r.links[2].inertial->center.position[1] = nan; }),
            "the pose of the mass center of link l2 must consist of finite numbers and a rotation matrix");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[0].origin.position[2] = inf; }),
            "the origin of joint j1 must consist of finite numbers and a rotation matrix");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[0].origin.orientation[0][0] = -1; }), // mirrors
            "the origin of joint j1 must consist of finite numbers and a rotation matrix");
  for (const vector3& axis : {vector3{}, {0, 0, 2}, {nan, 0, 1}, {1e-300, 0, 0}, {inf, 0, 0}})
    EXPECT_EQ(cause_of([&](robot& r) { r.joints[0].axis = axis; }),
              "the axis of joint j1 does not have length 1");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].damping = nan; }),
            "the damping, friction or rotor of joint j2 is negative or not finite");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].gear_ratio = inf; }),
            "the damping, friction or rotor of joint j2 is negative or not finite");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].gear_ratio = 0; }), "the gear ratio of joint j2 is 0");
}

TEST(check_robot, knows_who_follows_nobody) {
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].mimic = {0, 2, 0}; }), "");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].mimic = {7, 2, 0}; }),
            "joint j2 mimics a joint that does not exist");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].mimic = {1, 2, 0}; }),
            "joint j2 mimics a joint that in turn mimics it");
  EXPECT_EQ(cause_of([](robot& r) {
              r.joints[0].kind = joint_kind::fixed;
              r.joints[1].mimic = {0, 2, 0};
            }),
            "joint j2 mimics j1, which does not have exactly one coordinate");
  EXPECT_EQ(cause_of([](robot& r) { r.joints[1].mimic = {0, std::numeric_limits<double>::infinity(), 0}; }),
            "joint j2 mimics another joint with a multiplier or offset that is not finite");
}

// A chain and a star of many fixed links form one body and are written quickly.
TEST(check_robot, takes_ten_thousand_links) {
  robot long_one = chain(10000, joint_kind::fixed), star = long_one;
  for (joint& j : star.joints) j.parent = 0;
  for (robot* r : {&long_one, &star}) {
    header_writer writer(*r, {.base = base_kind::floating});
    ASSERT_EQ(writer.cause(), "");
    EXPECT_NE(writer.write("many", "").find("body<10000, "), std::string::npos);
  }
  for (joint& j : long_one.joints) j.kind = joint_kind::revolute;
  EXPECT_EQ(header_writer(long_one, {}).cause(), "the robot has 10000 moving links; a model has at most 400");
}

// Names in other scripts, words of C++ and of the library, and empty names become distinct identifiers.
TEST(check_robot, takes_any_name) {
  robot r = chain(8);
  const char* names[]{"", "class", "N", "pin", "\xe8\xbd\xb4", "a b", "a-b", "kanexpr"};
  for (std::size_t l = 0; l < 8; ++l) r.links[l].name = names[l];
  for (std::size_t j = 0; j < 7; ++j) r.joints[j].name = names[j];
  header_writer writer(r, {.bind = binding::parameters});
  ASSERT_EQ(writer.cause(), "");
  const std::string header = writer.write("odd", "odd.urdf");
  for (const char* called :
       {"using Link = N;", "struct Class : ", "struct N_2 : ", "struct Pin : ", "struct Link_2 : ",
        "struct A_b : ", "struct A_b_2 : ", "struct Kanexpr : ", "> q_joint;", "> q_class;", "> q_N;"})
    EXPECT_NE(header.find(called), std::string::npos) << called;
}

} // namespace
