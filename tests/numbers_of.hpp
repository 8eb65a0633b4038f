#pragma once

#include <kanexpr/base/sequence.hpp>
#include <kanexpr/lower/tape.hpp>
#include <kanexpr/runtime/interpreter.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>
#include <kanexpr/symbolic/graph/matrix.hpp>

#include <Eigen/Core>

/// The values of the entries of a matrix of expressions. `value_of(load)` returns the value of a symbol.
template <class ValueOf>
Eigen::MatrixXd numbers_of(const kanexpr::symbolic::matrix& wanted, const ValueOf& value_of) {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> result(wanted.rows, wanted.columns);
  if (result.size() == 0) return result;
  kanexpr::base::sequence<int> outputs;
  for (const kanexpr::symbolic::expression& e : wanted.entries) outputs.push(e.node());
  kanexpr::runtime::interpreter<double> code(kanexpr::lower::tape_of(wanted.entries[0].owner(), outputs));
  code.evaluate(value_of, result.data());
  return result;
}
