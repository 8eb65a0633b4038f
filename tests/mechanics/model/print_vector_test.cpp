// builds: clang++ sanitize
#include <kanexpr/mechanics/model/print_vector.hpp>

#include <gtest/gtest.h>

#include <string>

namespace {

using namespace kanexpr::mechanics;
using kanexpr::symbolic::graph;

class printed : public testing::Test {
protected:
  int frame_called(const char* name) {
    frame f;
    f.called = name;
    return system.frames.push(f);
  }

  graph g;
  mechanism system{g};
  expression u1 = system.speed("u1"), u2 = system.speed("u2"), u3 = system.speed("u3"),
             m = system.parameter("m"), r = system.parameter("r"), ixx = system.parameter("Ixx"),
             q2 = system.coordinate("q2"), zero = system.zero(), one = system.one();
  int n = frame_called("N"), l = frame_called("L"), link = frame_called("Link<3>"), b12 = frame_called("B12");
};
using print_vector = printed;
using print_dyadic = printed;

TEST_F(print_vector, names_frames_and_axes) {
  vector v;
  v.add(l, {u1, u2 + u3, zero});
  EXPECT_EQ(print(system, v), "u1*L.x + (u2 + u3)*L.y");
  EXPECT_EQ(print(system, v, basis_style::one_two_three), "u1*L.1 + (u2 + u3)*L.2");
  EXPECT_EQ(print(system, v, basis_style::ijk), "u1*L.i + (u2 + u3)*L.j");
  EXPECT_EQ(latex(system, v), R"(u_1\,\hat{\mathbf{l}}_{x} + \left(u_2 + u_3\right)\,\hat{\mathbf{l}}_{y})");
  EXPECT_EQ(latex(system, v, basis_style::ijk),
            R"(u_1\,\hat{\mathbf{l}}_{i} + \left(u_2 + u_3\right)\,\hat{\mathbf{l}}_{j})");
}

TEST_F(print_vector, joins_parts_by_their_signs) {
  vector v;
  v.add(n, {-one, one, -(u1 * u2)});
  v.add(l, {-u1 - u2, u1 - u2, m * r * r / 4});
  EXPECT_EQ(print(system, v), "-N.x + N.y - u1*u2*N.z - (u1 + u2)*L.x + (u1 - u2)*L.y + m*r^2/4*L.z");
}

TEST_F(print_vector, keeps_digits_as_subscripts) {
  vector v;
  v.add(link, {u1, zero, zero});
  v.add(b12, {zero, -u3 / cos(q2), zero});
  EXPECT_EQ(print(system, v), "u1*Link<3>.x - u3/cos(q2)*B12.y");
  EXPECT_EQ(latex(system, v),
            R"(u_1\,\hat{\mathbf{link}}_{3,x} - \frac{u_3}{\cos q_2}\,\hat{\mathbf{b}}_{12,y})");
  EXPECT_EQ(latex(system, v, basis_style::one_two_three),
            R"(u_1\,\hat{\mathbf{link}}_{3,1} - \frac{u_3}{\cos q_2}\,\hat{\mathbf{b}}_{12,2})");
}

TEST_F(print_vector, names_common_parts_of_a_long_text) {
  const expression part = m * u1 * cos(q2) + r * u2 * sin(q2);
  vector v;
  v.add(l, {part, -part * u3, zero});
  EXPECT_EQ(print(system, v, basis_style::xyz, 0), "z1*L.x - u3*z1*L.y\n"
                                                   "where\n"
                                                   "  z1 = m*u1*cos(q2) + r*u2*sin(q2)");
  EXPECT_EQ(latex(system, v, basis_style::xyz, 0),
            "\\begin{aligned}\n& z_1\\,\\hat{\\mathbf{l}}_{x} - u_3 z_1\\,\\hat{\\mathbf{l}}_{y} \\\\\n"
            "& \\text{where} \\\\\nz_1 &= m u_1 \\cos q_2 + r u_2 \\sin q_2\n\\end{aligned}");
  EXPECT_EQ(print(system, v).find("where"), std::string::npos);
  matrix3 value(g);
  value(0, 0) = value(1, 1) = part;
  value(2, 2) = one;
  dyadic d;
  d.add(l, l, value);
  EXPECT_EQ(print(system, d, basis_style::xyz, 0), "z1*(L.x|L.x) + z1*(L.y|L.y) + (L.z|L.z)\n"
                                                   "where\n"
                                                   "  z1 = m*u1*cos(q2) + r*u2*sin(q2)");
}

TEST_F(print_vector, may_vanish) {
  vector v;
  EXPECT_EQ(print(system, v), "0");
  v.add(n, {zero, zero, zero});
  EXPECT_EQ(print(system, v), "0");
  EXPECT_EQ(latex(system, v), "0");
}

TEST_F(print_dyadic, has_dyads) {
  kanexpr::mechanics::matrix3 value(g);
  value(0, 0) = ixx;
  value(1, 1) = m * r * r / 2;
  value(0, 2) = u1 - u2;
  value(2, 2) = one;
  dyadic d;
  d.add(l, l, value);
  EXPECT_EQ(print(system, d), "Ixx*(L.x|L.x) + (u1 - u2)*(L.x|L.z) + m*r^2/2*(L.y|L.y) + (L.z|L.z)");
  EXPECT_EQ(print(system, (-one) * d, basis_style::ijk),
            "-Ixx*(L.i|L.i) + (u2 - u1)*(L.i|L.k) - m*r^2/2*(L.j|L.j) - (L.k|L.k)");
}

TEST_F(print_dyadic, may_mix_frames_and_vanish) {
  matrix3 value(g);
  value(0, 1) = ixx;
  dyadic d;
  d.add(n, l, value);
  EXPECT_EQ(print(system, d, basis_style::one_two_three), "Ixx*(N.1|L.2)");
  EXPECT_EQ(latex(system, d), R"(\mathrm{Ixx}\,\hat{\mathbf{n}}_{x} \otimes \hat{\mathbf{l}}_{y})");
  EXPECT_EQ(print(system, dyadic()), "0");
}

} // namespace
