#pragma once

#include <pinocchio/multibody.hpp>
#include <pinocchio/multibody/joint.hpp>

#include <fstream>
#include <stdexcept>
#include <string>

namespace peers {

/// A tree of links as kanexpr/model_numbers.hpp writes it.
struct robot {
  pinocchio::Model model;
  int inputs = 0; ///< torques of the last joints
};

inline pinocchio::JointModel joint_about(int axis) {
  switch (axis) {
  case 0: return pinocchio::JointModelRX();
  case 1: return pinocchio::JointModelRY();
  case 2: return pinocchio::JointModelRZ();
  case -1: return pinocchio::JointModelFreeFlyer();
  }
  throw std::runtime_error("a joint about no axis");
}

inline robot read_model(const std::string& path) {
  using namespace pinocchio;
  std::ifstream file(path);
  robot read;
  std::string what;
  int coordinates = 0, speeds = 0;
  while (file >> what) {
    const auto vector = [&] {
      Eigen::Vector3d v;
      file >> v(0) >> v(1) >> v(2);
      return v;
    };
    if (what == "gravity") {
      read.model.gravity.linear() = vector();
    } else if (what == "inputs") {
      file >> read.inputs;
    } else if (what == "coordinates") {
      file >> coordinates;
    } else if (what == "speeds") {
      file >> speeds;
    } else if (what == "link") {
      int parent = 0, axis = 0;
      double mass = 0;
      file >> parent >> axis >> mass;
      const Eigen::Vector3d center = vector(), moments = vector(), products = vector(); // xy, yz, zx
      Eigen::Matrix3d inertia, home;
      inertia << moments(0), products(0), products(2), products(0), moments(1), products(1), products(2),
          products(1), moments(2);
      for (int i = 0; i < 3; ++i) home.row(i) = vector();
      const SE3 placement(home, vector());
      const JointIndex joint = read.model.addJoint(static_cast<JointIndex>(parent + 1), joint_about(axis),
                                                   placement, "joint" + std::to_string(read.model.njoints));
      read.model.appendBodyToJoint(joint, Inertia(mass, center, inertia), SE3::Identity());
    } else {
      throw std::runtime_error("what is " + what + "?");
    }
  }
  if (read.model.nq != coordinates || read.model.nv != speeds || speeds == 0)
    throw std::runtime_error(path + " is no tree of links");
  return read;
}

} // namespace peers
