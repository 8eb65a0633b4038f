#pragma once

#include "flexible/lumped_body.hpp"

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <cstddef>

/// Bodies that consist of particles, as files of modes.
namespace lumped {

using nlohmann::json;

inline json list_of(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

inline json list_of(const Eigen::MatrixXd& m) {
  json rows = json::array();
  for (Eigen::Index i = 0; i < m.rows(); ++i) {
    json row = json::array();
    for (Eigen::Index j = 0; j < m.cols(); ++j) row.push_back(m(i, j));
    rows.push_back(row);
  }
  return rows;
}

/// A list with an entry for each particle.
template <class Function>
json each_particle(const body& b, const Function& f) {
  json all = json::array();
  for (const particle& p : b.particles) all.push_back(f(p));
  return all;
}

/// The file that describes a body by its nodes. The last node is called 12.
inline json file_of(const body& b) {
  json file;
  file["positions"] = each_particle(b, [](const particle& p) { return list_of(p.place); });
  file["masses"] = each_particle(b, [](const particle& p) { return json(p.mass); });
  for (std::size_t i = 0; i < b.particles.size(); ++i) file["nodes"].push_back(8 + i);
  file["attachments"] = {7 + b.particles.size()};
  for (int k = 0; k < b.amplitudes; ++k) {
    file["shapes"].push_back(each_particle(b, [&](const particle& p) { return list_of(p.shape_of(k)); }));
    file["rotations"].push_back(
        each_particle(b, [&](const particle& p) { return list_of(b.turn_of(p, k)); }));
    json row = json::array();
    for (int l = 0; l < b.amplitudes; ++l)
      row.push_back(each_particle(b, [&](const particle& p) { return list_of(p.bend_of(k, l)); }));
    file["bends"].push_back(row);
  }
  if (b.rotates()) {
    file["inertias"] =
        each_particle(b, [](const particle& p) { return list_of(Eigen::MatrixXd(p.inertia)); });
    for (int k = 0; k < b.amplitudes; ++k) {
      json row = json::array();
      for (int l = 0; l < b.amplitudes; ++l)
        row.push_back(each_particle(b, [&](const particle& p) { return list_of(p.turn_bend_of(k, l)); }));
      file["rotation_bends"].push_back(row);
    }
  }
  file["stiffness"] = list_of(b.stiffness);
  file["damping"] = list_of(b.damping);
  return file;
}

} // namespace lumped
