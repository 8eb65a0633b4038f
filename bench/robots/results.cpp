// Results of a robot at random states, for a comparison: results FILE fixed|floating STATES prints, one in a
// line, a word and what it stands for: the joints with the places of their coordinates and speeds, then for
// each state the state, the inputs, M, f, u' and the energies.
#include <kanexpr/robots.hpp>

#include <Eigen/Core>

#include <cstdlib>
#include <iostream>
#include <random>

namespace {

using namespace kanexpr;

template <class Matrix>
void print(const char* what, const Matrix& m) {
  std::cout << what;
  for (Eigen::Index i = 0; i < m.rows(); ++i)
    for (Eigen::Index j = 0; j < m.cols(); ++j) std::cout << ' ' << m(i, j);
  std::cout << '\n';
}

/// Between -1 and 1, the same in each run; quaternions have length 1.
class source {
public:
  Eigen::VectorXd state(const robots::plan& p) {
    Eigen::VectorXd q = vector([](const auto& j) { return j.coordinates.size(); }, p);
    Eigen::Index at = 0;
    for (const robots::planned_joint& j : p.joints) {
      if (j.kind == robots::joint_kind::floating) q.segment<4>(at + 3).normalize();
      at += static_cast<Eigen::Index>(j.coordinates.size());
    }
    const Eigen::VectorXd u = vector([](const auto& j) { return j.speeds.size(); }, p);
    Eigen::VectorXd x(q.size() + u.size());
    x << q, u;
    return x;
  }
  Eigen::VectorXd inputs(const robots::plan& p) {
    return vector([](const auto& j) { return j.input.called.empty() ? 0u : 1u; }, p);
  }

private:
  template <class Count>
  Eigen::VectorXd vector(Count count, const robots::plan& p) {
    Eigen::Index n = 0;
    for (const robots::planned_joint& j : p.joints) n += static_cast<Eigen::Index>(count(j));
    return Eigen::VectorXd::NullaryExpr(
        n, [&] { return std::uniform_real_distribution<double>(-1, 1)(random_); });
  }
  std::mt19937_64 random_{7};
};

void print_joints(const robots::robot& r, const robots::plan& p) {
  std::size_t q = 0, u = 0;
  for (const robots::planned_joint& j : p.joints) {
    const std::string called = j.joint < 0 ? "root_joint" : r.joints[static_cast<std::size_t>(j.joint)].name;
    std::cout << "joint " << static_cast<int>(j.kind) << ' ' << q << ' ' << u << ' '
              << !j.input.called.empty() << ' ' << called << '\n';
    q += j.coordinates.size(), u += j.speeds.size();
  }
  for (std::size_t j = 0; j < r.joints.size(); ++j) {
    if (!r.joints[j].mimic) continue;
    const robots::mimic_rule how = robots::resolved_mimic(r, static_cast<int>(j));
    std::cout << "follows " << how.multiplier << ' ' << how.offset << ' '
              << p.joint_of[static_cast<std::size_t>(how.leader)] << ' ' << r.joints[j].name << '\n';
  }
}

} // namespace

int main(int count, char** arguments) {
  if (count < 4) return std::cerr << "results FILE fixed|floating STATES [RIGHT_ANGLES]\n", 2;
  const double right_angles = count > 4 ? std::atof(arguments[4]) : 0;
  const robots::read_robot read = robots::read_urdf(arguments[1], {.right_angles = right_angles});
  if (!read) return std::cout << "mistake " << read.cause() << '\n', 0;
  const bool floats = std::string(arguments[2]) == "floating";
  const robots::robot_builder built(
      read.robot,
      {.base = floats ? robots::base_kind::floating : robots::base_kind::fixed, .damping = false});
  if (const std::string cause = built.cause(); !cause.empty())
    return std::cout << "mistake " << cause << '\n', 0;
  model m = derive(built);
  m.udot();
  if (!m.mistake().empty()) return std::cout << "mistake " << m.mistake() << '\n', 0;
  std::cout.precision(17);
  print_joints(read.robot, built.plan());

  auto mass = m.function(m.mass_matrix()), forcing = m.function(m.forcing()), udot = m.function(m.udot());
  auto kinetic = m.function(m.get(mechanics::quantity::kinetic_energy)),
       potential = m.function(m.get(mechanics::quantity::potential_energy));
  const auto operations = [](const symbolic::cost& c) { return c.multiplications + c.additions; };
  std::cout << "operations " << operations(forcing.cost()) << " " << operations(udot.cost()) << "\n";
  source random;
  const Eigen::VectorXd none;
  for (int i = std::atoi(arguments[3]); i > 0; --i) {
    const Eigen::VectorXd x = random.state(built.plan()), r = random.inputs(built.plan());
    print("state", x.transpose()), print("inputs", r.transpose());
    print("mass", mass(x, none, r)), print("forcing", forcing(x, none, r)), print("udot", udot(x, none, r));
    print("kinetic", kinetic(x, none, r)), print("potential", potential(x, none, r));
    std::cout << "status " << udot.status().cause() << '\n';
  }
}
