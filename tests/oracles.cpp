#include "oracles.hpp"

#include <nlohmann/json.hpp>

#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <numbers>

namespace oracle {
namespace {

using nlohmann::json;

json read(const std::string& name) {
  const std::string path = KANEXPR_ORACLES "/" + name + ".json";
  std::ifstream file(path);
  json value = json::parse(file, nullptr, false);
  if (value.is_discarded()) {
    std::cerr << path << " is missing or no JSON\n";
    std::abort();
  }
  return value;
}

VectorXd vector(const json& values) {
  VectorXd result(static_cast<Eigen::Index>(values.size()));
  for (Eigen::Index i = 0; const json& value : values) result[i++] = value.get<double>();
  return result;
}

VectorXd vector_or_empty(const json& object, const char* key) {
  return object.contains(key) ? vector(object.at(key)) : VectorXd();
}

MatrixXd matrix(const json& rows) {
  const std::size_t columns = rows.empty() ? 0 : rows.front().size();
  MatrixXd result(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (Eigen::Index i = 0; const json& row : rows) result.row(i++) = vector(row).transpose();
  return result;
}

MatrixXd row_major(const json& values, Eigen::Index rows) {
  return vector(values).reshaped<Eigen::RowMajor>(rows, static_cast<Eigen::Index>(values.size()) / rows);
}

std::vector<std::complex<double>> complex_numbers(const json& pairs) {
  std::vector<std::complex<double>> result;
  for (const json& pair : pairs) result.emplace_back(pair.at(0).get<double>(), pair.at(1).get<double>());
  return result;
}

std::optional<double> number_if_any(const json& object, const char* key) {
  return object.contains(key) ? std::optional(object.at(key).get<double>()) : std::nullopt;
}

// "q1(t)" is q1, "Derivative(m(t), t)" is m', "Derivative(theta(t), (t, 2))" is theta''.
std::string name_of(std::string text) {
  std::string primes;
  if (const std::string outer = "Derivative("; text.starts_with(outer)) {
    const auto order = text.find("(t, ");
    primes.assign(order == std::string::npos ? 1 : static_cast<std::size_t>(text[order + 4] - '0'), '\'');
    text.erase(0, outer.size());
  }
  return text.substr(0, text.find("(t)")) + primes;
}

std::vector<std::string> names(const json& list) {
  std::vector<std::string> result;
  for (const json& text : list) result.push_back(name_of(text.get<std::string>()));
  return result;
}

state read_state(const json& s) {
  return {vector(s.at("q")),
          vector(s.at("u")),
          vector(s.at("r")),
          matrix(s.at("mass_matrix")),
          vector(s.at("forcing")),
          vector(s.at("qdot")),
          vector(s.at("udot")),
          number_if_any(s, "kinetic_energy"),
          number_if_any(s, "potential_energy"),
          number_if_any(s, "power_nonconservative"),
          vector_or_empty(s, "configuration_residual"),
          vector_or_empty(s, "velocity_residual")};
}

linearization read_linearization(const json& l) {
  MatrixXd a = matrix(l.at("A"));
  MatrixXd b = l.contains("B") ? matrix(l.at("B")) : MatrixXd(a.rows(), 0);
  return {l.at("label"),        vector(l.at("q")),
          vector(l.at("u")),    vector(l.at("r")),
          vector(l.at("qdot")), vector(l.at("udot")),
          names(l.at("x")),     std::move(a),
          std::move(b),         complex_numbers(l.at("eigenvalues_re_im"))};
}

body read_body(const json& b) { return {b.at("mass"), vector(b.at("com")), vector(b.at("inertia_com"))}; }

link read_link(const json& l) {
  return {read_body(l),
          l.at("name"),
          l.at("parent"),
          l.at("axis").get<std::string>().front(),
          row_major(l.at("rotation"), 3),
          vector(l.at("position"))};
}

robot_state read_robot_state(const json& s) {
  return {vector(s.at("q")),
          vector(s.at("u")),
          vector(s.at("a")),
          vector(s.at("torque")),
          row_major(s.at("mass_matrix"), static_cast<Eigen::Index>(s.at("u").size())),
          vector(s.at("bias")),
          vector(s.at("udot")),
          vector(s.at("inverse_dynamics"))};
}

} // namespace

system load(const std::string& name) {
  const json file = read(name);
  system result{names(file.at("q")),
                names(file.at("u")),
                names(file.at("r")),
                names(file.at("q_dependent")),
                names(file.at("u_dependent")),
                file.at("parameters"),
                {},
                {}};
  for (const json& s : file.at("states")) result.states.push_back(read_state(s));
  for (const json& l : file.at("linearizations")) result.linearizations.push_back(read_linearization(l));
  return result;
}

robot load_robot(const std::string& name) {
  const json file = read(name);
  robot result{vector(file.at("gravity")), std::nullopt, {}, {}};
  if (file.at("floating_base")) result.base = read_body(file.at("base"));
  for (const json& l : file.at("links")) result.links.push_back(read_link(l));
  for (const json& s : file.at("states")) result.states.push_back(read_robot_state(s));
  return result;
}

bicycle load_bicycle(const std::string& name) {
  const json file = read(name);
  bicycle result;
  for (const auto& [key, value] : file.at("parameters").items())
    result.parameters[key] = value == "pi/10" ? std::numbers::pi / 10 : value.get<double>();
  result.M = matrix(file.at("M"));
  result.C1 = matrix(file.at("C1"));
  result.K0 = matrix(file.at("K0"));
  result.K2 = matrix(file.at("K2"));
  for (const auto& [speed, a] : file.at("A").items()) result.A[std::stoi(speed)] = matrix(a);
  for (const auto& [speed, e] : file.at("eigenvalues_re_im").items())
    result.eigenvalues[std::stoi(speed)] = complex_numbers(e);
  result.weave_speed = file.at("critical_speeds").at("weave");
  result.capsize_speed = file.at("critical_speeds").at("capsize");
  return result;
}

std::map<std::string, MatrixXd> load_tables(const std::string& name) {
  std::map<std::string, MatrixXd> result;
  const json file = read(name);
  for (const auto& [called, rows] : file.items()) result[called] = matrix(rows);
  return result;
}

double relative_error(const Eigen::Ref<const MatrixXd>& a, const Eigen::Ref<const MatrixXd>& b) {
  if (a.rows() != b.rows() || a.cols() != b.cols() || !a.allFinite() || !b.allFinite())
    return std::numeric_limits<double>::infinity();
  if (a.size() == 0) return 0;
  return (a - b).cwiseAbs().maxCoeff() / std::max(1e-300, b.cwiseAbs().maxCoeff());
}

testing::AssertionResult close(const Eigen::Ref<const MatrixXd>& actual,
                               const Eigen::Ref<const MatrixXd>& expected, double tolerance) {
  const double error = relative_error(actual, expected);
  if (error <= tolerance) return testing::AssertionSuccess() << "relative error " << error;
  return testing::AssertionFailure() << "relative error " << error << " > " << tolerance << "\nactual:\n"
                                     << actual << "\nexpected:\n"
                                     << expected;
}

} // namespace oracle
