#pragma once

#include <kanexpr/base/utf8.hpp>
#include <kanexpr/figures/text.hpp>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::figures {

/// The layers of a drawing; each covers those listed before it.
enum class layer { bodies, lines, axes, marks, labels };

/// A drawing in pixels, with y upward, that grows with its contents. Labels are placed last, where they cover
/// as little as possible.
class canvas {
public:
  using point = Eigen::Vector2d;

  void line(layer on, const point& from, const point& to, std::string_view style);
  /// A polyline; if `head` is not 0, it ends in an arrow head of this length in pixels.
  void path(layer on, const std::vector<point>& through, std::string_view style, double head = 0);
  void arrow(layer on, const point& from, const point& to, std::string_view style);
  void circle(layer on, const point& center, double radius, std::string_view style);
  /// The ellipse { center + s : sᵀ S⁻¹ s = 1 }.
  void ellipse(layer on, const point& center, const Eigen::Matrix2d& s, std::string_view style);
  /// A label near a point, preferably in the given direction from it, outside a mark with the given radius.
  void label(const point& at, const point& direction, text words, std::string_view style, double radius = 0);

  const point& least() const { return least_; }
  const point& most() const { return most_; }

  /// The file contents, including a title for readers who cannot see the figure.
  std::string svg(std::string_view title);

private:
  struct pending_label {
    point at, direction;
    text words;
    std::string style;
    double radius; ///< of the mark at the point
  };
  struct box {
    point least = point::Zero(), most = point::Zero();
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

namespace detail {

/// A length in pixels, rounded to a tenth and written independently of the locale.
inline std::string pixels(double number) {
  const long tenths = std::lround(10 * number);
  std::string digits = std::to_string(tenths / 10);
  if (tenths < 0 && tenths > -10) digits = "-" + digits;
  if (tenths % 10 != 0) digits += "." + std::to_string(std::abs(tenths % 10));
  return digits;
}

inline std::string at(const canvas::point& p) { return pixels(p(0)) + ' ' + pixels(-p(1)); }

inline canvas::point turned(const canvas::point& v, double angle) {
  return {std::cos(angle) * v(0) - std::sin(angle) * v(1), std::sin(angle) * v(0) + std::cos(angle) * v(1)};
}

/// A text as the contents of an XML element. Control characters become spaces; each invalid byte becomes
/// U+FFFD.
inline std::string escaped(std::string_view plain) {
  std::string out;
  while (!plain.empty()) {
    const std::size_t length = base::bytes_of_first_character(plain);
    const char c = plain[0];
    if (length == 0)
      out += "\xEF\xBF\xBD";
    else if (length > 1)
      out += plain.substr(0, length);
    else
      out += c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '&' ? "&amp;" : std::string(1, c < ' ' ? ' ' : c);
    plain.remove_prefix((std::max)(length, std::size_t{1}));
  }
  return out;
}

inline constexpr std::string_view style_sheet = R"(<style>
  .figure { --ink: #1b1f24; --pale: #8a94a0; --paper: #ffffff; --accent: #b5382f; --b0: #3d6b99; --b1: #b5782f;
    --b2: #4b8b5a; --b3: #8a5a9e; --b4: #9c4a4a; --b5: #4a8d96; font: 13px Georgia, 'Times New Roman', serif; }
  @media (prefers-color-scheme: dark) { .figure { --ink: #e4e7eb; --pale: #838c97; --paper: #16191d;
    --accent: #ec7b70; --b0: #6fa3d6; --b1: #dca25e; --b2: #7cc08c; --b3: #be8fd2; --b4: #d98080; --b5: #7bc0ca; } }
  .figure path, .figure line, .figure circle, .figure ellipse { fill: none; stroke: var(--ink); stroke-linecap: round;
    stroke-linejoin: round; stroke-width: 1.4; }
  .figure text { fill: var(--ink); stroke: var(--paper); stroke-width: 3; paint-order: stroke; font-style: italic; }
  .figure .sub { font-size: 9.5px; }
  .figure .name { font-style: normal; }
  .figure .pale { stroke: var(--pale); stroke-width: 1; }
  .figure .dashed { stroke: var(--pale); stroke-width: 1; stroke-dasharray: 4 3; }
  .figure .load { stroke: var(--accent); stroke-width: 1.8; }
  .figure text.load, .figure text.angle { stroke: var(--paper); stroke-width: 3; }
  .figure text.load { fill: var(--accent); }
  .figure .head { fill: var(--ink); stroke: none; }
  .figure .load.head { fill: var(--accent); }
  .figure .pale.head { fill: var(--pale); }
  .figure .filled { fill: var(--ink); }
  .figure .hollow { fill: var(--paper); }
  .figure .solid { stroke-width: 11; opacity: 0.45; }
  .figure .volume { opacity: 0.35; stroke-width: 1; }
)";

} // namespace detail

inline void canvas::cover(const point& p) {
  if (covered_.empty()) least_ = most_ = p;
  covered_.push_back(p);
  least_ = least_.cwiseMin(p), most_ = most_.cwiseMax(p);
}

inline void canvas::cover_line(const point& from, const point& to) {
  const int pieces = 1 + static_cast<int>((to - from).norm() / 4);
  for (int i = 0; i <= pieces; ++i) cover(from + (to - from) * i / pieces);
}

inline void canvas::line(layer on, const point& from, const point& to, std::string_view style) {
  path(on, {from, to}, style);
}

inline void canvas::path(layer on, const std::vector<point>& through, std::string_view style, double head) {
  std::string d;
  for (std::size_t i = 0; i < through.size(); ++i) {
    d += (i == 0 ? "M" : " L") + detail::at(through[i]);
    if (i > 0) cover_line(through[i - 1], through[i]);
  }
  element(on, "<path class=\"" + std::string(style) + "\" d=\"" + d + "\"/>");
  if (head <= 0 || through.size() < 2) return;
  const point tip = through.back(), along = (tip - through[through.size() - 2]).normalized() * head,
              across = 0.36 * point(-along(1), along(0));
  element(on, "<path class=\"" + std::string(style) + " head\" d=\"M" + detail::at(tip + 0.1 * along) + " L" +
                  detail::at(tip - along + across) + " L" + detail::at(tip - along - across) + " Z\"/>");
}

inline void canvas::arrow(layer on, const point& from, const point& to, std::string_view style) {
  path(on, {from, to}, style, 9);
}

inline void canvas::circle(layer on, const point& center, double radius, std::string_view style) {
  cover(center - point(radius, radius)), cover(center + point(radius, radius)), cover(center);
  element(on, "<circle class=\"" + std::string(style) + "\" cx=\"" + detail::pixels(center(0)) + "\" cy=\"" +
                  detail::pixels(-center(1)) + "\" r=\"" + detail::pixels(radius) + "\"/>");
}

inline void canvas::ellipse(layer on, const point& center, const Eigen::Matrix2d& s, std::string_view style) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(s);
  const Eigen::Vector2d radii = axes.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  const point first = axes.eigenvectors().col(0) * radii(0), second = axes.eigenvectors().col(1) * radii(1);
  for (const point& p : {first, second}) cover(center + p), cover(center - p);
  const double angle = -std::atan2(first(1), first(0)) * 180 / std::numbers::pi;
  element(on, "<ellipse class=\"" + std::string(style) + "\" rx=\"" + detail::pixels(radii(0)) + "\" ry=\"" +
                  detail::pixels(radii(1)) + "\" transform=\"translate(" + detail::at(center) + ") rotate(" +
                  detail::pixels(radii(0) > 0 ? angle : 0) + ")\"/>");
}

inline void canvas::label(const point& at, const point& direction, text words, std::string_view style,
                          double radius) {
  labels_.push_back(
      {at, direction.isZero() ? point(1, 1) : direction, std::move(words), std::string(style), radius});
}

inline canvas::box canvas::box_of(const pending_label& each, double turn, double distance) const {
  const point half(each.words.width / 2 + 1, 7), away = detail::turned(each.direction.normalized(), turn);
  const double reach = (std::min)(half(0) / (std::max)(std::abs(away(0)), 1e-9),
                                  half(1) / (std::max)(std::abs(away(1)), 1e-9));
  const point middle = each.at + away * (reach + distance);
  return {middle - half, middle + half};
}

inline double canvas::cost_of(const box& b) const {
  double cost = 0;
  for (const box& other : placed_) {
    const point shared = b.most.cwiseMin(other.most) - b.least.cwiseMax(other.least);
    if (shared.minCoeff() > 0) cost += 30 + shared.prod();
  }
  for (const point& p : covered_)
    if ((p - b.least).minCoeff() > 0 && (b.most - p).minCoeff() > 0) cost += 3;
  return cost;
}

inline void canvas::place(const pending_label& each) {
  double least_cost = std::numeric_limits<double>::infinity();
  box best{};
  for (const double distance : {5.0, 11.0, 20.0, 32.0})
    for (int i = 0; i < 16; ++i) {
      const int sixteenths = (i % 2 == 0 ? 1 : -1) * ((i + 1) / 2); // 0, -1, 1, -2, 2, …
      const double turn = sixteenths * std::numbers::pi / 8;
      const box b = box_of(each, turn, each.radius + distance);
      const double cost = cost_of(b) + std::abs(turn) + distance / 6;
      if (cost < least_cost) least_cost = cost, best = b;
    }
  placed_.push_back(best);
  least_ = least_.cwiseMin(best.least), most_ = most_.cwiseMax(best.most);
  element(layer::labels, "<text class=\"" + each.style + "\" x=\"" + detail::pixels(best.least(0) + 1) +
                             "\" y=\"" + detail::pixels(-best.least(1) - 3) + "\">" + each.words.svg +
                             "</text>");
}

inline std::string canvas::svg(std::string_view title) {
  for (const pending_label& each : labels_) place(each);
  labels_.clear();
  const double margin = 8;
  const point size = most_ - least_ + point(2 * margin, 2 * margin);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"figure\" role=\"img\" viewBox=\"" +
                    detail::at({least_(0) - margin, most_(1) + margin}) + ' ' + detail::pixels(size(0)) +
                    ' ' + detail::pixels(size(1)) + "\" width=\"" + detail::pixels(size(0)) + "\" height=\"" +
                    detail::pixels(size(1)) + "\">\n<title>" + detail::escaped(title) + "</title>\n" +
                    std::string(detail::style_sheet);
  for (int i = 0; i < 6; ++i) {
    const std::string b = "b" + std::to_string(i);
    out += ' ';
    for (const char* rule : {" { stroke", ".volume { fill", ".filled { fill"})
      out.append(" .figure .").append(b).append(rule).append(": var(--").append(b).append("); }");
    out += '\n';
  }
  out += "</style>\n";
  for (const std::string& each : layers_) out += each;
  return out + "</svg>\n";
}

} // namespace kanexpr::figures
