#pragma once

#include <kanexpr/robots/articulation.hpp>
#include <kanexpr/robots/check_robot.hpp>
#include <kanexpr/robots/options.hpp>
#include <kanexpr/robots/sdf/joint_reader.hpp>
#include <kanexpr/robots/sdf/notes.hpp>

#include <sdf/Error.hh>
#include <sdf/Model.hh>
#include <sdf/ParserConfig.hh>
#include <sdf/Root.hh>
#include <sdf/World.hh>

#include <algorithm>
#include <exception>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace kanexpr::robots::sdf {

/// Reads the only model of a file.
class reader {
public:
  reader(urdf::document& from, const reading_options& options) : from_(from), options_(options) {}

  /// Reads the text; returns true if it describes a robot without errors.
  bool read(const std::string& text) {
    const urdf::element* const root = from_.open(text);
    if (!root) return from_.fail(1, "there is no element, so the file does not describe a robot");
    if (std::string_view(root->Name()) != "sdf")
      return from_.fail(*root, "the root element is <" + printable(root->Name()) + ">, expected <sdf>");
    const messages printed;
    ::sdf::ParserConfig strict;
    strict.SetUnrecognizedElementsPolicy(::sdf::EnforcementPolicy::WARN);
    ::sdf::Root file;
    try {
      if (!has_no_errors(file.LoadSdfString(text, strict))) return false;
    } catch (const std::exception& e) { // for example, an invalid number in the version
      return from_.fail(std::string("libsdformat failed: ") + printable(e.what()));
    }
    const ::sdf::Model* const model = model_of(file);
    if (!model) return false;
    robot.name = model->Name();
    printed.note_in(from_);
    unsupported_elements(from_).note_in(file.Element());
    if (file.WorldCount() == 1) robot.gravity = vector_of(file.WorldByIndex(0)->Gravity());
    Pose3d model_pose;
    if (!model->SemanticPose().Resolve(model_pose).empty()) model_pose = model->RawPose();
    return read_links(*model, "", model_pose) && read_joints(*model, "") &&
           (!options_.mimic || joints_.read_mimics()) && is_robot(*model) && (simplify_gravity(robot), true);
  }

  robots::robot robot{};

private:
  /// Returns true if libsdformat found no errors. Inertias that are not physical are accepted here, although
  /// libsdformat rejects them in a world.
  bool has_no_errors(const ::sdf::Errors& errors) {
    const auto is_inertia = [](const ::sdf::Error& e) {
      return e.Code() == ::sdf::ErrorCode::LINK_INERTIA_INVALID;
    };
    const auto worst = std::ranges::find_if_not(errors, is_inertia);
    if (worst == errors.end()) return true;
    const auto first = std::ranges::find_if(errors, is_inertia);
    const ::sdf::Error& e = first == errors.end() ? *worst : *first;
    const std::string message = e.Message();
    const std::string said = "libsdformat reports: " + printable(message.substr(0, message.find('\n')), 200);
    return e.LineNumber() ? from_.fail(*e.LineNumber(), said) : from_.fail(said);
  }

  const ::sdf::Model* model_of(const ::sdf::Root& file) {
    if (file.Model()) return file.Model();
    const bool one_world = file.WorldCount() == 1;
    const std::uint64_t models = one_world ? file.WorldByIndex(0)->ModelCount() : 0;
    if (models == 1) return file.WorldByIndex(0)->ModelByIndex(0);
    from_.fail("the file has " + (one_world ? std::to_string(models) + " models" : "no model") +
               ", expected one");
    return nullptr;
  }

  bool read_links(const ::sdf::Model& m, const std::string& scope, const Pose3d& model_pose) {
    if (m.Static()) return from_.fail(line_of(m), "the model " + printable(m.Name()) + " is static");
    for (std::uint64_t i = 0; i < m.LinkCount(); ++i) {
      const ::sdf::Link& l = *m.LinkByIndex(i);
      Pose3d at;
      if (!l.SemanticPose().Resolve(at, "__model__").empty())
        return from_.fail(line_of(l), "the pose of link " + printable(l.Name()) + " cannot be resolved");
      const std::string called = scope + l.Name();
      link read;
      if (!link_reader(from_).read(l, called, read)) return false;
      links_.index_by_name.emplace(called, static_cast<int>(robot.links.size()));
      links_.poses.push_back(model_pose * at);
      read.weightless = l.Element() && !l.Element()->Get<bool>("gravity", true).first;
      robot.links.push_back(std::move(read));
    }
    for (std::uint64_t i = 0; i < m.ModelCount(); ++i) {
      const ::sdf::Model& inner = *m.ModelByIndex(i);
      Pose3d at;
      if (!inner.SemanticPose().Resolve(at, "__model__").empty())
        return from_.fail(line_of(inner),
                          "the pose of model " + printable(inner.Name()) + " cannot be resolved");
      if (!read_links(inner, scope + inner.Name() + "::", model_pose * at)) return false;
    }
    return true;
  }

  bool read_joints(const ::sdf::Model& m, const std::string& scope) {
    for (std::uint64_t i = 0; i < m.JointCount(); ++i)
      if (!joints_.read(*m.JointByIndex(i), scope)) return false;
    for (std::uint64_t i = 0; i < m.ModelCount(); ++i)
      if (!read_joints(*m.ModelByIndex(i), scope + m.ModelByIndex(i)->Name() + "::")) return false;
    return true;
  }

  /// Completes the robot and checks it. Its root must be upright: if the root link is rotated, an upright
  /// link named after the model is added below it.
  bool is_robot(const ::sdf::Model& m) {
    const found_root found = root_of(robot);
    if (!found.mistake.empty()) return from_.fail(line_of(m), found.mistake);
    robot.root = found.link;
    const Pose3d without_position(ignition::math::Vector3d::Zero, entry(links_.poses, found.link).Rot());
    const pose tilt = pose_of(without_position, from_.tolerance());
    if (tilt.orientation != no_rotation) {
      joint upright;
      upright.name = robot.name + "_stands";
      upright.parent = static_cast<int>(robot.links.size());
      upright.child = found.link;
      upright.origin = tilt;
      robot.root = upright.parent;
      link below;
      below.name = robot.name;
      robot.links.push_back(std::move(below));
      robot.joints.push_back(std::move(upright));
    }
    const std::string wrong = check_robot(robot);
    return wrong.empty() || from_.fail(line_of(m), wrong);
  }

  urdf::document& from_;
  reading_options options_;
  placed_links links_{};
  joint_reader joints_{from_, links_, robot};
};

} // namespace kanexpr::robots::sdf
