// The law of a tyre as a function of plain numbers, and laws with given values. The graph is evaluated
// directly.
#pragma once

#include "evaluate_graph.hpp"
#include "magic_formula_reference.hpp"

#include <kanexpr/mechanics/loads/tyre_law.hpp>
#include <kanexpr/mechanics/loads/tyre_model.hpp>
#include <kanexpr/mechanics/loads/tyre_slip.hpp>
#include <kanexpr/symbolic/derivatives/differentiate.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/graph.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace tyre_laws {

namespace mechanics = kanexpr::mechanics;
namespace symbolic = kanexpr::symbolic;
using mechanics::tyre_law;
using symbolic::expression;

// The load, both slips, the camber and the forward speed, in this order.
using inputs = std::array<double, 5>;

class law_function {
public:
  template <class Law>
  explicit law_function(const Law& law_in, double standstill = 0.05) {
    for (const char* called : {"Fz", "x", "y", "gamma", "V"})
      symbols_.push_back(
          symbolic::variable(g_, {symbolic::symbol_kind::parameter, kanexpr::base::name(called),
                                  static_cast<int>(symbols_.size())}));
    const expression v = symbols_[4], least = v.number(symbolic::real(standstill));
    const expression direction = v / mechanics::speed_above(v, least);
    const mechanics::tyre_slip slip{symbols_[0], symbols_[1], symbols_[2], symbols_[3], v, direction};
    const tyre_law law = law_in(g_);
    const mechanics::tyre_effort f = law.at(slip);
    outputs_ = {f.forward, f.lateral, f.overturning, f.rolling, f.aligning};
    for (const expression& each : outputs_)
      for (const expression& by : symbols_) slopes_.push_back(symbolic::differentiate(each, by));
  }
  law_function(const law_function&) = delete;
  law_function& operator=(const law_function&) = delete;

  template <class Number>
  std::array<Number, 5> at(const std::array<Number, 5>& given) const {
    std::array<Number, 5> values{};
    const std::vector<Number> symbols(given.begin(), given.end());
    for (std::size_t i = 0; i < 5; ++i) values[i] = graph_evaluation::evaluate(outputs_[i], symbols);
    return values;
  }
  double slope(std::size_t output, std::size_t input, const inputs& given) const {
    return graph_evaluation::evaluate(slopes_[5 * output + input],
                                      std::vector<double>(given.begin(), given.end()));
  }

private:
  symbolic::graph g_{};
  std::vector<expression> symbols_{}, slopes_{};
  std::array<expression, 5> outputs_{};
};

inline expression number(symbolic::graph& g, double value) { return {g, g.constant(symbolic::real(value))}; }

inline auto linear(double slip, double cornering, double camber, double trail) {
  return [=](symbolic::graph& g) {
    tyre_law law;
    law.model = mechanics::tyre_model::linear;
    law.linear = {number(g, slip), number(g, cornering), number(g, camber), number(g, trail)};
    return law;
  };
}

inline auto brush(double friction, double slip, double cornering, double trail, double camber = 0) {
  return [=](symbolic::graph& g) {
    tyre_law law;
    law.model = mechanics::tyre_model::brush;
    law.brush = {number(g, friction), number(g, slip), number(g, cornering), number(g, trail),
                 number(g, camber)};
    return law;
  };
}

inline auto formula(const magic_formula_reference::tyre_reference& of) {
  return [&of](symbolic::graph& g) {
    tyre_law law;
    law.model = mechanics::tyre_model::magic_formula;
    law.formula.push({});
    tyre_law::coefficients::each_member(law.formula[0], [&](auto&... c) {
      std::size_t i = 0;
      ((c = number(g, of.coefficients.at(i++))), ...);
      EXPECT_EQ(i, of.coefficients.size());
    });
    return law;
  };
}

} // namespace tyre_laws
