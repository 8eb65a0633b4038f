// builds: clang++ sanitize
// Headers of robots, including unusual and invalid robots.
#include "robots/files.hpp"

#include <kanexpr/robots/header_writer.hpp>
#include <kanexpr/robots/picture_writer.hpp>
#include <kanexpr/robots/read_urdf.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace {

using namespace kanexpr::robots;
using testing::HasSubstr;
using testing::Not;

std::string header_of(const robot& r, const model_options& options = {}) {
  header_writer writer(r, options);
  return writer.cause().empty() ? writer.write("arm", "arm.urdf") : writer.cause();
}

robot robot_of(const std::string& file) {
  const read_robot read = read_urdf(robot_files::path_of(file));
  EXPECT_TRUE(read) << read.cause();
  return read.robot;
}

robot robot_in(const std::string& elements) {
  const read_robot read = read_urdf_text("<robot name='r'>" + elements + "</robot>");
  EXPECT_TRUE(read) << read.cause();
  return read.robot;
}

TEST(header_writer, writes_numbers_with_all_their_digits) {
  EXPECT_EQ(cpp::number(0.1), "0.1");
  EXPECT_EQ(cpp::number(1. / 3), "0.3333333333333333");
  EXPECT_EQ(cpp::number(-0.0), "0");
  EXPECT_EQ(cpp::number(1e-30), "1e-30");
  EXPECT_EQ(cpp::number(123456789012.), "1.23456789012e+11");
  EXPECT_EQ(cpp::along("A", {0, -1, 0.5}), "-A::y + 0.5 * A::z");
  EXPECT_EQ(cpp::along("A", {}), "0.0 * A::x");
}

TEST(header_writer, writes_what_a_person_can_read) {
  const std::string header = header_of(robot_of("arm.urdf"));
  EXPECT_THAT(header, HasSubstr("namespace arm {"));
  EXPECT_THAT(
      header,
      HasSubstr("constexpr coordinate<\"q_shoulder_pitch\", units::implied::angle> q_shoulder_pitch;"));
  EXPECT_THAT(header, HasSubstr("// shoulder-pitch: from shoulder to upper arm"));
  EXPECT_THAT(header, HasSubstr("struct Shoulder : pin<Shoulder, N, axis<own::z>, at<0.4 * N::z>, "
                                "by<q_waist, u_waist>,\n"));
  EXPECT_THAT(header, HasSubstr("struct Forearm : pin<Forearm, Upper_arm, axis<-own::y>, "));
  EXPECT_THAT(header, HasSubstr("motor<Shoulder, T_waist>, joint_friction<Shoulder, 0.6>"));
  EXPECT_THAT(header, HasSubstr("struct Tool : weld<Tool, Forearm,")); // merged, but still available
  EXPECT_THAT(header, HasSubstr("  static constexpr double upper[]{2.5, no_limit, 2.1};"));
  EXPECT_THAT(header_of(robot_of("arm.urdf"), {.damping = false}), Not(HasSubstr("joint_friction")));
  EXPECT_THAT(header_of(robot_of("arm.urdf"), {.friction = dry_friction{}}),
              HasSubstr("friction<Shoulder, 1, coulomb_friction<constant<0.2, units::implied::torque>,"));
  EXPECT_THAT(header_writer(robot_of("arm.urdf"), {}).write("units", ""),
              HasSubstr("constexpr input<\"T_waist\", kanexpr::units::implied::torque> T_waist;"));
  EXPECT_THAT(header_of(robot_of("arm.urdf"), {.stops = limit_stops{}}),
              HasSubstr("stop<Shoulder, -2.5, 2.5, 1000, 1, 0.001>"));
}

TEST(header_writer, writes_bodies_without_inertia) {
  EXPECT_THAT(header_of(robot_in("<link name='base'/><link name='bob'><inertial><origin xyz='0 0 -1'/>"
                                 "<mass value='2'/><inertia ixx='0' iyy='0' izz='0' ixy='0' iyz='0' ixz='0'/>"
                                 "</inertial></link><joint name='j' type='continuous'><parent link='base'/>"
                                 "<child link='bob'/><axis xyz='0 1 0'/></joint>")),
              HasSubstr("body<2, -own::z, inertia<own, 0.0, 0.0, 0.0>>"));
}

// A mimic joint has no coordinate: its leader determines its location.
TEST(header_writer, writes_joints_that_follow_others) {
  const std::string header = header_of(robot_of("gripper.urdf"));
  EXPECT_THAT(header, HasSubstr("at<(1.2 * q_left_slide + 0.004) * Right_finger_start::y>"));
  EXPECT_THAT(header,
              HasSubstr("home<constant<-2.04, units::implied::angle_per_length> * q_left_slide + 0.3432,\n"));
  EXPECT_THAT(header, HasSubstr("joints<Hand, Left_finger, Right_finger_start, Right_finger, "));
}

TEST(header_writer, writes_parameters_and_their_values) {
  const std::string header = header_of(robot_of("arm.urdf"), {.bind = binding::parameters});
  EXPECT_THAT(
      header,
      HasSubstr("constexpr parameter<\"ixx_Shoulder\", units::implied::moment_of_inertia> ixx_Shoulder;"));
  EXPECT_THAT(header, HasSubstr("  p[m_Shoulder] = 3.7;"));
  EXPECT_THAT(header, HasSubstr("gravity<-g * N::z>"));
}

/// The words of the library that the header uses, with arguments or with axes.
std::set<std::string> words_in(const std::string& header) {
  static const std::regex word("(^|[ <(-])([a-z_]+)(<|::[xyz]|\\(u_)");
  std::set<std::string> all;
  std::istringstream in(header);
  for (std::string line; std::getline(in, line);)
    if (!line.starts_with("//") && !line.starts_with("#"))
      for (std::sregex_iterator at(line.begin(), line.end(), word), end; at != end; ++at)
        all.insert((*at)[2]);
  return all;
}

// A namespace hides a word of the library with the same name.
TEST(header_writer, writes_robots_that_are_called_as_words_of_the_library) {
  std::set<std::string> words;
  for (const char* file : {"arm.urdf", "balancer.urdf", "carts.urdf", "gripper.urdf", "walker.urdf"})
    for (const base_kind base : {base_kind::fixed, base_kind::floating}) {
      robot r = robot_of(file);
      for (joint& j : r.joints) j.friction = j.damping = j.rotor_inertia = 1;
      const model_options options{.base = base, .friction = dry_friction{}, .stops = limit_stops{}};
      for (const std::string& each : words_in(header_writer(r, options).write("arm", ""))) words.insert(each);
    }
  EXPECT_GT(words.size(), 25u);
  for (const std::string& each : words)
    EXPECT_THAT(
        header_writer(robot_of("arm.urdf"), {}).write(each, ""),
        HasSubstr("namespace " + each + " {\n\nusing namespace kanexpr;\nusing kanexpr::" + each + ";\n"));
  EXPECT_THAT(header_of(robot_of("arm.urdf")), Not(HasSubstr("using kanexpr::")));
}

TEST(header_writer, writes_the_gravity_of_the_robot) {
  robot r = robot_of("arm.urdf");
  EXPECT_THAT(header_of(r), HasSubstr("gravity<-9.81 * N::z>"));
  EXPECT_THAT(header_of(r, {.gravity = 3.7}), HasSubstr("gravity<-3.7 * N::z>"));
  EXPECT_EQ(header_of(r, {.gravity = HUGE_VAL}), "the gravity in the model options is not finite");
  r.gravity = vector3{0, 0, -1.62};
  EXPECT_THAT(header_of(r), HasSubstr("gravity<-1.62 * N::z>"));
  r.gravity = vector3{3, 0, -4};
  EXPECT_THAT(header_of(r), HasSubstr("gravity<3 * N::x - 4 * N::z>"));
  EXPECT_THAT(header_of(r, {.bind = binding::parameters}),
              HasSubstr("gravity<g * (0.6 * N::x - 0.8 * N::z)>"));
  EXPECT_THAT(header_of(r, {.bind = binding::parameters}), HasSubstr("  p[g] = 5;"));
  r.gravity = vector3{};
  EXPECT_THAT(header_of(r), HasSubstr("gravity<0.0 * N::x>"));
}

TEST(header_writer, writes_names_that_are_identifiers) {
  const std::string header = header_of(robot_in(
      "<link name='System'/><link name='3 *//\\'/><link name='\xc3\xa9'/>"
      "<joint name='!' type='revolute'><parent link='System'/><child link='3 *//\\'/></joint>"
      "<joint name='&lt;' type='revolute'><parent link='3 *//\\'/><child link='\xc3\xa9'/></joint>"));
  EXPECT_THAT(header, HasSubstr("using System_2 = N;"));
  EXPECT_THAT(header, HasSubstr("struct Link_3 : pin<Link_3, N, axis<own::x>, by<q_joint, u_joint>>"));
  EXPECT_THAT(header, HasSubstr("struct Link : pin<Link, Link_3, axis<own::x>, by<q_joint_2, u_joint_2>>"));
  EXPECT_THAT(header, HasSubstr("// !: from System to 3 *//_\n"));
  EXPECT_THAT(
      header,
      HasSubstr("/// Names in the file: System_2 is System, Link_3 is 3 *//_, Link is __, joint is !, "
                "joint_2 is <.\nnamespace"));
  EXPECT_THAT(header_of(robot_of("gripper.urdf")), Not(HasSubstr("Names in the file")));
  EXPECT_TRUE(is_valid_namespace("arm_2"));
  for (const char* no :
       {"", "2arm", "_arm", "arm_", "a__b", "a-b", "int", "kanexpr", "std", "index", "sinf", "errno"})
    EXPECT_FALSE(is_valid_namespace(no)) << no;
}

TEST(header_writer, writes_what_a_robot_looks_like) {
  const robot arm = robot_of("arm.urdf");
  const std::string picture = picture_writer(arm, {}).write("arm");
  EXPECT_THAT(picture,
              HasSubstr("struct Shoulder_shape : offset<Shoulder_shape, Shoulder, 0.1 * Shoulder::z> {};"));
  EXPECT_THAT(picture, HasSubstr("show<cylinder<Shoulder, Shoulder_shape, Shoulder::x, 0.06, 0.2>,"));
  EXPECT_THAT(picture,
              HasSubstr("show<rod<Upper_arm, Forearm, 0.02>, colour<")); // in place of a mesh
  EXPECT_THAT(picture, HasSubstr("ground<>"));
  EXPECT_THAT(picture_writer(arm, {.base = base_kind::floating}).write("arm"), Not(HasSubstr("ground<>")));
  EXPECT_THAT(picture_writer(robot_of("walker.urdf"), {}).write("walker"),
              HasSubstr("show<sphere<Left_thigh, 0.017>, colour<")); // it is invisible
}

class meshes : public testing::Test {
protected:
  void SetUp() override { std::filesystem::create_directories(root_ / "some robot/urdf"); }
  void TearDown() override { std::filesystem::remove_all(root_); }

  void leave(const std::string& file) const {
    std::filesystem::create_directories((root_ / file).parent_path());
    std::ofstream(root_ / file) << "solid";
  }
  std::string folder() const { return (root_ / "some robot/urdf").string(); }
  /// An arm with one missing mesh and one that exists.
  std::string picture_of(const std::string& mesh, const std::string& origin = "",
                         std::string* note = nullptr) {
    leave("some robot/urdf/hand.dae");
    const robot arm = robot_in(

        "<link name='a'/><link name='b'><visual>" + origin + "<geometry><mesh " + mesh +
        "/></geometry></visual></link><link name='hand'><visual><geometry><mesh filename='hand.dae'/>"
        "</geometry></visual></link>"
        "<joint name='j' type='revolute'><parent link='a'/><child link='b'/></joint>"
        "<joint name='k' type='fixed'><parent link='b'/><child link='hand'/><origin xyz='1 0 "
        "0'/></joint>");
    picture_writer writer(arm, {}, folder());
    const std::string picture = writer.write("arm");
    if (note) *note = writer.note();
    return picture;
  }

  const std::filesystem::path root_ = std::filesystem::weakly_canonical(testing::TempDir()) /
                                      testing::UnitTest::GetInstance()->current_test_info()->name();
};

TEST_F(meshes, are_named_from_the_folder_of_the_file) {
  leave("some robot/urdf/arm.stl");
  std::string note = "none yet";
  const std::string picture = picture_of("filename='arm.stl'", "", &note);
  EXPECT_THAT(picture, HasSubstr("files_in<\"" + folder() + "\">"));
  EXPECT_THAT(picture, HasSubstr("show<mesh<B, B, \"arm.stl\">, colour<"));
  EXPECT_THAT(picture, HasSubstr("show<mesh<Hand, Hand, \"hand.dae\">>"));
  EXPECT_THAT(picture, Not(HasSubstr("rod<")));
  EXPECT_EQ(note, "");
}

TEST_F(meshes, have_scales_and_poses) {
  leave("some robot/urdf/arm.stl");
  EXPECT_THAT(picture_of("filename='arm.stl' scale='0.001 0.001 0.001'"), HasSubstr("\"arm.stl\", 0.001>"));
  EXPECT_THAT(picture_of("filename='arm.stl' scale='1 -1 1'"), HasSubstr("\"arm.stl\", 1, -1, 1>"));
  EXPECT_THAT(picture_of("filename='arm.stl' scale='1 0 1'"),
              Not(HasSubstr("arm.stl"))); // nothing is visible
  const std::string turned = picture_of("filename='arm.stl'", "<origin xyz='0 0 0.1' rpy='0 1.5708 0'/>");
  EXPECT_THAT(turned, HasSubstr("struct B_shape : offset<B_shape, B, 0.1 * B::z> {};"));
  EXPECT_THAT(
      turned,
      HasSubstr("struct B_shape_axes : direction_cosines<B_shape_axes, B, 0, 0, 1, 0, 1, 0, -1, 0, 0> {};"));
  EXPECT_THAT(turned, HasSubstr("show<mesh<B_shape_axes, B_shape, \"arm.stl\">,"));
}

TEST_F(meshes, are_found_in_packages) {
  leave("some robot/meshes/arm.OBJ");
  EXPECT_THAT(picture_of("filename='package://some robot/meshes/arm.OBJ'"),
              HasSubstr("\"../meshes/arm.OBJ\""));
  EXPECT_THAT(picture_of("filename='package://some_robot/meshes/arm.OBJ'"),
              HasSubstr("\"../meshes/arm.OBJ\""));
  EXPECT_THAT(picture_of("filename='model:///some robot/meshes/arm.OBJ'"),
              HasSubstr("\"../meshes/arm.OBJ\""));
  EXPECT_THAT(picture_of("filename='../meshes/arm.OBJ'"), HasSubstr("\"../meshes/arm.OBJ\""));
  const std::string whole = (root_ / "some robot/meshes/arm.OBJ").string();
  EXPECT_THAT(picture_of("filename='file://" + whole + "'"), HasSubstr("\"" + whole + "\""));
  leave("other/arm.stl"); // the package itself takes precedence over similar folders
  leave("some robot/arm.stl");
  EXPECT_THAT(picture_of("filename='package://other/arm.stl'"), HasSubstr("\"../../other/arm.stl\""));
}

TEST_F(meshes, are_rods_where_they_are_not_found) {
  leave("some robot/urdf/arm.step");
  std::string note;
  const std::string picture = picture_of("filename='package://x/arm.stl'", "", &note);
  EXPECT_THAT(picture, HasSubstr("// the mesh package://x/arm.stl of link b was not found\n"));
  EXPECT_THAT(picture, HasSubstr("show<rod<B, Hand, 0.05>"));
  EXPECT_EQ(note, "1 mesh is omitted from the picture: the mesh package://x/arm.stl of link b was not found");
  picture_of("filename='arm.step'", "", &note);
  EXPECT_THAT(note, testing::EndsWith("the mesh arm.step of link b has a format that pages cannot show"));
  for (const char* none : {"filename=''", "filename='package://'", "filename='package:///'", "filename='.'",
                           "filename='file://'", "scale='1 1 1'", "filename='package://some robot/'"})
    EXPECT_THAT(picture_of(none), HasSubstr("show<rod<B")) << none;
  EXPECT_THAT(picture_of("filename='" + std::string(100'000, 'a') + ".stl'"), HasSubstr("show<rod<B"));
}

TEST_F(meshes, may_have_any_name) {
  leave("some robot/urdf/an + \\ odd, \"name\".stl");
  EXPECT_THAT(picture_of("filename='an + \\ odd, &quot;name&quot;.stl'"),
              HasSubstr(R"("an +\040\134 odd,\040\042name\042.stl")"));
}

TEST(header_writer, says_why_there_is_none) {
  EXPECT_EQ(header_of(robot_in("<link name='a'/>")), "no joint of the robot moves, and its base is fixed");
  const std::string indefinite =
      "<inertial><mass value='1'/><inertia ixx='1' iyy='1' izz='1' ixy='2'/></inertial>";
  EXPECT_EQ(header_of(robot_in(
                "<link name='a'/><link name='b'>" + indefinite +
                "</link><joint name='j' type='revolute'><parent link='a'/><child link='b'/></joint>")),
            "the inertia of link b, with the links fixed to it, is indefinite: its moment about some axis is "
            "negative");
  const std::string vast = "<inertial><origin xyz='1e200 0 0'/><mass value='1e200'/></inertial>";
  EXPECT_EQ(header_of(robot_in(
                "<link name='a'/><link name='b'>" + vast + "</link><link name='c'>" + vast +
                "</link><joint name='j' type='revolute'><parent link='a'/><child link='b'/></joint><joint "
                "name='k' type='fixed'><parent link='b'/><child link='c'/><origin xyz='1 0 0'/></joint>")),
            "the values of link b are so large that they overflow");
  std::string many = "<link name='l0'/>";
  for (int i = 1; i < 10000; ++i)
    many += "<link name='l" + std::to_string(i) + "'/><joint name='j" + std::to_string(i) +
            "' type='revolute'><parent link='l" + std::to_string(i - 1) + "'/><child link='l" +
            std::to_string(i) + "'/></joint>";
  EXPECT_EQ(header_of(robot_in(many)), "the robot has 10000 moving links; a model has at most 400");
}

// Each file is read or rejected with a sentence.
TEST(header_writer, survives_broken_files) {
  int read_well = 0, refused = 0;
  robot_files::each_broken(1500, [&](const std::string& text) {
    const read_robot read = read_urdf_text(text);
    EXPECT_EQ(static_cast<bool>(read), read.cause().empty());
    ++(read ? read_well : refused);
    if (!read) return;
    for (const base_kind base : {base_kind::fixed, base_kind::floating}) {
      EXPECT_FALSE(header_of(read.robot, {.base = base, .bind = binding::parameters}).empty());
      static_cast<void>(picture_writer(read.robot, {.base = base}, "/tmp").write("arm"));
    }
  });
  EXPECT_GT(read_well, 300);
  EXPECT_GT(refused, 500);
}

} // namespace
