// builds: clang++ all
// Robots from SDF files, compared with the same robots from URDF files, and the sentences that report invalid
// files.
#include <kanexpr/robots/articulation.hpp>
#include <kanexpr/robots/read_sdf.hpp>
#include <kanexpr/robots/read_urdf.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

namespace {

using namespace kanexpr::robots;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

read_robot in_model(const std::string& elements, const reading_options& options = {}) {
  return read_sdf_text("<sdf version='1.9'><model name='r'>\n" + elements + "\n</model></sdf>", options);
}

std::string cause_of(const std::string& elements) { return in_model(elements).cause(); }

std::string link_at(const std::string& name, const std::string& pose, const std::string& relative_to) {
  return "<link name='" + name + "'><pose relative_to='" + relative_to + "'>" + pose +
         "</pose><inertial><pose>0.1 0.02 -0.4 0.3 0 0</pose><mass>1.5</mass><inertia><ixx>0.05</ixx>"
         "<iyy>0.06</iyy><izz>0.04</izz><ixy>0.002</ixy><ixz>0</ixz><iyz>-0.001</iyz></inertia></inertial>"
         "</link>\n";
}

std::string joint_of(const std::string& name, const std::string& type, const std::string& parent,
                     const std::string& child, const std::string& more) {
  return "<joint name='" + name + "' type='" + type + "'><parent>" + parent + "</parent><child>" + child +
         "</child>" + more + "</joint>\n";
}

std::string axis(const std::string& xyz, const std::string& more = {}) {
  return "<axis><xyz>" + xyz + "</xyz>" + more + "</axis>";
}

const std::string limits =
    "<limit><lower>-1</lower><upper>2</upper><effort>30</effort><velocity>4</velocity></limit>"
    "<dynamics><damping>0.5</damping><friction>0.1</friction></dynamics>";

void expect_close(const vector3& ours, const vector3& theirs) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(ours[i], theirs[i], 1e-15);
}

/// Equal except for rounding, with the same exact zeros.
void expect_near(const pose& ours, const pose& theirs) {
  expect_close(ours.position, theirs.position);
  for (std::size_t i = 0; i < 3; ++i) {
    expect_close(ours.orientation[i], theirs.orientation[i]);
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(ours.orientation[i][k] == 0, theirs.orientation[i][k] == 0);
  }
}

/// Expects the same bodies with their joints and masses, in the same order.
void expect_same(const read_robot& ours, const read_robot& theirs) {
  ASSERT_TRUE(ours) << ours.cause();
  ASSERT_TRUE(theirs) << theirs.cause();
  const articulation a = articulation_of(ours.robot), b = articulation_of(theirs.robot);
  ASSERT_EQ(a.bodies.size(), b.bodies.size());
  for (std::size_t i = 1; i < a.bodies.size(); ++i) {
    const moving_body &x = a.bodies[i], &y = b.bodies[i];
    EXPECT_EQ(x.parent, y.parent);
    expect_near(x.origin, y.origin);
    EXPECT_NEAR(x.mass, y.mass, 1e-15);
    expect_close(x.center, y.center);
    expect_close({x.inertia.xx, x.inertia.yy, x.inertia.zz}, {y.inertia.xx, y.inertia.yy, y.inertia.zz});
    expect_close({x.inertia.xy, x.inertia.yz, x.inertia.zx}, {y.inertia.xy, y.inertia.yz, y.inertia.zx});
    const joint &j = ours.robot.joints[static_cast<std::size_t>(x.joint)],
                &k = theirs.robot.joints[static_cast<std::size_t>(y.joint)];
    EXPECT_EQ(j.kind, k.kind);
    expect_close(j.axis, k.axis);
  }
}

const std::string inertial =
    "<inertial><origin xyz='0.1 0.02 -0.4' rpy='0.3 0 0'/><mass value='1.5'/><inertia "
    "ixx='0.05' iyy='0.06' izz='0.04' ixy='0.002' ixz='0' iyz='-0.001'/></inertial>";

/// Two links on a wall, with a fixed tool.
const std::string by_urdf =
    "<robot name='r'><link name='wall'/><link name='upper'>" + inertial + "</link><link name='lower'>" +
    inertial + "</link><link name='tool'>" + inertial +
    "</link><joint name='shoulder' type='revolute'><parent link='wall'/><child link='upper'/>"
    "<origin xyz='0 0 1.2'/><axis xyz='0 1 0'/><limit lower='-1' upper='2' effort='30' velocity='4'/>"
    "</joint><joint name='elbow' type='continuous'><parent link='upper'/><child link='lower'/>"
    "<origin xyz='0.2 0 -1' rpy='0.4 0 3.1416'/><axis xyz='0.6 0 0.8'/></joint>"
    "<joint name='hold' type='fixed'><parent link='lower'/><child link='tool'/><origin xyz='0 0.3 0' "
    "rpy='1.5708 0 0'/>"
    "</joint></robot>";

TEST(read_sdf, reads_what_is_in_a_file) {
  const std::string links = link_at("upper", "0 0 1.2 0 0 0", "__model__") +
                            link_at("lower", "0.2 0 -1 0.4 0 3.1416", "upper") +
                            link_at("tool", "0 0.3 0 1.5708 0 0", "lower");
  const read_robot read =
      in_model(links + joint_of("shoulder", "revolute", "world", "upper", axis("0 1 0", limits)) +
               joint_of("elbow", "revolute", "upper", "lower", axis("3 0 4")) +
               joint_of("hold", "fixed", "lower", "tool", ""));
  expect_same(read, read_urdf_text(by_urdf));
  EXPECT_THAT(read.notes, IsEmpty());
  const joint& shoulder = read.robot.joints[0];
  EXPECT_EQ(read.robot.links[static_cast<std::size_t>(shoulder.parent)].name, "world");
  EXPECT_EQ(shoulder.limits.lower, -1);
  EXPECT_EQ(shoulder.limits.effort, 30);
  EXPECT_EQ(shoulder.damping, 0.5);
  EXPECT_EQ(shoulder.friction, 0.1);
}

// The same robot, each pose relative to something else, and the axis of the elbow in the axes of the model.
TEST(read_sdf, knows_poses_relative_to_others) {
  expect_same(
      in_model("<frame name='hook' attached_to='upper'><pose>0.2 0 -1 0.4 0 3.1416</pose></frame>" +
               link_at("tool", "0 0.3 0 1.5708 0 0", "elbow") + link_at("lower", "0 0 0 0 0 0", "elbow") +
               link_at("upper", "0 0 -1 0 0 0", "top") +
               "<frame name='top'><pose>0 0 2.2 0 0 0</pose></frame>" +
               joint_of("shoulder", "revolute", "world", "upper",
                        "<pose>0 0.7 0 0.2 0.3 0.1</pose><axis><xyz expressed_in='upper'>0 1 0</xyz>" +
                            limits + "</axis>") +
               joint_of("elbow", "continuous", "upper", "lower",
                        "<pose relative_to='hook'>0 0 0 0 0 0</pose><axis><xyz "
                        "expressed_in='hook'>0.6 0 0.8</xyz></axis>") +
               joint_of("hold", "fixed", "lower", "tool", "")),
      read_urdf_text(by_urdf));
}

// The same for a joint away from the origin of its child, with an additional link on the axis.
TEST(read_sdf, puts_joints_where_they_are) {
  expect_same(in_model(link_at("a", "1 0 0 0 0 0", "__model__") +
                       joint_of("j", "revolute", "world", "a", "<pose>0 0.5 0 0 0 0</pose>" + axis("0 0 1"))),
              read_urdf_text(
                  "<robot name='r'><link name='world'/><link name='on'/><link name='a'>" + inertial +
                  "</link><joint name='j' type='continuous'><parent link='world'/><child link='on'/><origin "
                  "xyz='1 0.5 0'/><axis xyz='0 0 1'/></joint><joint name='k' type='fixed'><parent link='on'/>"
                  "<child link='a'/><origin xyz='0 -0.5 0'/></joint></robot>"));
}

TEST(read_sdf, reads_universal_joints_and_those_that_follow) {
  const read_robot read = in_model(
      link_at("a", "0 0 1 0 0 0", "__model__") + link_at("b", "0 0 2 0 0 0", "__model__") +
      joint_of("cardan", "universal", "world", "a",
               axis("1 0 0") + "<axis2><xyz>0 1 0</xyz><dynamics><damping>2</damping></dynamics></axis2>") +
      joint_of("slide", "prismatic", "a", "b",
               axis("0 0 1", "<mimic joint='cardan'><multiplier>0.5</multiplier><offset>0.1</offset>"
                             "<reference>0.4</reference></mimic>")));
  ASSERT_TRUE(read) << read.cause();
  const robot& r = read.robot;
  ASSERT_EQ(r.joints.size(), 3u);
  EXPECT_EQ(r.joints[0].axis, (vector3{1, 0, 0}));
  EXPECT_EQ(r.joints[1].name, "cardan_2");
  EXPECT_EQ(r.joints[1].axis, (vector3{0, 1, 0}));
  EXPECT_EQ(r.joints[1].damping, 2);
  EXPECT_EQ(r.links[static_cast<std::size_t>(r.joints[0].child)].name, "cardan_cross");
  ASSERT_TRUE(r.joints[2].mimic);
  EXPECT_EQ(r.joints[2].mimic->leader, 0);
  EXPECT_EQ(r.joints[2].mimic->multiplier, 0.5);
  EXPECT_NEAR(r.joints[2].mimic->offset, -0.1, 1e-16);
}

// Gravity points along −z of the root, so an upright link is added below a rotated root.
TEST(read_sdf, knows_how_a_robot_stands) {
  const read_robot read =
      read_sdf_text("<sdf version='1.9'><world name='w'><model name='m'><pose>5 6 7 0 1.5708 0</pose>" +
                    link_at("a", "0 0 1 0 0 0", "__model__") + link_at("b", "0 0 2 0 0 0", "__model__") +
                    joint_of("j", "revolute", "a", "b", axis("0 1 0")) + "</model></world></sdf>");
  ASSERT_TRUE(read) << read.cause();
  const robot& r = read.robot;
  EXPECT_EQ(r.links[static_cast<std::size_t>(r.root)].name, "m");
  EXPECT_EQ(r.joints.back().origin.orientation, (rotation{{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}}));
}

const std::string arm_of_two = link_at("a", "0 0 1 0 0 0", "__model__") +
                               link_at("b", "0 0 2 0 0 0", "__model__") +
                               joint_of("j", "revolute", "a", "b", axis("0 1 0"));

read_robot in_world(const std::string& model, const std::string& more = {}) {
  return read_sdf_text("<sdf version='1.9'><world name='w'>" + more + "<model name='m'>" + model +
                       "</model></world></sdf>");
}

TEST(read_sdf, knows_where_a_model_is_in_the_world) {
  const read_robot read =
      read_sdf_text("<sdf version='1.9'><world name='w'><frame name='wall'><pose>0 0 5 1.5707963267948966 0 "
                    "0</pose></frame>"
                    "<model name='m' placement_frame='b'><pose relative_to='wall'>1 2 3 0 0 0</pose>" +
                    arm_of_two + joint_of("k", "fixed", "world", "a", "") + "</model></world></sdf>");
  ASSERT_TRUE(read) << read.cause();
  const articulation a = articulation_of(read.robot);
  ASSERT_EQ(a.bodies.size(), 2u);
  EXPECT_EQ(a.bodies[1].origin.orientation, (rotation{{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}}));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_NEAR(a.bodies[1].origin.position[i], (vector3{1, -3, 7})[i], 1e-12);
}

TEST(read_sdf, knows_which_axis_a_joint_follows) {
  for (const auto& [which, leader] : {std::pair("axis", 0), {"axis2", 1}}) {
    const read_robot read = in_model(
        link_at("a", "0 0 1 0 0 0", "__model__") + link_at("b", "0 0 2 0 0 0", "__model__") +
        joint_of("cardan", "universal", "world", "a", axis("1 0 0") + "<axis2><xyz>0 1 0</xyz></axis2>") +
        joint_of("slide", "prismatic", "a", "b",
                 axis("0 0 1", std::string("<mimic joint='cardan' axis='") + which + "'/>")));
    ASSERT_TRUE(read) << read.cause();
    ASSERT_TRUE(read.robot.joints[2].mimic);
    EXPECT_EQ(read.robot.joints[2].mimic->leader, leader);
    EXPECT_THAT(read.notes, IsEmpty());
  }
}

TEST(read_sdf, knows_the_gravity_of_the_world) {
  EXPECT_FALSE(in_model(arm_of_two).robot.gravity);
  EXPECT_EQ(in_world(arm_of_two).robot.gravity, (vector3{0, 0, -9.8})); // the default of SDF
  EXPECT_EQ(in_world(arm_of_two, "<gravity>0.1 0 -1.62</gravity>").robot.gravity, (vector3{0.1, 0, -1.62}));
}

TEST(read_sdf, knows_links_on_which_gravity_does_not_act) {
  const auto light = [](std::string model, const std::string& name) {
    const std::string link = "<link name='" + name + "'>";
    return model.insert(model.find(link) + link.size(), "<gravity>false</gravity>");
  };
  const std::string one = light(arm_of_two, "b");
  const read_robot some = in_world(one);
  EXPECT_THAT(some.notes, IsEmpty());
  EXPECT_FALSE(some.robot.links[0].weightless);
  EXPECT_TRUE(some.robot.links[1].weightless);
  EXPECT_EQ(some.robot.gravity, (vector3{0, 0, -9.8}));
  const read_robot none = in_world(light(one, "a"));
  EXPECT_THAT(none.notes, IsEmpty());
  EXPECT_EQ(none.robot.gravity, vector3{});
  const std::string base = joint_of("k", "fixed", "world", "a", ""); // does not fall in any case
  EXPECT_EQ(in_world(one + base).robot.gravity, vector3{});
  const read_robot still = in_world(light(arm_of_two, "a") + base, "<gravity>0 0 -1</gravity>");
  EXPECT_THAT(still.notes, IsEmpty());
  EXPECT_EQ(still.robot.gravity, (vector3{0, 0, -1}));
}

TEST(read_sdf, notes_what_is_left_out) {
  const auto link_with = [](const std::string& more) { return "<link name='a'>" + more + "</link>"; };
  const std::string ball =
      "<inertial><mass>1</mass><inertia><ixx>1</ixx><iyy>1</iyy><izz>1</izz></inertia></inertial>";
  const auto notes_of = [&](const std::string& model) { return in_model(model).notes; };
  EXPECT_THAT(notes_of(link_with("<inertial><inertia/></inertial>")),
              ElementsAre("line 2: link a has no mass; the default of SDF is 1 kg"));
  EXPECT_THAT(notes_of(link_with("<inertial><mass>2</mass></inertial>")),
              ElementsAre("line 2: link a has no inertia; the default of SDF is 1 kg m^2 about each axis"));
  EXPECT_THAT(
      notes_of(link_with(ball + "<pose>0 0 0 0 0 90</pose>")),
      ElementsAre(
          "line 2: <pose>0 0 0 0 0 90</pose> of link a exceeds a full turn; angles are read in radians"));
  EXPECT_THAT(notes_of(link_with(ball + "<pose degrees='true'>0 0 0 0 0 90</pose>")), IsEmpty());
  EXPECT_THAT(notes_of(link_with(ball + "<velocity_decay><linear>0.1</linear><angular>0</angular>"
                                        "</velocity_decay>\n<kinematic>true</kinematic>")),
              ElementsAre("line 2: <linear>0.1</linear> of velocity_decay is ignored",
                          "line 3: <kinematic>true</kinematic> of link a is ignored"));
  EXPECT_THAT(notes_of(link_with(ball + "\n" + ball)),
              ElementsAre("line 3: link a has a second <inertial>, which is ignored"));
  EXPECT_THAT(
      notes_of(link_with(ball) + "<link name='b'>" + ball + "</link>\n" +
               joint_of("j", "revolute", "a", "b", axis("1 0 0") + "<axis2><xyz>0 1 0</xyz></axis2>")),
      ElementsAre("line 3: the second axis of joint j is ignored"));
  EXPECT_THAT(notes_of(link_with(ball) + "\n<plugin name='sea' filename='sea.so'/>"),
              ElementsAre("line 3: plugin sea is ignored"));
  EXPECT_THAT(notes_of(link_with(ball + "\n<dampping x='1'/>")),
              ElementsAre("line 3: libsdformat reports: XML Element[dampping], child of element[link], not "
                          "defined in SDF; it is ignored"));
  EXPECT_EQ(
      in_model(link_with(ball) + "<model name='inner'><static>1</static>" + link_with(ball) + "</model>")
          .cause(),
      "line 2: the model inner is static");
}

TEST(read_sdf, reads_models_in_models) {
  const read_robot read =
      in_model(link_at("a", "0 0 1 0 0 0", "__model__") + "<model name='hand'><pose>0 0 3 0 0 0</pose>" +
               link_at("palm", "0 0 0 0 0 0", "__model__") + link_at("tip", "0 1 0 0 0 0", "__model__") +
               joint_of("bend", "revolute", "palm", "tip", axis("1 0 0")) + "</model>" +
               joint_of("wrist", "revolute", "a", "hand::palm", axis("0 0 1")));
  ASSERT_TRUE(read) << read.cause();
  ASSERT_EQ(read.robot.joints.size(), 2u);
  EXPECT_EQ(read.robot.joints[0].name, "wrist");
  EXPECT_EQ(read.robot.joints[0].origin.position, (vector3{0, 0, 2}));
  EXPECT_EQ(read.robot.joints[1].name, "hand::bend");
}

TEST(read_sdf, says_what_is_wrong) {
  const std::string two = link_at("a", "0 0 0 0 0 0", "__model__") + link_at("b", "0 0 0 0 0 0", "__model__");
  EXPECT_EQ(read_sdf_text("<robot/>").cause(), "line 1: the root element is <robot>, expected <sdf>");
  EXPECT_THAT(read_sdf_text("<sdf").cause(), HasSubstr("this is not valid XML"));
  EXPECT_EQ(read_sdf_text("<sdf version='x.y'><model name='r'><link name='a'/></model></sdf>").cause(),
            "libsdformat failed: stoi");
  EXPECT_EQ(read_sdf_text("<sdf version='1.9'/>").cause(), "the file has no model, expected one");
  EXPECT_THAT(cause_of(""), HasSubstr("libsdformat reports: A model must have at least one link."));
  EXPECT_EQ(
      cause_of(two + joint_of("j", "ball", "a", "b", "")),
      "line 4: joint j is a ball joint, which is not supported; use fixed, revolute, continuous, prismatic "
      "or universal joints");
  EXPECT_THAT(cause_of(two + joint_of("j", "revolute", "a", "c", axis("0 0 1"))),
              HasSubstr("libsdformat reports: "));
  EXPECT_THAT(cause_of(two), HasSubstr("neither link a nor link b is the child of a joint"));
  EXPECT_THAT(cause_of(two + joint_of("j", "revolute", "a", "b",
                                      axis("0 0 1", "<dynamics><damping>-1</damping></dynamics>"))),
              HasSubstr("the damping of joint j is negative"));
  EXPECT_THAT(cause_of(two + joint_of("j", "revolute", "a", "b", axis("0 0 1", "<mimic joint='k'/>"))),
              HasSubstr("joint j mimics k, which is not a joint"));
  EXPECT_EQ(read_sdf("nowhere/arm.sdf").cause(), "nowhere/arm.sdf cannot be read");
  EXPECT_THAT(
      read_sdf_text(
          "<sdf version='1.9'><world name='w'><model name='m'><link name='a'><inertial><mass>-1</mass>"
          "</inertial></link></model></world></sdf>")
          .cause(),
      HasSubstr("libsdformat reports: A link named a has invalid inertia"));
  const read_robot light = in_model("<link name='a'/>");
  EXPECT_THAT(light.notes, ElementsAre("line 2: link a has no <inertial> element; the default of SDF is 1 kg "
                                       "and 1 kg m^2 about each axis"));
}

// Each file is read or rejected with a sentence.
TEST(read_sdf, survives_broken_files) {
  const std::string whole =
      "<sdf version='1.9'><model name='r'>" + link_at("a", "0 0 1 0 0 0", "__model__") +
      link_at("b", "0.2 0 -1 0.4 0 3.1416", "a") + link_at("c", "1 2 3 0.5 0 0", "b") +
      joint_of("s", "revolute", "world", "a", axis("0 1 0", limits)) +
      joint_of("e", "universal", "a", "b", axis("3 0 4") + "<axis2><xyz>0 1 0</xyz></axis2>") +
      joint_of("p", "prismatic", "b", "c", axis("0 0 1", "<mimic joint='s'/>")) + "</model></sdf>";
  std::mt19937 random(2026);
  const auto any = [&](std::size_t below) { return static_cast<std::size_t>(random()) % below; };
  int read_well = 0, refused = 0;
  for (int i = 0; i < 200; ++i) {
    std::string text = whole;
    for (std::size_t changes = 1 + any(3); changes > 0; --changes) {
      const std::size_t at = any(text.size()), length = 1 + any(20);
      switch (any(3)) {
      case 0: text.erase(at, length); break;
      case 1: text.insert(any(text.size()), text.substr(at, length)); break;
      default: text[at] = "0123456789-.e,<>/\"= nai"[any(23)];
      }
    }
    const read_robot read = read_sdf_text(text);
    EXPECT_EQ(static_cast<bool>(read), read.cause().empty());
    ++(read ? read_well : refused);
  }
  EXPECT_GT(read_well, 5);
  EXPECT_GT(refused, 100);
}

} // namespace
