#include "systems/linearized.hpp"

#include "systems/hand_written.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <random>

namespace check {

namespace {

using complex_vector = Eigen::VectorXcd;

constexpr double size_of_step = 1e-30;
constexpr complex step{0, size_of_step};

std::vector<std::string> called(const kanexpr::base::sequence<kanexpr::symbolic::expression>& symbols) {
  std::vector<std::string> names;
  for (const auto& e : symbols) names.push_back(kanexpr::symbolic::print(e));
  return names;
}

template <class T>
std::vector<T> joined(std::vector<T> a, const std::vector<T>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

std::vector<Eigen::Index> places(const kanexpr::base::sequence<int>& list, int first) {
  std::vector<Eigen::Index> found;
  for (int i : list) found.push_back(first + i);
  return found;
}

// Reorders the rows and columns of a matrix from one list of states to another, by their names.
MatrixXd reordered(const MatrixXd& m, const std::vector<std::string>& from,
                   const std::vector<std::string>& to, bool columns) {
  std::vector<Eigen::Index> place;
  for (const std::string& name : to) {
    const auto found = std::find(from.begin(), from.end(), name);
    EXPECT_NE(found, from.end()) << name;
    if (found != from.end()) place.push_back(found - from.begin());
  }
  if (columns) return m(place, place);
  return m(place, Eigen::all);
}

} // namespace

template <class Scalar>
kanexpr::runtime::interpreted<Scalar> derived_functions::function(kanexpr::mechanics::equations& e,
                                                                  quantity wanted) {
  const kanexpr::symbolic::matrix result = e.get(wanted);
  const auto& m = *e.skeleton_used().model;
  return {*m.g, result, m.coordinates.size(),
          e.singularity_checks_of(kanexpr::symbolic::nodes_of(result.entries))};
}

derived_functions::derived_functions(kanexpr::mechanics::equations& e)
    : A(function<double>(e, quantity::state_matrix)), B(function<double>(e, quantity::input_matrix)),
      gap(function<complex>(e, quantity::configuration_residual)),
      gap_jacobian(function<complex>(e, quantity::configuration_jacobian_by_dependent)),
      speeds(function<complex>(e, quantity::dependent_speeds)), rhs(function<complex>(e, quantity::rhs)) {
  read_names(*e.skeleton_used().model);
  read_places(e);
}

void derived_functions::read_names(const kanexpr::mechanics::mechanism& m) {
  q = called(m.coordinates), u = called(m.speeds), r = called(m.inputs), p = called(m.parameters);
}

void derived_functions::read_places(const kanexpr::mechanics::equations& e) {
  const int n = e.coordinates().dependent.size() + e.coordinates().independent.size();
  dependent_coordinates = places(e.coordinates().dependent, 0);
  dependent_speeds = places(e.speeds().dependent, n);
  states = joined(places(e.coordinates().independent, 0), places(e.speeds().independent, n));
}

explicit_form linearized::at(double t, const VectorXd& x, const VectorXd& p, const VectorXd& r) {
  explicit_form form{f_.A(t, x, p, r), f_.B(t, x, p, r)};
  EXPECT_TRUE(f_.A.status());
  return form;
}

explicit_form linearized::by_complex_steps(double t, const VectorXd& x, const VectorXd& p,
                                           const VectorXd& r) {
  const auto size = static_cast<Eigen::Index>(f_.states.size());
  explicit_form form{MatrixXd(size, size), MatrixXd(size, r.size())};
  for (Eigen::Index j = 0; j < size; ++j) {
    complex_vector stepped = x.cast<complex>();
    stepped(f_.states[static_cast<std::size_t>(j)]) += step;
    form.A.col(j) = rates(t, stepped, p, r.cast<complex>());
  }
  for (Eigen::Index j = 0; j < r.size(); ++j) {
    complex_vector stepped = r.cast<complex>();
    stepped(j) += step;
    form.B.col(j) = rates(t, x.cast<complex>(), p, stepped);
  }
  return form;
}

void linearized::satisfy(double t, complex_vector& x, const VectorXd& p, const complex_vector& r,
                         int rounds) {
  for (int round = 0; round < rounds && !f_.dependent_coordinates.empty(); ++round) {
    const complex_vector gap = f_.gap(t, x, p, r);
    x(f_.dependent_coordinates) -= Eigen::MatrixXcd(f_.gap_jacobian(t, x, p, r)).lu().solve(gap);
  }
  if (!f_.dependent_speeds.empty()) x(f_.dependent_speeds) = f_.speeds(t, x, p, r);
}

VectorXd linearized::rates(double t, complex_vector x, const VectorXd& p, const complex_vector& r) {
  satisfy(t, x, p, r, 3);
  const complex_vector all = f_.rhs(t, x, p, r);
  return all(f_.states).imag() / size_of_step;
}

bool linearized::assemble(double t, VectorXd& x, const VectorXd& p, const VectorXd& r) {
  complex_vector moved = x.cast<complex>();
  satisfy(t, moved, p, r.cast<complex>(), 30);
  x = moved.real();
  if (!x.allFinite()) return false;
  if (f_.dependent_coordinates.empty()) return true;
  return f_.gap(t, moved, p, r.cast<complex>()).norm() < 1e-14;
}

VectorXd linearized::parameters(const std::map<std::string, double>& values) const {
  VectorXd p(static_cast<Eigen::Index>(f_.p.size()));
  for (Eigen::Index i = 0; i < p.size(); ++i) p(i) = values.at(f_.p[static_cast<std::size_t>(i)]);
  return p;
}

void linearized::against_oracle(const std::string& name) {
  const oracle::system reference = oracle::load(name);
  const VectorXd p = parameters(reference.parameters);
  const std::vector<std::string> all = joined(f_.q, f_.u);
  std::vector<std::string> own;
  for (const Eigen::Index i : f_.states) own.push_back(all[static_cast<std::size_t>(i)]);
  EXPECT_EQ(f_.r, reference.r);
  EXPECT_FALSE(reference.linearizations.empty());
  for (const oracle::linearization& l : reference.linearizations) {
    VectorXd x(static_cast<Eigen::Index>(all.size()));
    x << hand_written::pick(f_.q, reference.q, l.q), hand_written::pick(f_.u, reference.u, l.u);
    const explicit_form found = at(0, x, p, l.r);
    EXPECT_TRUE(oracle::close(found.A, reordered(l.A, l.x, own, true), 1e-12)) << l.label;
    if (l.r.size() == 0) continue;
    EXPECT_TRUE(oracle::close(found.B, reordered(l.B, l.x, own, false), 1e-12)) << l.label;
  }
}

void linearized::against_complex_steps(const std::string& name, const VectorXd& around, double reach) {
  constexpr int points = 1000;
  const VectorXd parameters_given = parameters(oracle::load(name).parameters);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  const auto any = [&] { return unit(random); };
  const auto n = static_cast<Eigen::Index>(f_.q.size()), inputs = static_cast<Eigen::Index>(f_.r.size());
  double worst = 0;
  int found = 0;
  for (int tried = 0; found < points && tried < 20 * points; ++tried) {
    VectorXd x = around, p = parameters_given;
    const VectorXd r = VectorXd::NullaryExpr(inputs, any);
    for (Eigen::Index i = 0; i < x.size(); ++i) x(i) = i < n ? x(i) + reach * any() : 2 * any();
    for (double& value : p) value *= 1 + any() / 5;
    const double t = any();
    if (!assemble(t, x, p, r)) continue;
    const explicit_form expected = by_complex_steps(t, x, p, r);
    if (!expected.A.allFinite() || expected.A.cwiseAbs().maxCoeff() > 1e4) continue; // nearly singular
    const explicit_form form = at(t, x, p, r);
    worst = std::max(worst, oracle::relative_error(form.A, expected.A));
    if (inputs != 0) worst = std::max(worst, oracle::relative_error(form.B, expected.B));
    ++found;
  }
  EXPECT_EQ(found, points);
  EXPECT_LE(worst, 1e-10);
}

} // namespace check
