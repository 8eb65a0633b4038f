// builds: clang++
// The properties in the table of functions, compared with the values of the functions.
#include <kanexpr/symbolic/graph/function_table.hpp>
#include <kanexpr/symbolic/graph/functions.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace {

using namespace kanexpr::symbolic;

constexpr double some[] = {-1e300, -750, -2.5, -0.7, -0.3, 0, 1e-9, 0.3, 0.7, 1, 2.5, 750, 1e300};

template <class Check>
void each_function_at_some_numbers(const Check& check) {
  for (const function_properties& f : functions)
    for (const double x : some) {
      SCOPED_TRACE(std::string(f.name) + " of " + std::to_string(x));
      check(f, x, f.value(x));
    }
}

TEST(functions, are_odd_or_even_as_they_say) {
  each_function_at_some_numbers([](const function_properties& f, double x, double value) {
    if (std::isnan(value)) return;
    if (f.symmetry != parity::none) {
      EXPECT_EQ(f.value(-x), f.symmetry == parity::odd ? -value : value);
    }
  });
}

TEST(functions, stay_where_they_say) {
  each_function_at_some_numbers([](const function_properties& f, double, double value) {
    EXPECT_TRUE(!f.stays_finite || std::isfinite(value));
    EXPECT_FALSE(f.never_negative && value < 0);
  });
}

TEST(functions, are_exact_where_they_say) {
  for (const function_properties& f : functions) {
    if (f.exact_at == function_properties::nowhere) continue;
    EXPECT_EQ(f.value(f.exact_at), std::round(f.value(f.exact_at))) << f.name;
  }
}

TEST(functions, have_their_slope_where_they_are_smooth) {
  each_function_at_some_numbers([](const function_properties& f, double x, double value) {
    if (std::abs(x) > 100 || std::abs(x) < 1e-3 || !f.is_smooth_at(x) || !f.is_smooth_at(x - 1e-3)) return;
    const double step = 1e-5, slope = slope_of(f.op, x, value);
    const double secant = (f.value(x + step) - f.value(x - step)) / (2 * step);
    EXPECT_NEAR(slope, secant, 1e-8 * (1 + std::abs(slope)));
  });
}

TEST(functions, are_the_same_in_the_program) {
  each_function_at_some_numbers([](const function_properties& f, double x, double value) {
    const double there = with_function(f.op, [&]<operation op>() { return function_value<op>(x); });
    EXPECT_EQ(std::isnan(there), std::isnan(value));
    if (std::isnan(value) || there == value) return; // both infinite
    EXPECT_NEAR(there, value, 1e-15 * std::abs(value));
  });
}

template <class Check>
void each_binary_function_at_some_numbers(const Check& check) {
  for (const binary_function_properties& f : binary_functions)
    for (const double a : some)
      for (const double b : some) {
        SCOPED_TRACE(std::string(f.name) + " of " + std::to_string(a) + " and " + std::to_string(b));
        check(f, a, b, f.value(a, b));
      }
}

TEST(functions, of_two_arguments_stay_finite_and_exact_where_they_say) {
  each_binary_function_at_some_numbers(
      [](const binary_function_properties& f, double a, double b, double value) {
        EXPECT_TRUE(!f.stays_finite || std::isfinite(value));
        if (f.is_exact_at(a, b)) {
          EXPECT_EQ(value, std::round(value));
        }
      });
}

TEST(functions, of_two_arguments_have_their_slopes) {
  each_binary_function_at_some_numbers(
      [](const binary_function_properties& f, double a, double b, double value) {
        if (std::abs(a) > 100 || std::abs(a) < 1e-3 || std::abs(b) > 100 || !f.is_smooth_at(a, b)) return;
        const binary_slopes<double> by = binary_slopes_of(f.op, a, b, value);
        const double step = 1e-5;
        EXPECT_NEAR(by.by_a, (f.value(a + step, b) - f.value(a - step, b)) / (2 * step),
                    1e-8 * (1 + std::abs(by.by_a)));
        EXPECT_NEAR(by.by_b, (f.value(a, b + step) - f.value(a, b - step)) / (2 * step),
                    1e-8 * (1 + std::abs(by.by_b)));
        const double rate = with_binary_function(
            f.op, [&]<operation op>() { return binary_rate_of<op>(a, b, value, 0.3, -0.7); });
        EXPECT_NEAR(rate, 0.3 * by.by_a - 0.7 * by.by_b, 1e-14 * (1 + std::abs(rate)));
      });
}

TEST(functions, of_two_arguments_are_the_same_in_the_program) {
  each_binary_function_at_some_numbers(
      [](const binary_function_properties& f, double a, double b, double value) {
        const double there =
            with_binary_function(f.op, [&]<operation op>() { return binary_function<op>::of(a, b); });
        EXPECT_EQ(std::isnan(there), std::isnan(value));
        if (!std::isnan(value)) {
          EXPECT_NEAR(there, value, 1e-15 * std::abs(value));
        }
      });
}

TEST(functions, are_forms_of_their_own) {
  for (const function_properties& f : functions) {
    EXPECT_EQ(form_of(f.op), form::function);
    EXPECT_STREQ(function_name(f.op), f.name);
    EXPECT_EQ(properties_of(f.op).op, f.op);
  }
  for (const binary_function_properties& f : binary_functions) {
    EXPECT_EQ(form_of(f.op), form::binary_function);
    EXPECT_STREQ(function_name(f.op), f.name);
    EXPECT_EQ(binary_properties_of(f.op).op, f.op);
    EXPECT_TRUE(is_binary(f.op) && !is_function(f.op));
  }
  EXPECT_EQ(form_of(operation::negate), form::negate);
  EXPECT_EQ(form_of(operation::symbol), form::leaf);
  EXPECT_EQ(form_of(operation::if_positive), form::selection);
  EXPECT_EQ(form_of(operation::component), form::list_operation);
}

} // namespace
