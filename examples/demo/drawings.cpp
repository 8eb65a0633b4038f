#include "demo/parts.hpp"
#include "models/bicycle.hpp"
#include "models/double_pendulum.hpp"
#include "models/iiwa.hpp"
#include "models/rolling_disc.hpp"

#include <kanexpr/animate/picture_of.hpp>
#include <kanexpr/figures.hpp>
#include <kanexpr/simulations/model.hpp>

#include <cmath>
#include <cstdio>

/// Figures and moving pictures of models derived while the program runs. None of them is described: all
/// shapes follow from the models.
namespace demo {

using namespace kanexpr;

namespace {

bool succeeded(const std::string& cause) {
  if (!cause.empty()) std::fprintf(stderr, "%s\n", cause.c_str());
  return cause.empty();
}

/// Writes NAME.svg and NAME.html.
template <class Trajectory>
bool draw_both(const std::string& path, const figure& drawn, model m, const Trajectory& run,
               const exhibit& e) {
  const bool right =
      succeeded(drawn.write(path + ".svg").cause()) &&
      succeeded(write_page(path + ".html", std::move(m), run, {.title = e.title, .text = e.text}).cause());
  if (right) std::printf("  %s: %s and .html\n", e.title.c_str(), (path + ".svg").c_str());
  return right;
}

exhibit described(const std::string& title, const std::string& text, const std::string& name) {
  return {title, text, name + ".svg", {{"Moving picture", name + ".html"}, {"Figure", name + ".svg"}}};
}

bool draw_double_pendulum(const std::string& folder, std::vector<exhibit>& all) {
  all.push_back(described("A double pendulum", "Two bars, released at rest.", "double_pendulum"));
  model m = derive<double_pendulum::System>();
  const given_parameters<model> p{{"m1", 1.0},      {"m2", 1.0},      {"d1", 0.5}, {"d2", 0.5}, {"l1", 1.0},
                                  {"I1", 1.0 / 12}, {"I2", 1.0 / 12}, {"g", 9.81}, {"c1", 0.0}, {"c2", 0.0}};
  const auto run = simulate(m, {{"q1", 0.4}, {"q2", 1.1}, {"u1", 0.0}, {"u2", 0.0}}, p, {0, 10},
                            {.inputs = {{"T1", 0.0}, {"T2", 0.0}}, .output_every = 0.02});
  if (!run) return succeeded(run.cause());
  const figure drawn = draw(m, {{"q1", -0.9}, {"q2", 0.5}, {"u1", 0.0}, {"u2", 0.0}}, p);
  return draw_both(folder + "/double_pendulum", drawn, m, run.trajectory, all.back());
}

bool draw_rolling_disc(const std::string& folder, std::vector<exhibit>& all) {
  all.push_back(
      described("A rolling disc", "It leans inward and rolls around in a wavy circle.", "rolling_disc"));
  model m = derive<rolling_disc::System>();
  const given_state<model> x{{"q1", 0.0}, {"q2", 0.45}, {"q3", 0.0}, {"u1", 0.0}, {"u2", -7.0}, {"u3", 1.9}};
  const given_parameters<model> p{{"r", 0.3}, {"m", 2.0}, {"g", 9.81}};
  const auto run = simulate(m, x, p, {0, 8}, {.output_every = 0.02});
  if (!run) return succeeded(run.cause());
  const figure drawn =
      draw(m, {{"q1", 0.5}, {"q2", 0.45}, {"q3", 0.0}, {"u1", 0.0}, {"u2", 0.0}, {"u3", 0.0}}, p);
  return draw_both(folder + "/rolling_disc", drawn, m, run.trajectory, all.back());
}

/// A motion that is given, not simulated: any range of samples with `parameters()` will do.
struct swinging_arm {
  struct sample {
    double t = 0;
    Eigen::Vector<double, 14> x = Eigen::Vector<double, 14>::Zero();
    Eigen::Vector<double, 7> r = Eigen::Vector<double, 7>::Zero();
  };
  std::vector<sample> all{};

  swinging_arm() {
    for (int k = 0; k <= 400; ++k) {
      sample s{.t = 0.02 * k};
      for (int i = 0; i < 7; ++i)
        s.x(i) = 0.3 + 0.8 * std::sin(0.25 * std::acos(-1.0) * (i + 1) * s.t / 2 + i);
      all.push_back(s);
    }
  }
  auto begin() const { return all.begin(); }
  auto end() const { return all.end(); }
  static Eigen::VectorXd parameters() { return {}; }
};

bool draw_arm(const std::string& folder, std::vector<exhibit>& all) {
  all.push_back(described("KUKA LBR iiwa 14",
                          "A robot arm of seven joints; the motion of each joint is given.", "iiwa"));
  model m = derive<iiwa::System>();
  const swinging_arm motion;
  const figure drawn = draw(m, motion.all.front().x, {}, {}, {.axes = false, .loads = false});
  return draw_both(folder + "/iiwa", drawn, m, motion, all.back());
}

bool draw_bicycle(const std::string& folder) {
  using namespace bicycle;
  const figure drawn = draw<BoundSystem>({{q1, 0}, {q2, 0}, {q5, 0.4}, {u2, 0}, {u3, 10}, {u5, 0}}, {}, {},
                                         {.axes = false, .lengths = false, .loads = false});
  return succeeded(drawn.write(folder + "/bicycle.svg").cause());
}

} // namespace

bool draw_systems(const std::string& folder, std::vector<exhibit>& all) {
  std::printf("\nFigures and moving pictures, without a word about shapes\n");
  const bool pendulum = draw_double_pendulum(folder, all);
  const bool disc = draw_rolling_disc(folder, all);
  const bool arm = draw_arm(folder, all);
  return draw_bicycle(folder) && pendulum && disc && arm;
}

} // namespace demo
