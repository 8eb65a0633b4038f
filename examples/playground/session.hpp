#pragma once

#include "playground/model/build.hpp"
#include "playground/model/sentences.hpp"
#include "playground/moving/moving_model.hpp"
#include "playground/moving/picture.hpp"

#include <kanexpr/compiled/values_reader.hpp>
#include <kanexpr/runtime/model.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace playground {

/// A text with everything that follows from it: the model, its motion and its figure. If the text has a
/// mistake, there is nothing else.
class session {
public:
  explicit session(std::string_view text) : built_(build(text)) {
    if (built_.wrong.sentence.empty()) start();
    built_.wrong.sentence = in_words_of_texts(built_.wrong.sentence);
  }
  session(const session&) = delete;
  session& operator=(const session&) = delete;

  const mistake& wrong() const { return built_.wrong; }
  kanexpr::model& model() { return *model_; }
  moving_model& moving() { return *moving_; }
  const moving_model& moving() const { return *moving_; }
  picture& figure() { return *picture_; }

  const std::vector<line>& lines() const { return built_.lines; }
  const kanexpr::runtime::builder& builder() const { return built_.made->b; }

  /// The value of a symbol, in the order of all symbols.
  double value(int i) const {
    const int states = moving_->states(), parameters = moving_->known().parameters;
    if (i < states) return moving_->x(i);
    return i < states + parameters ? moving_->p(i - states) : moving_->r(i - states - parameters);
  }

private:
  void start() {
    model_.emplace(kanexpr::derive(built_.made->b));
    model_->rhs(); // finds mistakes that only show in the equations
    if (const std::string mistake = model_->mistake(); !mistake.empty()) return refuse(mistake);
    moving_.emplace(*model_, built_.made->start);
    if (const std::string mistake = model_->mistake(); !mistake.empty()) return refuse(mistake);
    if (const auto mistake = kanexpr::compiled::check_masses(moving_->known(), moving_->p.data()))
      return refuse(std::string(mistake.view()));
    if (!moving_->start()) return refuse("no state near the initial values satisfies the constraints");
    picture_.emplace(*model_, *moving_);
  }

  void refuse(const std::string& sentence) {
    built_.wrong = {line_named_in(sentence, built_.lines), sentence};
  }

  built_model built_;
  std::optional<kanexpr::model> model_{};
  std::optional<moving_model> moving_{};
  std::optional<picture> picture_{};
};

} // namespace playground
