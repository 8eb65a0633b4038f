// builds: clang++ sanitize all
// Flexible bodies from the modes of finite-element models, and the sentences that report invalid files.
#include "flexible/modes_file.hpp"
#include "flexible/sid_writer.hpp"

#include <kanexpr/flexible/read_modes.hpp>
#include <kanexpr/flexible/read_sid.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <numbers>
#include <random>
#include <string>
#include <utility>

namespace {

using namespace kanexpr;
using namespace kanexpr::flexible;
using lumped::file_of;
using lumped::Vector3d;
using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

lumped::body body_of(bool bends) {
  lumped::body b = lumped::random_body(2, 5, bends, 17);
  b.axes.setIdentity();
  return b;
}

void expect_near(const base::sequence<double>& a, const base::sequence<double>& b, const char* what) {
  ASSERT_EQ(a.size(), b.size()) << what;
  for (int i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-11) << what << i;
}

void expect_same(const mechanics::flexible_data& a, const mechanics::flexible_data& b) {
  EXPECT_NEAR(a.mass, b.mass, 1e-14);
  expect_near(a.first_moment.coefficients, b.first_moment.coefficients, "S");
  expect_near(a.inertia.coefficients, b.inertia.coefficients, "J");
  expect_near(a.angular.coefficients, b.angular.coefficients, "H");
  expect_near(a.modal_mass, b.modal_mass, "M");
  expect_near(a.stiffness, b.stiffness, "K");
  expect_near(a.damping, b.damping, "D");
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  for (int i = 0; i < a.nodes.size(); ++i) {
    EXPECT_EQ(a.nodes[i].called.view(), b.nodes[i].called.view());
    expect_near(a.nodes[i].position.coefficients, b.nodes[i].position.coefficients, "r");
    expect_near(a.nodes[i].rotation, b.nodes[i].rotation, "psi");
  }
}

TEST(read_modes, equals_the_standard_input_data_of_the_same_body) {
  for (const bool bends : {false, true}) {
    const lumped::body b = body_of(bends);
    const read_body read = read_modes_text(file_of(b).dump());
    ASSERT_TRUE(read) << read.cause();
    EXPECT_THAT(read.notes, IsEmpty());
    expect_same(read.data, read_sid_text(lumped::sid_text(b, lumped::fembs)).data);
  }
}

TEST(read_modes, takes_geometric_stiffness_instead_of_bends) {
  const lumped::body b = body_of(true);
  json file = file_of(b), bent = file;
  file.erase("bends"), file.erase("attachments"), bent.erase("attachments");
  const auto matrix_of = [&](const auto& entry) {
    json rows = json::array();
    for (int k = 0; k < 2; ++k) rows.push_back({entry(k, 0), entry(k, 1)});
    return rows;
  };
  for (int i = 0; i < 3; ++i) {
    file["acceleration"].push_back(matrix_of([&](int k, int l) {
      return b.integral<Vector3d>([&](const lumped::particle& p) { return p.bend_of(k, l); })[i];
    }));
    file["angular_acceleration"].push_back(matrix_of([&](int k, int l) {
      return b.integral<Vector3d>(
          [&](const lumped::particle& p) -> Vector3d { return p.place.cross(p.bend_of(k, l)); })[i];
    }));
  }
  for (int e = 0; e < 6; ++e)
    file["rotation"].push_back(matrix_of([&](int k, int l) {
      return b.integral<lumped::six_numbers>(
          [&](const lumped::particle& p) { return lumped::centrifugal_form(p.bend_of(k, l), p.place); })[e];
    }));
  const read_body read = read_modes_text(file.dump());
  ASSERT_TRUE(read) << read.cause();
  expect_same(read.data, read_modes_text(bent.dump()).data);
}

TEST(read_modes, takes_a_mass_matrix_frequencies_and_ratios) {
  json file = file_of(body_of(false)), other = file;
  for (const char* key : {"masses", "stiffness", "damping"}) other.erase(key);
  for (std::size_t i = 0; i < 5; ++i) other["mass_matrix"].push_back({i, i, file["masses"][i]});
  other["frequencies"] = {3.0, 5.0};
  other["ratios"] = {0.02, 0.01};
  const read_body read = read_modes_text(other.dump());
  ASSERT_TRUE(read) << read.cause();
  const mechanics::flexible_data &a = read.data, &b = read_modes_text(file.dump()).data;
  expect_near(a.inertia.coefficients, b.inertia.coefficients, "J");
  const double rate = 2 * std::numbers::pi * 5;
  EXPECT_NEAR(a.stiffness[3], rate * rate * a.modal_mass[3], 1e-10);
  EXPECT_EQ(a.stiffness[1], 0);
  EXPECT_NEAR(a.damping[3], 2 * 0.01 * rate * a.modal_mass[3], 1e-12);
}

/// Two nodes of a consistent mass matrix: ∫ x² dm of a rod with linear shapes.
TEST(read_modes, uses_the_coupling_of_nodes) {
  const json file = {{"positions", {{0, 0, 0}, {3, 0, 0}}},
                     {"mass_matrix", {{0, 0, 2}, {0, 1, 1}, {1, 0, 1}, {1, 1, 2}}},
                     {"shapes", {{{0, 0, 0}, {0, 1, 0}}}},
                     {"stiffness", {7}}};
  const mechanics::flexible_data d = read_modes_text(file.dump()).data;
  EXPECT_EQ(d.mass, 6);
  EXPECT_EQ(d.first_moment.constant(0), 9);   // m L / 2
  EXPECT_EQ(d.inertia.constant(2), 18);       // m L² / 3
  EXPECT_EQ(d.modal_mass[0], 2);              // m / 3
  EXPECT_EQ(d.angular.constant(2), 6);        // m L / 3
  EXPECT_EQ(d.first_moment.linear(0, 1), 3);  // m / 2
  EXPECT_EQ(d.inertia.quadratic(0, 0, 2), 4); // 2 m / 3
}

TEST(read_modes, reports_mistakes) {
  const json valid = file_of(body_of(false));
  const auto with = [&](const char* key, const json& value) {
    json file = valid;
    file[key] = value;
    return file.dump();
  };
  const auto without = [&](const char* key) {
    json file = valid;
    file.erase(key);
    return file.dump();
  };
  const auto with_inertia = [&](const json& second) {
    return with("inertias", {{1, 2, 2}, second, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}});
  };
  json without_rotations = json::parse(with_inertia({1, 1, 1}));
  without_rotations.erase("rotations");
  json short_shape = valid, infinite = valid, lopsided = valid;
  short_shape["shapes"][1].erase(0);
  lopsided["stiffness"][0][1] = 3;
  const std::pair<std::string, std::string> mistakes[]{
      {"", "line 1 of a.json: this is not valid JSON"},
      {"{\n\"positions\": [1,\n}", "line 3 of a.json: this is not valid JSON"},
      {"[]", "a.json: expected an object with the keys positions, masses and shapes"},
      {without("shapes"), "a.json: the file does not contain shapes"},
      {without("masses"), "a.json: the file must contain either masses or mass_matrix"},
      {with("frequencies", {1, 2}), "a.json: the file must contain either stiffness or frequencies"},
      {with("positions", 3), "a.json: positions is not a list of points"},
      {with("masses", {1, 2}), "a.json: masses has 2 entries; expected 5"},
      {with("masses", {1, 2, 3, "a", 4}), "a.json: masses[3] is not a number"},
      {with("masses", {1, 2, 3, -4, 4}), "a.json: masses[3] is negative"},
      {with("masses", {0, 0, 0, 0, 0}), "a.json: the body has no mass"},
      {short_shape.dump(), "a.json: shapes[1] has 4 entries; expected 5"},
      {lopsided.dump(), "a.json: stiffness[1][0] is not equal to stiffness[0][1]"},
      {with("inertias", {1, 2}), "a.json: inertias has 2 entries; expected 5"},
      {with_inertia({1, 2}), "a.json: inertias[1] has 2 entries; expected 3"},
      {with_inertia({1, -2, 3}), "a.json: inertias[1] has a negative moment of inertia about some axis"},
      {with_inertia({{1, 2, 0}, {2, 1, 0}, {0, 0, 1}}),
       "a.json: inertias[1] has a negative moment of inertia about some axis"},
      {with_inertia({{1, 2, 0}, {0, 1, 0}, {0, 0, 1}}),
       "a.json: inertias[1][0][1] is not equal to inertias[1][1][0]"},
      {with_inertia({{1, 0, 0}, {0, "x", 0}, {0, 0, 1}}), "a.json: inertias[1][1][1] is not a number"},
      {without_rotations.dump(),
       "a.json: the file contains inertias, but no rotations, by which the nodes turn"},
      {with("rotation_bends", {1, 2}), "a.json: rotation_bends[0] is not a list"},
      {with("modal_mass", {1, 1}),
       "a.json: modal_mass[1][1] is 1, but the masses and the shapes give 6.95271, a difference of 85.6 % of "
       "the largest entry; prefer_derived accepts such files"},
      {with("attachments", {12, 12}), "a.json: node 12 is listed twice among the attachments"},
      {with("attachments", {13}), "a.json: attachments[0] is 13, which is not the name of a node"},
      {with("nodes", {1, 2, 3, 3, 5}), "a.json: two nodes are called 3"},
      {with("ratios", {0.1, 0.1}), "a.json: the file contains both damping and ratios"},
      {with("stiffness", {1e308, 1e308}), ""},
      {with("positions", {{1e200, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}),
       "a.json: the integrals of the body overflow"},
  };
  for (const auto& [text, expected] : mistakes)
    EXPECT_EQ(read_modes_text(text, {}, "a.json").cause(), expected);
  EXPECT_THAT(read_modes_text(with("color", "red")).notes,
              ElementsAre("the key color is unknown and ignored"));
  EXPECT_TRUE(read_modes_text(with("modal_mass", {1, 1}), {.prefer_derived = true}));
}

/// Texts with changed, omitted and repeated bytes.
TEST(read_modes, survives_broken_files) {
  const std::string whole = file_of(body_of(true)).dump();
  std::mt19937 random(2026);
  const auto any = [&](std::size_t below) { return static_cast<std::size_t>(random()) % below; };
  for (int i = 0; i < 1000; ++i) {
    std::string text = whole;
    for (std::size_t changes = 1 + any(3); changes > 0 && !text.empty(); --changes) {
      const std::size_t at = any(text.size()), length = 1 + any(40);
      switch (any(6)) {
      case 0: text[at] = static_cast<char>(any(256)); break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(any(text.size()), text.substr(at, length)); break;
      case 3: text.resize(at); break;
      case 4: text.insert(at, any(2) == 0 ? "1e400" : std::string(5000, '[')); break;
      default: text[at] = "0123456789-.e,[]{}:\""[any(20)];
      }
    }
    const read_body read = read_modes_text(text, {}, "a.json");
    EXPECT_LT(read.cause().size(), 500u);
    EXPECT_TRUE(read || read.data.amplitudes == 0);
  }
}

} // namespace
