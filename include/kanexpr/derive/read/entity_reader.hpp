#pragma once

#include <kanexpr/derive/read/misfit_wording.hpp>
#include <kanexpr/derive/read/phrase_reader.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/frames.hpp>

namespace kanexpr::deriving {

using describe::point_record;

/// The frames and points of a model, each read when it is first mentioned, after all that it hangs on.
class entity_reader : public phrase_reader<entity_reader> {
public:
  using phrase_reader::phrase_reader;

  /// Reads the entities that a phrase mentions. A system that is derived takes up those that it does not use
  /// itself.
  constexpr void visit(const describe::token* tokens, int size, std::string_view whom = "an expression") {
    check_written({shape::scalar, tokens, size}, whom);
    mechanics::equations* const derived = derived_;
    if (from_.inertial != nullptr) derived_ = nullptr; // only a system of words has words for more
    for (int i = 0; i < size && !mistake_; ++i) {
      if (tokens[i].frame != nullptr) frame(tokens[i].frame, whom);
      if (tokens[i].point != nullptr) point(tokens[i].point, whom);
    }
    derived_ = derived;
    if (derived_ == nullptr || mistake_) return;
    derived_->extend();
    mistake_ = derived_->mistake();
  }

  /// What is known of symbols and entities, where there is no mistake and nothing is being read.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    phrase_reader::each_member(self, visit);
    visit(self.frames_);
    visit(self.places_of_frames_);
    visit(self.points_);
  }

  /// The number of a frame that `whom` mentions; it and all that it hangs on are read if they were not yet.
  constexpr int frame(const frame_record* r, std::string_view whom) {
    for (int i = 0; i < frames_.size(); ++i)
      if (frames_[i] == r) return places_of_frames_[i];
    if (derived_ != nullptr)
      fail({"frame ", r->called, " of ", whom, " is not part of the system that was derived"});
    check_frame(*r, whom);
    if (mistake_) return mechanism::inertial;
    const int describing_before = describing_;
    describing_ = none;
    open_frames_.push(r);
    const int parent = r->parent != nullptr ? frame(r->parent, r->called) : none;
    if (mistake_) return mechanism::inertial;
    const int place = add_frame(*r, parent);
    open_frames_.pop();
    frames_.push(r);
    places_of_frames_.push(place);
    if (r->reference != nullptr && !mistake_) {
      describing_ = place;
      const int reference = frame(r->reference, r->called);
      const mechanics::vector w =
          vector_of(r->angular_velocity, {"the angular velocity of frame ", r->called}, r->called);
      if (!mistake_) mechanics::declare_angular_velocity(m_, place, reference, w, r->turns_apart);
    }
    describing_ = describing_before;
    return place;
  }

  constexpr int point(const point_record* r, std::string_view whom) {
    const int present = points_.find(r);
    if (present >= 0) return present;
    if (derived_ != nullptr)
      fail({"point ", r->called, " of ", whom, " is not part of the system that was derived"});
    check_point(*r, whom);
    if (mistake_) return 0;
    mechanics::point p;
    p.called = symbolic::name(r->called);
    if (r->parent != nullptr) {
      open_points_.push(r);
      p.parent = point(r->parent, r->called);
      open_points_.pop();
      p.offset = vector_of(r->offset, {"the offset of point ", r->called}, r->called);
    } else if (frame(r->origin_of, r->called) != mechanism::inertial) {
      fail({"origin ", r->called, " is not fixed in the inertial frame; a point that moves needs an offset"});
    }
    if (r->fixed_in != nullptr) p.fixed_in = frame(r->fixed_in, r->called);
    if (r->reference != nullptr) {
      p.reference = frame(r->reference, r->called);
      p.velocity = vector_of(r->velocity, {"the velocity of point ", r->called}, r->called);
    }
    if (mistake_) return 0;
    points_.push(r);
    return m_.points.push(p);
  }

protected:
  /// Whether an entity has no word twice, and only words that belong to it.
  constexpr bool words_belong(describe::misfit beside, std::string_view called) {
    if (beside == describe::misfit::none) return true;
    fail({misfit_of(beside, called).view()});
    return false;
  }

  /// `struct B : rotated<A, ...>` would be a second A.
  constexpr void slip(std::string_view kind, std::string_view called, std::string_view other) {
    fail({kind, called, " calls itself ", other, "; the first argument of what it is derived from must be ",
          called});
  }
  constexpr void wrong_count(std::string_view kind, std::string_view called, const describe::arguments& has) {
    fail({kind, called, has.missing > 0 ? " lacks an argument" : " has an argument too many", "; write ",
          has.form});
  }

private:
  /// What is used as a frame or point and is none.
  constexpr void no_such(std::string_view kind, std::string_view called, std::string_view whom,
                         std::string_view instead, std::string_view its_own) {
    if (instead.empty())
      return fail({called, ", which ", whom, " uses as a ", kind, ", is not a ", kind,
                   ", or is described only later"});
    const bool has_own = !its_own.empty();
    fail({called, ", which ", whom, " uses as a ", kind, ", is ", instead, has_own ? "; its " : "",
          has_own ? kind : "", has_own ? " is " : "", its_own});
  }

  constexpr void check_frame(const frame_record& r, std::string_view whom) {
    if (r.unparsed) return fail_by_unparsed(r.called, whom);
    if (!words_belong(r.beside, r.called)) return;
    if (r.calls_itself.empty()) return no_such("frame", r.called, whom, r.instead, r.its_own);
    if (r.called != r.calls_itself) return slip("frame ", r.called, r.calls_itself);
    if (!r.fits) return wrong_count("frame ", r.called, r.fits);
    if (&r == from_.inertial && r.orientation != describe::orientation_word::inertial)
      fail({"inertial<...> names frame ", r.called, ", which is oriented relative to ", r.parent->called});
    if (r.orientation == describe::orientation_word::inertial && &r != from_.inertial)
      fail({"frame ", r.called, ", which ", whom, " uses, is not connected to the inertial frame ",
            from_.inertial->called});
    if (&r == from_.inertial && r.reference != nullptr)
      fail({"the inertial frame ", r.called, " is given an angular velocity"});
    if (open_frames_.contains(&r)) fail({"frame ", r.called, " is oriented relative to itself"});
    for (const sequence<const frame_record*>* list : {&frames_, &open_frames_})
      for (const frame_record* f : *list)
        if (f->called == r.called) fail({"two frames are called ", r.called});
  }

  constexpr void check_point(const point_record& r, std::string_view whom) {
    if (r.unparsed) return fail_by_unparsed(r.called, whom);
    if (!words_belong(r.beside, r.called)) return;
    if (r.calls_itself.empty()) return no_such("point", r.called, whom, r.instead, r.its_own);
    if (r.called != r.calls_itself) return slip("point ", r.called, r.calls_itself);
    if (!r.fits) return wrong_count("point ", r.called, r.fits);
    if (r.parent == nullptr && (r.fixed_in != nullptr || r.reference != nullptr))
      fail({"point ", r.called, " is an origin, fixed in the inertial frame, and is given a motion"});
    if (open_points_.contains(&r)) fail({"point ", r.called, " is offset from itself"});
    for (const sequence<const point_record*>* list : {&points_, &open_points_})
      for (const point_record* p : *list)
        if (p->called == r.called) fail({"two points are called ", r.called});
    if (r.fixed_in != nullptr && r.reference != nullptr)
      fail({"point ", r.called, " is fixed in ", r.fixed_in->called,
            " and is given a velocity of its own as well"});
  }

  constexpr int add_frame(const frame_record& r, int parent) {
    using describe::orientation_word;
    const symbolic::name called(r.called);
    sequence<expression> given;
    for (const phrase& p : r.given)
      if (p.kind != shape::nothing) given.push(scalar_of(p, {what_is_given(r), r.called}, r.called));
    if (mistake_) return mechanism::inertial;
    switch (r.orientation) {
    case orientation_word::inertial: return mechanics::add_inertial_frame(m_, called);
    case orientation_word::rotated: {
      const mechanics::vector axis = vector_of(r.axis, {"the axis of frame ", r.called}, r.called);
      if (mistake_) return mechanism::inertial;
      const components a = mechanics::express(m_, axis, parent);
      if (a.is_zero()) fail({"frame ", r.called, " is turned about an axis of no length"});
      if (!mechanics::is_fixed(a))
        fail({"frame ", r.called, " is turned about an axis that is not fixed in ", r.parent->called});
      return mistake_ ? mechanism::inertial : mechanics::add_rotated_frame(m_, called, parent, given[0], a);
    }
    case orientation_word::body_fixed:
    case orientation_word::space_fixed:
      if (!mechanics::is_sequence({r.sequence, 3})) {
        fail({"frame ", r.called,
              " is turned by an invalid sequence; take three axes, no two neighbours alike: zxz"});
        return mechanism::inertial;
      }
      return mechanics::add_frame_by_sequence(m_, called, parent, {r.sequence, 3}, given,
                                              r.orientation == orientation_word::space_fixed);
    case orientation_word::quaternion:
      return mechanics::add_frame_by_quaternion(m_, called, parent, given[0], given[1], given[2], given[3]);
    case orientation_word::direction_cosines: {
      matrix3 to_parent(*m_.g);
      for (int i = 0; i < 9; ++i) to_parent(i / 3, i % 3) = given[i];
      return mechanics::add_frame_by_matrix(m_, called, parent, to_parent);
    }
    }
    return mechanism::inertial;
  }

  sequence<const frame_record*> frames_{};
  sequence<int> places_of_frames_{}; ///< a sequence of turns has frames of its own in between
  sequence<const point_record*> points_{};
  sequence<const frame_record*> open_frames_{}; ///< that are being read
  sequence<const point_record*> open_points_{};
};

} // namespace kanexpr::deriving
