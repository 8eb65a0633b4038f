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
  EXPECT_EQ(told<bob>(), "the picture does not say which way is up; write up<vector>");
  EXPECT_EQ((told<upright, bob, ground<>, ground<1>>()), "the picture lists ground<...> twice");
  EXPECT_EQ((told<up<q>, bob>()), "the direction of up is a scalar; it must be a vector");
}

TEST(picture_check, wants_sizes_of_parameters) {
  EXPECT_EQ((told<upright, show<sphere<P, l * cos(q)>>>()),
            "the radius of the sphere at P holds the coordinate q; it may hold parameters only");
  EXPECT_EQ((told<upright, show<coil<O, P, 0.1, u>>>()),
            "the number of turns of the coil from O to P holds the speed u; it may hold parameters only");
  EXPECT_EQ((told<upright, show<sphere<P, magnitude(position_of<P, O>)>>>()),
            "the radius of the sphere at P holds the point P; it may hold parameters only");
  EXPECT_EQ((told<upright, show<box<A, P, 1, l * A::y, 1>>>()),
            "the edge along y of the box at P is a vector; it must be a scalar");
  EXPECT_EQ((told<upright, bob, ground<T>>()),
            "the height of the ground holds the input T; it may hold parameters only");
}

TEST(picture_check, wants_options_that_fit) {
  EXPECT_EQ((told<upright, show<box<A, P, 1, 1, 1>, spinning<u>>>()),
            "the box at P is spinning, and has no axis");
  EXPECT_EQ((told<upright, show<cone<A, P, q, 1, 1>>>()),
            "the axis of the cone at P is a scalar; it must be a vector");
  EXPECT_EQ((told<upright, show<cone<A, P, A::x, 1, 1>, spinning<A::x>>>()),
            "the spin of the cone at P is a vector; it must be a scalar");
  EXPECT_EQ((told<upright, show<cone<A, P, A::x, 1, 1>, spinning<u>, spinning<u>>>()),
            "the cone at P is spinning twice");
  EXPECT_EQ((told<upright, trace<P, colour<"red">>>()),
            "the colour of the trace at P, red, is not of the form #1f5fa8");
  EXPECT_EQ((told<upright, show<sphere<P, 1>, opacity<0>>>()),
            "the opacity of the sphere at P is not above 0 and at most 1");
  EXPECT_EQ((told<upright, show<sphere<P, 1>, Bob>>()),
            "the sphere at P is shown with Bob, which is not an option of a shape");
}

TEST(picture_check, wants_meshes_in_files_of_known_kinds) {
  EXPECT_EQ((told<upright, files_in<"/robots">, show<mesh<A, P, "Arm.STL">>, show<mesh<A, P, "a.b.dae", l>>,
                  show<mesh<A, P, "../a.obj", 1, -1, l / 2>, colour<"#000000">>>()),
            "");
  EXPECT_EQ((told<upright, show<mesh<A, P, "arm.step">>>()),
            "the file of the mesh at P, arm.step, is none of the kinds .stl, .dae and .obj");
  for (std::string_view none : {"arm", "stl", ".stl.", "arm.stlx", "", "a.ob", "arm_stl"})
    EXPECT_EQ(kanexpr::mesh_kind_of(none), "") << none;
  EXPECT_EQ((told<upright, show<mesh<A, P, "">>>()), "the mesh at P names no file");
  EXPECT_EQ((told<upright, show<mesh<A, P, 0.001>>>()), "the mesh at P names no file");
  EXPECT_EQ((told<upright, show<mesh<A, P, "a.stl", 1, 2>>>()),
            "the mesh at P has two scales; it has one, or one along each axis");
  EXPECT_EQ((told<upright, show<mesh<A, P, "a.stl", 1, 2, 3, 4>>>()),
            "the mesh at P has more than three scales; it has one, or one along each axis");
  EXPECT_EQ((told<upright, show<mesh<A, P, "a.stl", 1, q, 1>>>()),
            "the scale along y of the mesh at P holds the coordinate q; it may hold parameters only");
  EXPECT_EQ((told<upright, bob, files_in<"a">, files_in<"b">>()), "the picture lists files_in<...> twice");
}

TEST(picture_check, wants_shapes_within_show) {
  EXPECT_EQ((told<upright, show<Bob>>()), "the picture shows Bob, which is not a shape");
  EXPECT_EQ((told<upright, sphere<P, 1>>()),
            "sphere<...> stands among the words of the picture; write show<...> around it");
  EXPECT_EQ((told<upright, bob, colour<"#ffffff">>()), "colour is not a word of a picture");
}

TEST(picture_check, wants_one_origin) {
  EXPECT_EQ((told<upright, show<rod<Z, P, 0.1>>>()),
            "point P hangs on the origin O, and Z on the origin Z: the way between them is not known");
  EXPECT_EQ((told<upright, trace<P>, carried<Z>>()),
            "point Z hangs on the origin Z, and P on the origin O: the way between them is not known");
}

} // namespace
