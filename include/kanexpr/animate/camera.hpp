#pragma once

#include <kanexpr/animate/about_axis.hpp>
#include <kanexpr/animate/animation.hpp>
#include <kanexpr/animate/check_animation.hpp>
#include <kanexpr/animate/line_of_cable.hpp>
#include <kanexpr/animate/scene.hpp>
#include <kanexpr/animate/undeformed_placements.hpp>
#include <kanexpr/base/status.hpp>
#include <kanexpr/derivation/survey.hpp>
#include <kanexpr/mechanics/motion/triple.hpp>
#include <kanexpr/numeric/all_finite.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>
#include <kanexpr/numeric/taut_line.hpp>
#include <kanexpr/runtime/table_interpreter.hpp>
#include <kanexpr/symbolic/graph/symbol.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <span>
#include <string>
#include <utility>
#include <vector>

/// Evaluates a picture along a motion and converts its numbers to shapes.
namespace kanexpr::animate {

inline Eigen::Vector3d triple(const double* numbers) { return {numbers[0], numbers[1], numbers[2]}; }

inline Eigen::Matrix3d axes_of(const element_record& r, const double* numbers) {
  if (r.has_axis) return about_axis(triple(numbers), triple(numbers + 3), triple(numbers + 6));
  Eigen::Matrix3d axes;
  axes.col(0) = triple(numbers);
  axes.col(1) = triple(numbers + 3);
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

inline placement placement_from(const element_record& r, const double* numbers) {
  placement here;
  here.position = triple(numbers);
  if (r.placed_by == placement_kind::ends) here.end = triple(numbers + 3);
  if (r.placed_by == placement_kind::pose) here.orientation = axes_of(r, numbers + 3);
  return here;
}

/// The numbers of a picture and the integrals of its rates, one column for each time.
struct recorded_numbers {
  Eigen::MatrixXd numbers{}, integrals{};
};

inline Eigen::Vector3d triple(const Eigen::MatrixXd& m, int row, Eigen::Index column) {
  return m.block<3, 1>(row, column);
}

/// Adds the places of a cable at the next time.
inline void add_places(animation::shape& s, const numeric::taut_line& line) {
  for (const Eigen::Vector3d& place : line.places) s.placements.push_back({.position = place});
  s.straight_parts = line.straight_parts;
}

inline animation::shape shape_of(const element_record& r, const recorded_numbers& recorded) {
  animation::shape s;
  s.name = r.looks.name.empty() ? r.name.view() : r.looks.name;
  s.kind = r.shape;
  s.colour = r.looks.colour;
  s.profile = r.profile;
  s.file = r.file;
  s.layer = r.looks.layer;
  s.unit = r.looks.unit.empty() ? r.unit_of_model.view() : r.looks.unit;
  s.opacity = r.looks.opacity;
  s.placed_by = r.placed_by;
  for (int i = 0; i < r.constant; ++i) s.sizes.push_back(recorded.numbers(r.first_constant + i, 0));
  s.places = r.places;
  if (r.path != nullptr) {
    for (Eigen::Index k = 0; k < recorded.numbers.cols(); ++k)
      add_places(s, line_of(*r.path, recorded.numbers.col(k).data() + r.first_varying));
    return s;
  }
  const std::size_t numbers = r.placed_by == placement_kind::place ? 3 : 12; // of a place of several
  for (Eigen::Index k = 0; k < recorded.numbers.cols(); ++k)
    for (std::size_t i = 0; i < r.places; ++i) {
      placement here = placement_from(r, recorded.numbers.col(k).data() + r.first_varying + i * numbers);
      if (r.rates == 1)
        here.orientation *=
            Eigen::AngleAxisd(recorded.integrals(r.first_rate, k), Eigen::Vector3d::UnitZ()).matrix();
      s.placements.push_back(here);
    }
  return s;
}

/// Moves all shapes with the origin. Its path follows from the velocity of a point; see `carried`.
inline void move_with_origin(animation& a, const element_record& r, const recorded_numbers& recorded) {
  a.carried = true;
  for (Eigen::Index k = 0; k < recorded.numbers.cols(); ++k) {
    const Eigen::Vector3d way = triple(recorded.integrals, r.first_rate, k) -
                                triple(recorded.numbers, r.first_varying, k) +
                                triple(recorded.numbers, r.first_varying, 0);
    const Eigen::Vector3d level = way - way.dot(a.up) * a.up;
    for (animation::shape& s : a.shapes)
      for (std::vector<placement>* all : {&s.placements, &s.undeformed})
        for (std::size_t i = 0; i < s.places && !all->empty(); ++i) {
          placement& here = (*all)[static_cast<std::size_t>(k) * s.places + i];
          here.position += level;
          if (s.kind != "arrow") here.end += level;
        }
  }
}

/// The numbers in `undeformed` belong to the same motion without deformations; without columns if there are
/// none.
inline void make_shapes(animation& a, std::span<const element_record> elements,
                        const recorded_numbers& recorded, const recorded_numbers& undeformed) {
  for (const element_record& r : elements) {
    if (!r.shape.empty()) {
      animation::shape& s = a.shapes.emplace_back(shape_of(r, recorded));
      if (undeformed.numbers.cols() != 0)
        s.undeformed = undeformed_placements(s, shape_of(r, undeformed).placements);
    }
    if (r.word == "up") a.up = triple(recorded.numbers, r.first_constant, 0).normalized();
    if (r.word == "seen_from") a.seen_from = triple(recorded.numbers, r.first_constant, 0).normalized();
    if (r.word == "files_in") a.folder = r.file;
    if (r.word == "ground") a.ground = recorded.numbers(r.first_constant, 0);
  }
  for (const element_record& r : elements)
    if (r.word == "carried") move_with_origin(a, r, recorded);
}

inline std::vector<double> row_of(const Eigen::MatrixXd& m, int row) {
  return {m.row(row).begin(), m.row(row).end()};
}

/// Adds the columns of the elements `plot` and `plot_energies`. Energies are in J if the model states units.
inline void add_plots(animation& a, std::span<const element_record> elements,
                      const recorded_numbers& recorded, int first_energy, bool states_units) {
  for (const element_record& r : elements) {
    const std::string unit(!r.unit.empty()    ? r.unit
                           : r.word == "plot" ? r.unit_of_model.view()
                           : states_units     ? "J"
                                              : "");
    if (r.word == "plot")
      a.columns.push_back(
          {std::string(r.looks.name), row_of(recorded.numbers, r.first_varying), "Quantities", unit});
    if (r.word != "plot_energies") continue;
    const std::vector<double> kinetic = row_of(recorded.numbers, first_energy);
    const std::vector<double> potential = row_of(recorded.numbers, first_energy + 1);
    std::vector<double> total(kinetic.size());
    std::ranges::transform(kinetic, potential, total.begin(), std::plus<>());
    a.columns.push_back({"kinetic energy", kinetic, "Energies", unit});
    a.columns.push_back({"potential energy", potential, "Energies", unit});
    a.columns.push_back({"total energy", total, "Energies", unit});
  }
}

/// Gives the columns of symbols the units of the elements `in_unit`, which replace those of the model.
inline void give_units(animation& a, std::span<const element_record> elements) {
  for (std::size_t i = elements.size(); i-- > 0;) // the first of several counts
    for (const phrase& p : elements[i].symbols) {
      std::string name(p.tokens[0].symbol->called.view());
      if (p.tokens[0].symbol->kind == symbolic::symbol_kind::coordinate_rate) name += '\'';
      for (animation::column& c : a.columns)
        if (c.name == name && c.group != "Quantities") c.unit = elements[i].unit;
    }
}

/// Evaluates a picture along a motion.
class camera {
public:
  explicit camera(const scene& shown)
      : scene_(shown), numbers_(shown.table, shown.known),
        x_(static_cast<std::size_t>(shown.known.coordinates + shown.known.speeds)),
        p_(static_cast<std::size_t>(shown.known.parameters)),
        r_(static_cast<std::size_t>(shown.known.inputs)) {
    scene_.parameters(p_.data());
  }

  animation film() {
    made_.columns = columns_of(scene_.known, scene_.units);
    if (scene_.samples() == 0) made_.failure = "the trajectory has no samples";
    recorded_.numbers.resize(scene_.numbers, static_cast<Eigen::Index>(scene_.samples()));
    for (std::size_t i = 0; i < scene_.samples() && made_; ++i) take(i);
    if (!made_) return std::move(made_);
    drop_unset_inputs(made_);
    integrate();
    make_shapes(made_, scene_.elements, recorded_, without_deformation());
    add_plots(made_, scene_.elements, recorded_, scene_.first_rate + scene_.rates, scene_.units != nullptr);
    give_units(made_, scene_.elements);
    made_.failure = check_numbers(made_);
    return std::move(made_);
  }

private:
  void take(std::size_t sample) {
    double t = 0;
    scene_.sample(sample, t, x_.data(), r_.data());
    const status s = evaluate(t, column(recorded_.numbers, sample));
    if (!s) made_.failure = s.cause() + at_time(t);
    add_sample(made_, t, x_, r_);
  }

  status evaluate(double t, double* all) {
    return numbers_.evaluate(t, x_.data(), p_.data(), r_.data(), all);
  }
  bool take_between(double t, double* all) {
    if (!scene_.between(t, x_.data(), r_.data())) return false;
    evaluate(t, all);
    return true;
  }

  /// The numbers of the same motion while the amplitudes of all flexible bodies are zero.
  recorded_numbers without_deformation() {
    recorded_numbers straight;
    if (scene_.amplitudes == 0) return straight;
    straight.integrals = recorded_.integrals;
    straight.numbers.resizeLike(recorded_.numbers);
    const auto last = static_cast<std::ptrdiff_t>(scene_.known.coordinates);
    for (std::size_t i = 0; i < scene_.samples(); ++i) {
      double t = 0;
      scene_.sample(i, t, x_.data(), r_.data());
      std::fill(x_.begin() + last - scene_.amplitudes, x_.begin() + last, 0.0);
      if (!evaluate(t, column(straight.numbers, i))) return {};
    }
    return numeric::all_finite(straight.numbers) ? straight : recorded_numbers();
  }

  static double* column(Eigen::MatrixXd& m, std::size_t k) {
    return m.data() + static_cast<Eigen::Index>(k) * m.rows();
  }

  /// Integrates over each step by Simpson's rule if the trajectory provides the state at the midpoint, else
  /// by the trapezoidal rule.
  void integrate() {
    const std::size_t count = made_.times.size();
    recorded_.integrals.setZero(scene_.rates, static_cast<Eigen::Index>(count));
    if (scene_.rates == 0) return;
    std::vector<double> halfway(static_cast<std::size_t>(scene_.numbers));
    for (std::size_t k = 0; k + 1 < count; ++k) {
      const double before = made_.times[k], after = made_.times[k + 1];
      const bool is_between = before < after && take_between((before + after) / 2, halfway.data());
      const double *here = column(recorded_.numbers, k) + scene_.first_rate, *there = here + scene_.numbers;
      const double* between = halfway.data() + scene_.first_rate;
      const double* was = column(recorded_.integrals, k);
      double* becomes = column(recorded_.integrals, k + 1);
      for (int i = 0; i < scene_.rates; ++i) {
        const double ends = (here[i] + there[i]) / 2;
        becomes[i] = was[i] + (after - before) * (is_between ? (ends + 2 * between[i]) / 3 : ends);
      }
    }
  }

  const scene& scene_;
  runtime::table_interpreter<double> numbers_;
  std::vector<double> x_, p_, r_;
  animation made_{};
  recorded_numbers recorded_{};
};

KANEXPR_PAGES animation film(const scene& shown) { return camera(shown).film(); }

} // namespace kanexpr::animate
