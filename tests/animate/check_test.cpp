// builds: clang++
#include <kanexpr/animate/picture.hpp>
#include <models/simple_pendulum.hpp>

#include <gtest/gtest.h>

namespace {

using namespace simple_pendulum;

struct Z : origin<Z, N> {};

template <class... Words>
constexpr std::string_view told() {
  return kanexpr::picture<System, Words...>::mistake.view();
}

using upright = up<-N::x>;
using bob = show<sphere<P, 0.1>>;

TEST(picture_check, finds_nothing_wrong_with_a_sound_picture) {
  EXPECT_EQ((told<upright, ground<-2 * l>, seen_from<N::z>, carried<P>, trace<P, colour<"#aF0019">>, bob,
                  show<wheel<A, P, N::z, l, l / 9>, spinning<u>, opacity<0.2>, named<"disc">>>()),
            "");
}

TEST(picture_check, wants_something_shown_and_up_told) {
  EXPECT_EQ(told<upright>(), "the picture shows nothing");
  EXPECT_EQ(told<bob>(), "the picture does not specify the up direction; add up<vector>");
  EXPECT_EQ((told<upright, bob, ground<>, ground<1>>()), "the picture lists ground<...> twice");
  EXPECT_EQ((told<up<q>, bob>()), "the direction of up is a scalar; it must be a vector");
}

TEST(picture_check, wants_sizes_of_parameters) {
  EXPECT_EQ((told<upright, show<sphere<P, l * cos(q)>>>()),
            "the radius of the sphere at P contains the coordinate q; it may depend only on parameters");
  EXPECT_EQ(
      (told<upright, show<coil<O, P, 0.1, u>>>()),
      "the number of turns of the coil from O to P contains the speed u; it may depend only on parameters");
  EXPECT_EQ((told<upright, show<sphere<P, magnitude(position_of<P, O>)>>>()),
            "the radius of the sphere at P contains the point P; it may depend only on parameters");
  EXPECT_EQ((told<upright, show<box<A, P, 1, l * A::y, 1>>>()),
            "the edge along y of the box at P is a vector; it must be a scalar");
  EXPECT_EQ((told<upright, bob, ground<T>>()),
            "the height of the ground contains the input T; it may depend only on parameters");
}

TEST(picture_check, wants_options_that_fit) {
  EXPECT_EQ((told<upright, show<box<A, P, 1, 1, 1>, spinning<u>>>()),
            "the box at P is spinning but has no axis");
  EXPECT_EQ((told<upright, show<cone<A, P, q, 1, 1>>>()),
            "the axis of the cone at P is a scalar; it must be a vector");
  EXPECT_EQ((told<upright, show<cone<A, P, A::x, 1, 1>, spinning<A::x>>>()),
            "the spin of the cone at P is a vector; it must be a scalar");
  EXPECT_EQ((told<upright, show<cone<A, P, A::x, 1, 1>, spinning<u>, spinning<u>>>()),
            "the cone at P has more than one spinning<...>");
  EXPECT_EQ((told<upright, trace<P, colour<"red">>>()),
            "the colour of the trace at P, red, is not of the form #1f5fa8");
  EXPECT_EQ((told<upright, show<sphere<P, 1>, opacity<0>>>()),
            "the opacity of the sphere at P must be above 0 and at most 1");
  EXPECT_EQ((told<upright, show<sphere<P, 1>, Bob>>()),
            "the sphere at P is shown with Bob, which is not an option of a shape");
}

TEST(picture_check, wants_meshes_in_files_of_known_kinds) {
  EXPECT_EQ((told<upright, files_in<"/robots">, show<mesh<A, P, "Arm.STL">>, show<mesh<A, P, "a.b.dae", l>>,
                  show<mesh<A, P, "../a.obj", 1, -1, l / 2>, colour<"#000000">>>()),
            "");
  EXPECT_EQ((told<upright, show<mesh<A, P, "arm.step">>>()),
            "the file of the mesh at P, arm.step, is not of the type .stl, .dae or .obj");
  for (std::string_view none : {"arm", "stl", ".stl.", "arm.stlx", "", "a.ob", "arm_stl"})
    EXPECT_EQ(kanexpr::mesh_kind_of(none), "") << none;
  EXPECT_EQ((told<upright, show<mesh<A, P, "">>>()), "the mesh at P has no file name");
  EXPECT_EQ((told<upright, show<mesh<A, P, 0.001>>>()), "the mesh at P has no file name");
  EXPECT_EQ((told<upright, show<mesh<A, P, "a.stl", 1, 2>>>()),
            "the mesh at P has two scales; it takes one, or one along each axis");
  EXPECT_EQ((told<upright, show<mesh<A, P, "a.stl", 1, 2, 3, 4>>>()),
            "the mesh at P has more than three scales; it takes one, or one along each axis");
  EXPECT_EQ((told<upright, show<mesh<A, P, "a.stl", 1, q, 1>>>()),
            "the scale along y of the mesh at P contains the coordinate q; it may depend only on parameters");
  EXPECT_EQ((told<upright, bob, files_in<"a">, files_in<"b">>()), "the picture lists files_in<...> twice");
}

TEST(picture_check, wants_shapes_within_show) {
  EXPECT_EQ((told<upright, show<Bob>>()), "the picture shows Bob, which is not a shape");
  EXPECT_EQ((told<upright, sphere<P, 1>>()),
            "sphere<...> is a shape, not an element of the picture; wrap it in show<...>");
  EXPECT_EQ((told<upright, bob, colour<"#ffffff">>()), "colour is not an element of a picture");
}

using at_pivot = station<A, O, A::x>;
using at_bob = station<A, P, A::x>;

TEST(picture_check, finds_nothing_wrong_with_sound_curves) {
  EXPECT_EQ((told<upright, show<cable<l / 50, O, P>>, show<sweep<i_section<0.1, l, 0.01>, at_pivot, at_bob>>,
                  show<sweep<tapered<airfoil<l, 0.1>, airfoil<l / 2, 0.05>>, at_pivot, at_bob>>>()),
            "");
}

TEST(picture_check, wants_curves_through_two_places) {
  EXPECT_EQ((told<upright, show<cable<0.1, O>>>()), "the cable at O has one point; it needs at least two");
  EXPECT_EQ((told<upright, show<cable<0.1>>>()), "the cable has no points; it needs at least two");
  EXPECT_EQ((told<upright, show<sweep<circle<1>, at_bob>>>()),
            "the sweep at P has one station; it needs at least two");
  EXPECT_EQ((told<upright, show<sweep<circle<1>>>>()), "the sweep has no stations; it needs at least two");
  EXPECT_EQ((told<upright, show<sweep<circle<1>, at_pivot, P>>>()),
            "a sweep passes through P, which is not a station<frame, point, axis>");
  EXPECT_EQ((told<upright, show<sweep<circle<1>, at_pivot, station<A, P, q>>>>()),
            "an axis of the sweep from O to P is a scalar; it must be a vector");
  EXPECT_EQ(
      (told<upright, show<cable<0.1, P, Z>>>()),
      "point Z is attached to the origin Z, but P to the origin O; the displacement between them is unknown");
}

TEST(picture_check, wants_pathways_with_a_place) {
  EXPECT_EQ((told<upright, show<cable<l / 50, through<O, P, O>>>, show<cable<l / 50, straight<O, P>>>,
                  show<cable<0.1, around_cylinder<A, O, A::z, l, O, on_surface<P>, wrapping::clockwise>>>,
                  show<cable<0.1, around_sphere<O, 0.1, P, P>>>>()),
            "");
  EXPECT_EQ((told<upright, show<cable<0.1, given_length<2 * q>>>>()),
            "the picture shows a cable along a pathway of which only the length is given; it has no place");
  EXPECT_EQ((told<upright, show<cable<0.1, through<O, P>>>>()),
            "the pathway of the cable from O to P lacks a point; write through<Point, Via, ..., Other>");
  EXPECT_EQ((told<upright, show<cable<0.1, straight<O, P, O>>>>()),
            "the pathway of the cable from O to O has too many points; write straight<Point, Other>");
  EXPECT_EQ(
      (told<upright, show<cable<q, straight<O, P>>>>()),
      "the radius of the cable from O to P contains the coordinate q; it may depend only on parameters");
  EXPECT_EQ(
      (told<upright, show<cable<0.1, around_cone<A, O, A::z, q, O, P, wrapping::clockwise>>>>()),
      "the size of the surface of the cable from O to P contains the coordinate q; it may depend only on "
      "parameters");
  EXPECT_EQ((told<upright, show<cable<0.1, around_cone<A, O, l, 0.2, O, P, wrapping::clockwise>>>>()),
            "the axis of the surface of the cable from O to P is a scalar; it must be a vector");
  EXPECT_EQ(
      (told<upright, show<cable<0.1, around_sphere<Z, 1, O, P>>>>()),
      "point Z is attached to the origin Z, but O to the origin O; the displacement between them is unknown");
}

TEST(picture_check, wants_profiles) {
  EXPECT_EQ((told<upright, show<sweep<A, at_pivot, at_bob>>>()),
            "the profile of a sweep is A; it must be a profile such as circle<radius>");
  EXPECT_EQ((told<upright, show<sweep<tapered<circle<1>, rectangle<1, l>>, at_pivot, at_bob>>>()),
            "the profile of the sweep from O to P changes from circle to rectangle; both ends must have the "
            "same form");
  EXPECT_EQ((told<upright, show<sweep<tapered<rectangle<1, l>, rectangle<1, u>>, at_pivot, at_bob>>>()),
            "the height of the sweep from O to P contains the speed u; it may depend only on parameters");
}

TEST(picture_check, wants_one_origin) {
  EXPECT_EQ(
      (told<upright, show<rod<Z, P, 0.1>>>()),
      "point P is attached to the origin O, but Z to the origin Z; the displacement between them is unknown");
  EXPECT_EQ(
      (told<upright, trace<P>, carried<Z>>()),
      "point Z is attached to the origin Z, but P to the origin O; the displacement between them is unknown");
}

} // namespace
