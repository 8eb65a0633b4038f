#pragma once

#include <kanexpr/base/equal.hpp>
#include <kanexpr/base/sequence.hpp>
#include <kanexpr/derivation/read/freed_joints.hpp>
#include <kanexpr/derivation/read/phrase_reader.hpp>
#include <kanexpr/describe/frame.hpp>
#include <kanexpr/describe/pathway.hpp>
#include <kanexpr/describe/wheel_record.hpp>
#include <kanexpr/mechanics/checks/check.hpp>
#include <kanexpr/mechanics/model/components.hpp>
#include <kanexpr/mechanics/model/fixed.hpp>
#include <kanexpr/mechanics/model/frames.hpp>
#include <kanexpr/mechanics/model/mechanism.hpp>
#include <kanexpr/mechanics/model/turned_with.hpp>
#include <kanexpr/mechanics/skeleton/skeleton.hpp>
#include <kanexpr/symbolic/graph/expression.hpp>

#include <string_view>

namespace kanexpr::derivation {

/// Reads the frames and points of a model, each at its first mention, after all entities on which it depends.
class entity_reader {
public:
  constexpr entity_reader(reading& all, phrase_reader& phrases)
      : reading_(all), m_(all.into.mechanism), phrases_(phrases), freed_(all) {}

  /// Reads the entities that a phrase mentions.
  constexpr void visit(const describe::token* tokens, int size, std::string_view whom = "an expression"sv) {
    phrases_.check_misuse({shape::scalar, tokens, size}, whom);
    mechanics::known_motion* const known = reading_.known;
    if (reading_.from.inertial != nullptr)
      reading_.known = nullptr; // only a system given by words can mention additional entities
    for (int i = 0; i < size && !reading_.mistake; ++i) {
      if (tokens[i].frame != nullptr) frame(tokens[i].frame, whom);
      if (tokens[i].point != nullptr) point(tokens[i].point, whom);
      if (tokens[i].load != nullptr && tokens[i].load->path != nullptr) visit(*tokens[i].load->path, whom);
      if (tokens[i].load != nullptr && tokens[i].load->wheel != nullptr) visit(*tokens[i].load->wheel, whom);
    }
    reading_.known = known;
  }

  /// Reads the entities that a pathway mentions.
  constexpr void visit(const describe::path_record& r, std::string_view whom) {
    for (const point_record& each : r.points)
      if (!reading_.mistake) point(&each, whom);
    if (r.center != nullptr && !reading_.mistake) point(r.center, whom);
    if (r.frame != nullptr && !reading_.mistake) frame(r.frame, whom);
    for (const phrase* each : {&r.length, &r.axis, &r.size})
      if (!reading_.mistake) visit(each->tokens, each->size, whom);
  }

  /// Reads the entities that a wheel and its ground mention.
  constexpr void visit(const describe::wheel_record& r, std::string_view whom) {
    if (!r.mistake.empty()) return;
    for (const point_record* each : {r.center, r.place})
      if (!reading_.mistake) point(each, whom);
    for (const frame_record* each : {r.frame, r.ground_frame})
      if (each != nullptr && !reading_.mistake) frame(each, whom);
    for (const phrase* each : describe::phrases_of(r))
      if (!reading_.mistake) visit(each->tokens, each->size, whom);
  }

  /// Adds to a derived system the entities that phrases mention but the system itself does not use. If there
  /// is a mistake, they are discarded, because the system is valid without them.
  constexpr void add_late_entities() {
    if (reading_.known == nullptr) return;
    const mechanics::skeleton& s = reading_.known->skeleton_used();
    const int frames = s.rigid_with.size(), points = s.station_of_point.size();
    if (!reading_.mistake && reading_.known->lacks_any()) {
      reading_.mistake = mechanics::check_added_entities(reading_.into, frames, points);
      if (!reading_.mistake) reading_.known->extend();
    }
    if (reading_.mistake) forget_after(frames, points);
  }

  constexpr const sequence<const frame_record*>& frames_read() const { return frames_; }
  constexpr const sequence<const point_record*>& points_read() const { return points_; }

  /// The state that is kept if there is no mistake and nothing is being read.
  template <class Self, class Visit>
  static constexpr void each_member(Self& self, Visit&& visit) {
    visit(self.frames_, self.places_of_frames_, self.points_);
  }

  /// Returns the index of a frame that `whom` mentions; reads the frame and its ancestors if necessary.
  constexpr int frame(const frame_record* r, std::string_view whom) {
    for (int i = 0; i < frames_.size(); ++i)
      if (frames_[i] == r) return places_of_frames_[i];
    if (reading_.known != nullptr)
      reading_.fail({"frame ", r->called, " of ", whom, " is not part of the derived system"});
    check_frame(*r, whom);
    if (reading_.mistake) return mechanism::inertial;
    const int describing_before = reading_.describing;
    reading_.describing = none;
    open_frames_.push(r);
    const frame_record& record = *freed_.record_of(r);
    const int parent = record.parent != nullptr ? frame(record.parent, record.called) : none;
    if (reading_.mistake) return mechanism::inertial;
    const frame_record* const parent_before = reading_.parent;
    reading_.parent = record.parent;
    const int place = add_frame(record, parent);
    reading_.parent = parent_before;
    open_frames_.pop();
    frames_.push(r);
    places_of_frames_.push(place);
    if (record.reference != nullptr && !reading_.mistake) {
      reading_.describing = place;
      const int reference = frame(record.reference, record.called);
      const mechanics::vector w = phrases_.vector_of(
          record.angular_velocity, {"the angular velocity of frame "sv, record.called}, record.called);
      freed_.check_reference(record);
      if (!reading_.mistake) m_.frames[place].declare_angular_velocity(reference, w, record.turns_apart);
    }
    reading_.describing = describing_before;
    return place;
  }

  constexpr int point(const point_record* r, std::string_view whom) {
    const int present = points_.find(r);
    if (present >= 0) return present;
    if (reading_.known != nullptr)
      reading_.fail({"point ", r->called, " of ", whom, " is not part of the derived system"});
    check_point(*r, whom);
    if (reading_.mistake) return 0;
    const point_record& record = *freed_.record_of(r);
    mechanics::point p;
    p.called = base::name(record.called);
    if (record.parent != nullptr) {
      open_points_.push(r);
      p.parent = point(record.parent, record.called);
      open_points_.pop();
      p.offset = phrases_.vector_of(record.offset, {"the offset of point "sv, record.called}, record.called);
      const frame_record* const on = freed_.frame_below(record);
      if (on != nullptr && !reading_.mistake)
        p.offset = mechanics::turned_with(m_, p.offset, frame(on, record.called));
    } else if (frame(record.origin_of, record.called) != mechanism::inertial) {
      reading_.fail(
          {"origin ", r->called, " is not fixed in the inertial frame; a point that moves needs an offset"});
    }
    if (record.fixed_in != nullptr) p.fixed_in = frame(record.fixed_in, record.called);
    if (record.reference != nullptr) {
      const int reference = frame(record.reference, record.called);
      const mechanics::vector v =
          phrases_.vector_of(record.velocity, {"the velocity of point "sv, record.called}, record.called);
      p.moves_apart = record.moves_apart;
      if (reference == mechanism::inertial && !record.from_parent) freed_.check_reference(record);
      p.declare_velocity(reference, v, record.from_parent || reference != mechanism::inertial);
    }
    if (reading_.mistake) return 0;
    points_.push(r);
    return m_.points.push(p);
  }

private:
  constexpr bool is_listed(const frame_record& of_joint) const {
    for (const describe::joint_record& r : reading_.from.joints)
      if (r.frame == &of_joint) return true;
    return false;
  }

  /// Checks the beam and the place of a section.
  constexpr bool is_on_listed_beam(std::string_view section, const describe::body_record& beam,
                                   bool is_off_beam, bool is_at_whole_zero) {
    if (beam.beam == nullptr)
      reading_.fail({"section ", section, " is placed on ", beam.called, ", which is not a beam"});
    bool is_listed = false;
    for (const describe::body_record& r : reading_.from.bodies) is_listed = is_listed || &r == &beam;
    if (!is_listed)
      reading_.fail(
          {"beam ", beam.called, ", on which section ", section, " is placed, is not listed in bodies<...>"});
    if (is_off_beam)
      reading_.fail({"section ", section, " is not on beam ", beam.called,
                     "; its place is a fraction of the length, a number from 0 to 1"});
    if (is_at_whole_zero)
      reading_.fail({"section ", section, " of beam ", beam.called,
                     " is at 0, which is also the value of 1/2 in C++; write 0.5, or 0.0 for the root"});
    return !reading_.mistake;
  }

  /// Checks the body of a node, and whether the body has the node.
  constexpr bool is_on_listed_body(std::string_view node, const describe::body_record& body,
                                   std::string_view missing) {
    if (body.flexible == nullptr)
      reading_.fail({"node ", node, " belongs to ", body.called, ", which is not a flexible_body<...>"});
    bool is_listed = false;
    for (const describe::body_record& r : reading_.from.bodies) is_listed = is_listed || &r == &body;
    if (!is_listed)
      reading_.fail({"flexible body ", body.called, ", to which node ", node,
                     " belongs, is not listed in bodies<...>"});
    if (!missing.empty())
      reading_.fail({"node ", node, " is node ", missing, " of ", body.called, ", which has no such node"});
    return !reading_.mistake;
  }

  constexpr void forget_after(int frames, int points) {
    for (; !frames_.empty() && places_of_frames_.back() >= frames; frames_.pop()) places_of_frames_.pop();
    while (m_.frames.size() > frames) m_.frames.pop();
    while (points_.size() > points) points_.pop();
    while (m_.points.size() > points) m_.points.pop();
    open_frames_.clear();
    open_points_.clear();
  }

  /// Reports a type that is used as a frame or point but is something else.
  constexpr void fail_by_kind(std::string_view kind, std::string_view called, std::string_view whom,
                              std::string_view instead, std::string_view its_own) {
    if (instead.empty())
      return reading_.fail(
          {called, ", which ", whom, " uses as a ", kind, ", is not a ", kind, ", or is defined later"});
    const bool has_own = !its_own.empty();
    reading_.fail({called, ", which ", whom, " uses as a ", kind, ", is ", instead, has_own ? "; its " : "",
                   has_own ? kind : "", has_own ? " is " : "", its_own});
  }

  /// Checks the word of a frame or a point; returns whether it is valid.
  template <class Record>
  constexpr bool check_kind(std::string_view kind, const Record& r, std::string_view whom) {
    if (r.unparsed)
      reading_.fail_by_unparsed(r.called, whom);
    else if (!reading_.check_base_conflict(r.conflict, r.called))
      return false;
    else if (r.declared_name.empty())
      fail_by_kind(kind, r.called, whom, r.instead, r.its_own);
    else if (!base::equal(r.called, r.declared_name))
      reading_.fail_by_self(kind, r.called, r.declared_name);
    else
      return true;
    return false;
  }
  template <class Record>
  constexpr void check_name(std::string_view kind, const Record& r, const sequence<const Record*>& known,
                            const sequence<const Record*>& open) {
    for (const sequence<const Record*>* list : {&known, &open})
      for (const Record* other : *list)
        if (base::equal(other->called, r.called)) reading_.fail({"two ", kind, "s are called ", r.called});
  }

  constexpr void check_frame(const frame_record& r, std::string_view whom) {
    if (!check_kind("frame"sv, r, whom)) return;
    if (r.is_of_joint && !is_listed(r))
      return reading_.fail({"joint ", r.called, ", which ", whom, " uses, is not listed in joints<...>"});
    if (r.on_beam != nullptr && !is_on_listed_beam(r.called, *r.on_beam, false, false)) return;
    if (r.on_flexible != nullptr && !is_on_listed_body(r.called, *r.on_flexible, r.missing_node)) return;
    if (!r.fits) return reading_.fail_by_argument_count("frame ", r.called, r.fits);
    const frame_record* const inertial = reading_.from.inertial;
    if (&r == inertial && r.orientation != describe::orientation_word::inertial)
      reading_.fail(
          {"inertial<...> names frame ", r.called, ", which is oriented relative to ", r.parent->called});
    if (r.orientation == describe::orientation_word::inertial && &r != inertial)
      reading_.fail({"frame ", r.called, ", which ", whom, " uses, is not connected to the inertial frame ",
                     inertial->called});
    if (&r == inertial && r.reference != nullptr)
      reading_.fail({"the inertial frame ", r.called, " has a declared angular velocity"});
    if (open_frames_.contains(&r)) reading_.fail({"frame ", r.called, " is oriented relative to itself"});
    check_name("frame"sv, r, frames_, open_frames_);
  }

  constexpr void check_point(const point_record& r, std::string_view whom) {
    if (!check_kind("point"sv, r, whom)) return;
    if (r.of_joint != nullptr && !is_listed(*r.of_joint))
      return reading_.fail({"joint ", r.called, ", which ", whom, " uses, is not listed in joints<...>"});
    if (r.on_beam != nullptr && !is_on_listed_beam(r.called, *r.on_beam, r.is_off_beam, r.is_at_whole_zero))
      return;
    if (r.on_flexible != nullptr && !is_on_listed_body(r.called, *r.on_flexible, r.missing_node)) return;
    if (!r.fits) return reading_.fail_by_argument_count("point ", r.called, r.fits);
    if (r.parent == nullptr && (r.fixed_in != nullptr || r.reference != nullptr))
      reading_.fail(
          {"point ", r.called, " is an origin, fixed in the inertial frame, but has a declared motion"});
    if (open_points_.contains(&r)) reading_.fail({"point ", r.called, " is offset from itself"});
    check_name("point"sv, r, points_, open_points_);
    if (r.fixed_in != nullptr && r.reference != nullptr)
      reading_.fail(
          {"point ", r.called, " is fixed in ", r.fixed_in->called, ", but also has a declared velocity"});
  }

  constexpr int add_frame(const frame_record& r, int parent) {
    using describe::orientation_word;
    const base::name called(r.called);
    sequence<expression> given;
    for (const phrase& p : r.given) {
      if (p.kind == shape::nothing) continue;
      const bool is_left_out = r.reference != nullptr && p.is_whole_zero();
      given.push(is_left_out ? m_.zero() : phrases_.scalar_of(p, {r.given_as, r.called}, r.called));
    }
    if (reading_.mistake) return mechanism::inertial;
    switch (r.orientation) {
    case orientation_word::inertial: return mechanics::add_inertial_frame(m_, called);
    case orientation_word::rotated: {
      const mechanics::vector axis = phrases_.vector_of(r.axis, {"the axis of frame "sv, r.called}, r.called);
      if (reading_.mistake) return mechanism::inertial;
      const components a = mechanics::express(m_, axis, parent);
      if (a.is_zero()) reading_.fail({"frame ", r.called, " is rotated about an axis of zero length"});
      if (!mechanics::is_fixed(a))
        reading_.fail(
            {"frame ", r.called, " is rotated about an axis that is not fixed in ", r.parent->called});
      return reading_.mistake ? mechanism::inertial
                              : mechanics::add_rotated_frame(m_, called, parent, given[0], a);
    }
    case orientation_word::body_fixed:
    case orientation_word::space_fixed:
      if (!mechanics::is_sequence({r.sequence, 3})) {
        reading_.fail(
            {"frame ", r.called,
             " has an invalid rotation sequence; use three axes, no two consecutive ones equal: zxz"});
        return mechanism::inertial;
      }
      return mechanics::add_frame_by_sequence(m_, called, parent, {r.sequence, 3}, given,
                                              r.orientation == orientation_word::space_fixed);
    case orientation_word::quaternion:
      return mechanics::add_frame_by_quaternion(m_, called, parent, given[0], given[1], given[2], given[3]);
    case orientation_word::modified_rodrigues:
      return mechanics::add_frame_by_modified_rodrigues(m_, called, parent, {given[0], given[1], given[2]});
    case orientation_word::direction_cosines: {
      matrix3 to_parent(*m_.g);
      for (int i = 0; i < 9; ++i) to_parent(i / 3, i % 3) = given[i];
      return mechanics::add_frame_by_matrix(m_, called, parent, to_parent);
    }
    }
    return mechanism::inertial;
  }

  reading& reading_;
  mechanism& m_;
  phrase_reader& phrases_;
  freed_joints freed_;
  sequence<const frame_record*> frames_{};
  sequence<int> places_of_frames_{}; ///< a sequence of rotations has intermediate frames
  sequence<const point_record*> points_{};
  sequence<const frame_record*> open_frames_{}; ///< currently being read
  sequence<const point_record*> open_points_{};
};

constexpr entity_lookup lookup_in(entity_reader& all) {
  return {
      all,
      [](entity_reader& with, const frame_record* r, std::string_view whom) { return with.frame(r, whom); },
      [](entity_reader& with, const point_record* r, std::string_view whom) { return with.point(r, whom); }};
}

/// The common base of the readers of bodies, loads and other parts of a model.
class part_reader {
public:
  constexpr part_reader(reading& all, symbol_reader& symbols, phrase_reader& phrases, entity_reader& entities)
      : reading_(all), m_(all.into.mechanism), symbols_(symbols), phrases_(phrases), entities_(entities) {}

protected:
  /// Reads the entities and symbols of a phrase that is evaluated later.
  constexpr void mention(const phrase& p, std::string_view whom) {
    entities_.visit(p.tokens, p.size, whom);
    mention_symbols(p, whom);
  }
  /// Reads the entities and symbols of a pathway whose load is evaluated later.
  constexpr void mention(const describe::path_record& r, std::string_view whom) {
    entities_.visit(r, whom);
    mention_symbols(r, whom);
  }
  constexpr void mention_symbols(const describe::path_record& r, std::string_view whom) {
    for (const phrase* each : {&r.length, &r.axis, &r.size}) mention_symbols(*each, whom);
  }
  constexpr void mention_symbols(const describe::wheel_record& r, std::string_view whom) {
    for (const phrase* each : describe::phrases_of(r)) {
      reading_.is_on_surface = each == &r.height;
      mention_symbols(*each, whom);
    }
    reading_.is_on_surface = false;
  }
  constexpr void mention_symbols(const phrase& p, std::string_view whom) {
    for (const describe::token& t : p) {
      if (t.symbol != nullptr && !reading_.mistake) symbols_.symbol(*t.symbol, whom);
      if (t.load != nullptr && t.load->path != nullptr) mention_symbols(*t.load->path, whom);
      if (t.load != nullptr && t.load->wheel != nullptr) mention_symbols(*t.load->wheel, whom);
    }
  }

  reading& reading_;
  mechanism& m_;
  symbol_reader& symbols_;
  phrase_reader& phrases_;
  entity_reader& entities_;
};

} // namespace kanexpr::derivation
