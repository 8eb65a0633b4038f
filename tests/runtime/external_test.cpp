// builds: clang++
// User-defined functions in derivations at run time: printing, listing, evaluation, derivatives and limits.

#include <kanexpr/lower/complex_math.hpp>
#include <kanexpr/runtime/builder.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/runtime/listing.hpp>
#include <kanexpr/symbolic.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/limits/limit.hpp>
#include <kanexpr/symbolic/printing/latex.hpp>
#include <kanexpr/symbolic/printing/print.hpp>

#include <gtest/gtest.h>

#include <array>
#include <complex>

namespace {

using namespace kanexpr;

constexpr coordinate<"q"> q;
constexpr speed<"u"> u;
constexpr parameter<"c"> c;
struct N : inertial_frame<N> {};
struct A : rotated<A, N, q, N::z> {};
struct O : origin<O, N> {};
struct P : offset<P, O, 2 * A::x> {};
struct Bob : particle<Bob, P, 1> {};

struct brush {
  constexpr double operator()(double slip, double load) const { return load * slip / (slip * slip + 2); }
};
struct brush_slopes {
  constexpr std::array<double, 2> operator()(double slip, double load) const {
    const double below = slip * slip + 2;
    return {load * (2 - slip * slip) / (below * below), slip / below};
  }
};
constexpr external<"tyre", brush, brush_slopes> tyre;

struct Braked : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, parameters<c>,
                            bodies<Bob>, loads<torque<A, -c * pow(tyre(u, 1), 2) * N::z>>> {};

TEST(external, is_printed_and_listed) {
  auto system = derive<Braked>();
  ASSERT_EQ(system.mistake(), "");
  EXPECT_EQ(print(system.forcing()), "[-c*tyre(u, 1)^2]");
  EXPECT_NE(latex(system.forcing()).find("-c \\mathrm{tyre}^{2}\\left(u, 1\\right)"), std::string::npos)
      << latex(system.forcing());
  EXPECT_EQ(listing(system, mechanics::quantity::forcing),
            "t1 = tyre(u, 1)\nt2 = t1 * t1\nt3 = c * t2\nt4 = -t3\nforcing = t4\n");
  const symbolic::expression slope = system.linearize().explicit_form().A(1, 1);
  EXPECT_EQ(print(slope), "-c*tyre(u, 1)*tyre_1(u, 1)/2");
  EXPECT_EQ(latex(slope),
            R"(-\frac{c \mathrm{tyre}\left(u, 1\right) \partial_{1} \mathrm{tyre}\left(u, 1\right)}{2})");
}

TEST(external, is_interpreted_as_it_is_compiled) {
  auto system = derive<Braked>();
  auto f = system.function(system.udot());
  for (const double speed : {-6.0, -2.0, 0.0, 0.3, 4.5}) {
    const equations_of_motion<Braked>::state x{{q, 0.5}, {u, speed}};
    const equations_of_motion<Braked>::parameters p{{c, 0.7}};
    EXPECT_EQ(f(x, p)(0), equations_of_motion<Braked>::udot(x, p)(0));
  }
}

/// Without a derivative, which the equations of motion do not need.
constexpr external<"rough", brush> rough;
struct Rough : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<dot(q) == u>, bodies<Bob>,
                           loads<torque<A, -rough(u, 1) * N::z>>> {};

TEST(external, without_derivatives_has_no_linearization) {
  constexpr const char* lacking =
      "the derivative of rough is required but not provided; pass it after the function: external<\"rough\", "
      "function, derivative>";
  auto system = derive<Rough>();
  auto f = system.function(system.udot());
  EXPECT_DOUBLE_EQ(f(Eigen::Vector2d(0, 1))(0), -1.0 / 3 / 4);
  auto linear = system.linearize();
  const symbolic::matrix A = linear.explicit_form().A;
  ASSERT_EQ(linear.failures().size(), 1U);
  EXPECT_EQ(linear.failures()[0], lacking);
  auto slope = system.function(A);
  slope(Eigen::Vector2d(0, 1));
  EXPECT_EQ(slope.status().cause(), lacking);
}

/// Mixed derivatives are identical.
struct product {
  constexpr double operator()(double x, double y) const { return x * x * y; }
};
struct product_slopes {
  constexpr std::array<double, 2> operator()(double x, double y) const { return {2 * x * y, x * x}; }
};
struct product_curvatures {
  constexpr std::array<std::array<double, 2>, 2> operator()(double x, double y) const {
    return {{{2 * y, 2 * x}, {2 * x, 0}}};
  }
};

TEST(external, has_derivatives_of_derivatives) {
  runtime::builder b("N");
  const symbolic::expression x = b.coordinate("x"), y = b.coordinate("y");
  constexpr external<"f", product, product_slopes, product_curvatures> f;
  const symbolic::expression value = f(x, 2 * y);
  EXPECT_EQ(print(differentiate(value, y)), "2*f_2(x, 2*y)");
  const symbolic::expression mixed = differentiate(differentiate(value, y), x);
  EXPECT_EQ(print(mixed), "2*f_1_2(x, 2*y)");
  EXPECT_TRUE(mixed == differentiate(differentiate(value, x), y));
  runtime::interpreter<double> code(lower::tape_of(b.graph(), {mixed.node(), value.node()}));
  double found[2]{};
  code.evaluate([](const lower::load& from) { return from.position == 0 ? 0.5 : 1.5; }, found);
  EXPECT_DOUBLE_EQ(found[0], 2 * 2 * 0.5);
  EXPECT_DOUBLE_EQ(found[1], 0.25 * 3);
  runtime::interpreter<std::complex<double>> by_steps(lower::tape_of(b.graph(), {value.node()}));
  std::complex<double> stepped[1];
  by_steps.evaluate(
      [](const lower::load& from) { return std::complex(from.position == 0 ? 0.5 : 1.5, 1e-30); }, stepped);
  EXPECT_DOUBLE_EQ(stepped[0].imag() / 1e-30, 2 * 0.5 * 3 + 0.25 * 2);
}

TEST(external, has_limits_as_far_as_its_derivatives_go) {
  runtime::builder b("N");
  const symbolic::expression x = b.coordinate("x"), y = b.coordinate("y");
  constexpr external<"f", product, product_slopes> f;
  const symbolic::expression zero = symbolic::constant(b.graph(), symbolic::exactly(0));
  const auto at = [&](const symbolic::expression& e) {
    symbolic::matrix one(b.graph(), 1, 1);
    one(0, 0) = e;
    return symbolic::limits_at(b.graph(), one, {{x, zero}});
  };
  const auto quotient = at((f(x, y) - f(zero, y)) / x);
  EXPECT_TRUE(quotient.singular.empty());
  EXPECT_EQ(print(quotient.values(0, 0)), "f_1(0, y)");
  EXPECT_EQ(print(at(sin(x) * f(x, y) / x).values(0, 0)), "f(0, y)");
  const auto curved = at((f(x, y) - f(zero, y)) / (x * x) - differentiate(f(x, y), x) / x);
  ASSERT_EQ(curved.singular.size(), 1U);
  EXPECT_EQ(curved.singular[0].condition, "no limit was found with the given derivatives of f at x = 0");
}

} // namespace
