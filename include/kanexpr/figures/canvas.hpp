#pragma once

#include <kanexpr/base/engine.hpp>
#include <kanexpr/figures/text.hpp>

#include <Eigen/Core>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::figures {

/// What is drawn later covers what is drawn earlier.
enum class layer { bodies, lines, axes, marks, labels };

/// A drawing in pixels, with y upward, that grows with its contents. Labels are placed last, where they cover
/// as little as possible.
class canvas {
public:
  using point = Eigen::Vector2d;

  void line(layer on, const point& from, const point& to, std::string_view style);
  /// A polyline; with an arrow head at its end if `head` is given in pixels.
  void path(layer on, const std::vector<point>& through, std::string_view style, double head = 0);
  void arrow(layer on, const point& from, const point& to, std::string_view style);
  void circle(layer on, const point& center, double radius, std::string_view style);
  /// The ellipse { center + s : sᵀ S⁻¹ s = 1 }.
  void ellipse(layer on, const point& center, const Eigen::Matrix2d& s, std::string_view style);
  /// A label near a point, preferably in a direction from it.
  void label(const point& at, const point& direction, text contents, std::string_view style);

  const point& least() const { return least_; }
  const point& most() const { return most_; }

  /// The file, with a title for readers who do not see it.
  std::string svg(std::string_view title);

private:
  struct pending_label {
    point at, direction;
    text contents;
    std::string style;
  };
  struct box {
    point least, most;
  };

  void element(layer on, const std::string& text) { layers_[static_cast<std::size_t>(on)] += text + '\n'; }
  void cover(const point& p);
  void cover_line(const point& from, const point& to);
  box box_of(const pending_label& each, double turn, double distance) const;
  double cost_of(const box& b) const;
  void place(const pending_label& each);

  std::array<std::string, 5> layers_{};
  std::vector<pending_label> labels_{};
  std::vector<box> placed_{};
  std::vector<point> covered_{}; ///< points along everything that is drawn
  point least_ = point::Zero(), most_ = point::Zero();
};

} // namespace kanexpr::figures

#ifndef KANEXPR_COMPILED_ENGINE
#include <kanexpr/figures/canvas.ipp>
#endif
