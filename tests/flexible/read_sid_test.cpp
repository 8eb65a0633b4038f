// builds: clang++ sanitize all
// Flexible bodies from files with standard input data, and the sentences that report invalid files.
#include "flexible/lumped_body.hpp"
#include "flexible/sid_writer.hpp"

#include <kanexpr/flexible/read_sid.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <utility>

namespace {

using namespace kanexpr;
using namespace kanexpr::flexible;
using lumped::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Compares the data with integrals at r(q), which are exact for bodies that do not bend.
void expect_integrals(const mechanics::flexible_data& d, const lumped::body& b, double tolerance) {
  const int n = b.amplitudes;
  ASSERT_EQ(d.amplitudes, n);
  EXPECT_NEAR(d.mass, b.mass(), tolerance);
  const auto near_vector = [&](auto entry, const Vector3d& expected, const std::string& what) {
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(entry(i), expected[i], tolerance) << what << i;
  };
  static constexpr int rows[6]{0, 1, 2, 0, 1, 2}, columns[6]{0, 1, 2, 1, 2, 0};
  const auto near_inertia = [&](auto entry, const Eigen::Matrix3d& expected, const std::string& what) {
    for (int e = 0; e < 6; ++e) EXPECT_NEAR(entry(e), expected(rows[e], columns[e]), tolerance) << what << e;
  };
  using lumped::inertia_form;
  using lumped::particle;
  near_inertia([&](int e) { return d.inertia.constant(e); },
               b.integral<Eigen::Matrix3d>(
                   [](const particle& p) -> Eigen::Matrix3d { return inertia_form(p.place, p.place); }),
               "J");
  for (int k = 0; k < n; ++k) {
    near_vector([&](int i) { return d.first_moment.linear(k, i); },
                b.integral<Vector3d>([&](const particle& p) -> Vector3d { return p.shape_of(k); }), "Ct");
    near_inertia([&](int e) { return d.inertia.linear(k, e); },
                 b.integral<Eigen::Matrix3d>([&](const particle& p) -> Eigen::Matrix3d {
                   return 2 * inertia_form(p.place, p.shape_of(k));
                 }),
                 "J1");
    near_vector(
        [&](int i) { return d.angular.constant(3 * k + i); },
        b.integral<Vector3d>([&](const particle& p) -> Vector3d { return p.place.cross(p.shape_of(k)); }),
        "Cr");
    for (int l = 0; l < n; ++l) {
      near_vector([&](int i) { return d.first_moment.quadratic(k, l, i); },
                  b.integral<Vector3d>([&](const particle& p) -> Vector3d { return p.bend_of(k, l); }),
                  "Ct1");
      near_inertia([&](int e) { return d.inertia.quadratic(k, l, e); },
                   b.integral<Eigen::Matrix3d>([&](const particle& p) -> Eigen::Matrix3d {
                     return 2 * inertia_form(p.shape_of(k), p.shape_of(l)) +
                            2 * inertia_form(p.place, p.bend_of(k, l));
                   }),
                   "J2");
      near_vector([&](int i) { return d.angular.linear(l, 3 * k + i); },
                  b.integral<Vector3d>([&](const particle& p) -> Vector3d {
                    return p.shape_of(l).cross(p.shape_of(k)) + p.place.cross(p.bend_of(k, l));
                  }),
                  "Cr1");
      EXPECT_NEAR(d.stiffness[k * n + l], b.stiffness(k, l), tolerance);
      EXPECT_NEAR(d.damping[k * n + l], b.damping(k, l), tolerance);
    }
  }
}

TEST(read_sid, reads_the_notations_of_different_programs) {
  lumped::notation by_axis = lumped::fembs;
  by_axis.ge_by_axis = true;
  for (const lumped::notation& how : {lumped::fembs, lumped::matlab, by_axis})
    for (const int amplitudes : {1, 2, 3, 4})
      for (const bool bends : {false, true}) {
        const lumped::body b = lumped::random_body(amplitudes, 5, bends, 11);
        const read_body read = read_sid_text(lumped::sid_text(b, how));
        ASSERT_TRUE(read) << read.cause();
        EXPECT_THAT(read.notes, IsEmpty());
        expect_integrals(read.data, b, 1e-12 * 100);
        ASSERT_EQ(read.data.nodes.size(), 1);
        const mechanics::flexible_node& node = read.data.nodes[0];
        EXPECT_EQ(node.called.view(), "12");
        for (int k = 0; k < amplitudes; ++k)
          for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(node.position.linear(k, i), b.particles.back().shape_of(k)[i], 1e-15);
            EXPECT_NEAR(node.position.quadratic(k, 0, i), b.particles.back().bend_of(k, 0)[i], 1e-15);
            EXPECT_NEAR(node.rotation[3 * k + i], b.turns[static_cast<std::size_t>(k)][i], 1e-15);
          }
      }
}

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const std::size_t at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return at == text.npos ? text : text.replace(at, what.size(), by);
}

/// The text without a section.
std::string without(const std::string& text, const std::string& section) {
  const std::size_t from = text.find("     " + section + "\n"), end = text.find("end " + section + "\n");
  return text.substr(0, from) + text.substr(end + section.size() + 5);
}

const std::string& valid_text() {
  static const std::string text = lumped::sid_text(lumped::random_body(2, 4, true, 5), lumped::fembs);
  return text;
}

TEST(read_sid, completes_matrices_that_others_determine) {
  const mechanics::flexible_data whole = read_sid_text(valid_text()).data;
  ASSERT_EQ(whole.amplitudes, 2);
  for (const char* section : {"Gr", "Ge", "ksigma", "De"})
    EXPECT_TRUE(read_sid_text(without(valid_text(), section))) << section;
  std::string text = valid_text();
  const std::size_t j = text.find("     J\n"), end = text.find("end J");
  for (std::size_t at = text.find("m1(", j); at < text.find("end J"); at = text.find("m1(", j))
    text.erase(at, text.find('\n', at) - at);
  ASSERT_NE(end, text.find("end J"));
  const read_body read = read_sid_text(text);
  ASSERT_TRUE(read) << read.cause();
  EXPECT_THAT(read.notes, ElementsAre(HasSubstr("J has no linear part; Oe provides it")));
  for (int e = 0; e < 6; ++e) EXPECT_NEAR(read.data.inertia.linear(1, e), whole.inertia.linear(1, e), 1e-13);
  EXPECT_THAT(read_sid_text(without(valid_text(), "Oe")).notes,
              ElementsAre("Oe has no linear part, so the inertia is only of first order in the amplitudes"));
}

/// A body with terms of higher order in all matrices that may contain them.
lumped::body body_of_second_order(int amplitudes) {
  lumped::body b = lumped::random_body(amplitudes, 5, true, 19);
  b.preload = lumped::random_tensor(amplitudes, 1, 1);
  b.third = lumped::random_tensor(amplitudes, 3, 2);
  b.fourth = lumped::random_tensor(amplitudes, 4, 3);
  b.damping_rate = lumped::random_tensor(amplitudes, 3, 4);
  b.second_damping_rate = lumped::random_tensor(amplitudes, 4, 5);
  for (int k = 0; k < amplitudes; ++k)
    for (int l = 0; l < amplitudes; ++l)
      b.turn_bends.emplace_back(0.1 + k + l, 0.2 * (k + 1) * (l + 1), -0.3 - k * l);
  return b;
}

/// Compares the terms of higher order with the derivatives of the energy and of the damping at some q.
void expect_elastic_terms(const mechanics::flexible_data& d, const lumped::body& b) {
  const int n = b.amplitudes;
  const auto q = [](int k) { return 0.7 - 0.4 * k; };
  double energy = 0, expected = 0, damping = 0, expected_damping = 0;
  for (const mechanics::elastic_term& t : d.elastic_terms) {
    double term = t.coefficient;
    for (const int k : t.amplitudes) term *= k < 0 ? 1 : q(k);
    energy += term;
  }
  for (const mechanics::damping_term& t : d.damping_terms) {
    double term = (t.row == t.column ? 1 : 2) * t.coefficient; // Σ D_kl
    for (const int k : t.amplitudes) term *= k < 0 ? 1 : q(k);
    damping += term;
  }
  for (int k = 0; k < n; ++k)
    for (int l = 0; l < n; ++l)
      for (int m = 0; m < n; ++m) {
        expected += b.entry(b.third, k, l, m) / 6 * q(k) * q(l) * q(m);
        expected_damping += b.entry(b.damping_rate, k, l, m) * q(m);
        for (int j = 0; j < n; ++j) {
          expected += b.entry(b.fourth, k, l, m, j) / 24 * q(k) * q(l) * q(m) * q(j);
          expected_damping += b.entry(b.second_damping_rate, k, l, m, j) / 2 * q(m) * q(j);
        }
      }
  EXPECT_NEAR(energy, expected, 1e-13);
  EXPECT_NEAR(damping, expected_damping, 1e-13);
}

TEST(read_sid, reads_terms_of_second_order) {
  for (lumped::notation how : {lumped::fembs, lumped::matlab})
    for (const int amplitudes : {1, 2, 3}) {
      how.second_order = true;
      const lumped::body b = body_of_second_order(amplitudes);
      const read_body read = read_sid_text(lumped::sid_text(b, how));
      ASSERT_TRUE(read) << read.cause();
      EXPECT_THAT(read.notes, IsEmpty());
      expect_integrals(read.data, b, 1e-10);
      expect_elastic_terms(read.data, b);
      const base::sequence<double>& turns = read.data.nodes[0].second_rotation;
      ASSERT_EQ(turns.size(), 3 * amplitudes * amplitudes);
      for (int k = 0; k < amplitudes; ++k) {
        EXPECT_NEAR(read.data.preload[k], b.preload[static_cast<std::size_t>(k)], 1e-15);
        for (int l = 0; l < amplitudes; ++l)
          for (int i = 0; i < 3; ++i)
            EXPECT_NEAR(turns[3 * (k * amplitudes + l) + i], b.turn_bend_of(k, l)[i], 1e-14);
      }
    }
}

/// The text without the entries m1 or m2 of a section.
std::string without_entries(std::string text, const std::string& section, const std::string& entry) {
  const std::size_t begin = text.find("     " + section + "\n");
  const auto end = [&] { return text.find("end " + section, begin); };
  for (std::size_t at = text.find(entry, begin); at < end(); at = text.find(entry, begin))
    text.erase(at, text.find('\n', at) - at);
  return text;
}

TEST(read_sid, takes_terms_of_second_order_from_the_matrices_that_contain_them) {
  lumped::notation how = lumped::fembs;
  how.second_order = true;
  const lumped::body b = body_of_second_order(2);
  const std::string text = lumped::sid_text(b, how);
  const auto near = [](const base::sequence<double>& found, const base::sequence<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (int i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-13);
  };
  const mechanics::flexible_data whole = read_sid_text(text).data;
  const auto after = [&](const char* section, const std::string& note) {
    const read_body read = read_sid_text(without_entries(text, section, "m1("));
    EXPECT_TRUE(read) << read.cause();
    EXPECT_THAT(read.notes, note.empty() ? testing::Matcher<std::vector<std::string>>(IsEmpty())
                                         : ElementsAre(HasSubstr(note)));
    return read.data;
  };
  near(after("Ct", "Ct has no linear part; mdCM provides it").first_moment.coefficients,
       whole.first_moment.coefficients);
  near(after("Oe", "Oe has no linear part; J provides it").inertia.coefficients, whole.inertia.coefficients);
  near(after("phi", "").nodes[0].position.coefficients, whole.nodes[0].position.coefficients);
  near(after("psi", "").nodes[0].second_rotation, whole.nodes[0].second_rotation);
}

TEST(read_sid, reports_terms_that_have_no_effect_or_disagree) {
  lumped::notation how = lumped::fembs;
  how.second_order = true;
  std::string text = lumped::sid_text(body_of_second_order(2), how);
  const auto with = [&](const std::string& section, const std::string& entry) {
    return replaced(text, "end " + section + "\n", entry + " = 7.5\n end " + section + "\n");
  };
  const auto message = [&](const std::string& section, const std::string& entry) {
    const std::string cause = read_sid_text(with(section, entry), {}, "a.sid").cause();
    return cause.substr(cause.find(": ") + 2);
  };
  for (const std::string section : {"Ct", "Cr", "Me", "Gr", "Ge", "Oe"})
    EXPECT_EQ(message(section, "m2(1, 1, 1, 1)"),
              section +
                  " has terms of second order in the amplitudes, which are of third or higher order in "
                  "the kinetic energy; the equations follow from this energy to the second order in the "
                  "amplitudes and their rates");
  for (const std::string section : {"phi", "psi"})
    EXPECT_EQ(message(section, "m2(1, 1, 1, 1)"),
              section + " of node 12 has terms of second order in the amplitudes; the place of a node is "
                        "described to the second order, for which the first order of phi and psi suffices");
  EXPECT_EQ(
      message("Ke", "mn(1, 1, 1)"),
      "mn of Ke counts products of amplitudes in an order that standard input data do not define; write "
      "m2 with the indices of both amplitudes");
  const std::string tail = "; prefer_derived accepts such files";
  const auto disagreement = [&](const std::string& section, const std::string& entry) {
    const std::string found = message(section, entry);
    EXPECT_TRUE(found.ends_with(tail)) << found;
    return found.substr(0, found.find(", a difference"));
  };
  EXPECT_EQ(disagreement("mdCM", "m2(1, 1, 1, 1)"),
            "a second derivative of mdCM is 15, but Ct gives -0.813072");
  EXPECT_EQ(disagreement("J", "m2(1, 1, 1, 1)"), "a second derivative of J is 15, but Oe gives 13.4992");
  EXPECT_EQ(disagreement("Gr", "m1(1, 1, 1)"),
            "the coefficient of amplitude 1 in Gr(1, 1) is 7.5, but Oe and Cr give 13.4992");
  EXPECT_EQ(disagreement("origin", "m2(1, 1, 1, 1)"),
            "a second derivative of origin of node 12 is 15, but phi gives -0.67895");
  EXPECT_EQ(disagreement("AP", "m2(1, 1, 1, 1)"),
            "a second derivative of AP of node 12 is 15, but psi gives -0.929412");
  how.second_order = false;
  text = lumped::sid_text(body_of_second_order(2), how);
  EXPECT_EQ(disagreement("psi", "m1(1, 1, 2)"), "half of the difference of coefficients with exchanged "
                                                "amplitudes in psi of node 12 is 3.17809, but its "
                                                "constant part gives -0.0438102");
  EXPECT_EQ(disagreement("ksigma", "m1(1, 2, 1)"),
            "the coefficient of amplitude 2 in ksigma(1, 1) is 7.5, but the opposite entry is -2.39919");
  EXPECT_EQ(disagreement("Ke", "m1(1, 2, 1)"), "the coefficient of amplitudes 1 and 1 in the elastic force "
                                               "on amplitude 2 is 0.431541, but a potential "
                                               "energy gives 2.84523");
  EXPECT_EQ(disagreement("Ke", "m2(1, 1, 2, 1)"),
            "a coefficient of second order in Ke is 0.113316, but a potential energy gives 1.98832");
  EXPECT_EQ(disagreement("De", "m1(1, 1, 2)"),
            "a coefficient of an amplitude in De is -0.654609, but the opposite entry has 7.5");
  for (const std::string section : {"Me", "Ge"})
    EXPECT_THAT(read_sid_text(with(section, "m1(1, 1, 1)")).notes,
                ElementsAre(HasSubstr("the linear part of " + section +
                                      " is ignored, because it is of third order in the kinetic energy")));
}

TEST(read_sid, reads_rounded_files) {
  lumped::notation how = lumped::matlab;
  how.digits = "%.6f";
  const lumped::body b = lumped::random_body(3, 5, false, 3);
  const read_body read = read_sid_text(lumped::sid_text(b, how));
  ASSERT_TRUE(read) << read.cause();
  expect_integrals(read.data, b, 1e-6);
  const base::sequence<double>& axes = read.data.nodes[0].orientation; // the rounding has been removed
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double product =
          axes[3 * i] * axes[3 * j] + axes[3 * i + 1] * axes[3 * j + 1] + axes[3 * i + 2] * axes[3 * j + 2];
      EXPECT_NEAR(product, i == j, 1e-15);
      EXPECT_NEAR(axes[3 * i + j], b.axes(i, j), 1e-6);
    }
}

TEST(read_sid, reports_the_place_of_a_mistake) {
  const std::string& text = valid_text();
  const std::pair<std::string, std::string> mistakes[]{
      {"", "a.sid: there is no line part, so the file has no standard input data"},
      {"part\n", "line 1 of a.sid: the file ends here; expected new modal"},
      {"part\nnew rigid\n", "line 2 of a.sid: expected new modal, got new rigid"},
      {replaced(text, "mass = ", "mass = heavy "),
       "line 5 of a.sid: the mass: expected a finite number, got \"heavy 4.1978959727442788D+00\""},
      {replaced(text, "mass = ", "mass = -"),
       "line 5 of a.sid: the mass is -4.1979; expected a positive number"},
      {replaced(text, "mass", "weight"),
       "line 5 of a.sid: expected mass, nelastq, ielastq or end refmod, got weight = 4.1978959727442788D+00"},
      {replaced(text, "nelastq = 2", "nelastq = two"),
       "line 6 of a.sid: the number of amplitudes nelastq: expected a count, got \"two\""},
      {replaced(text, "nelastq = 2", "nelastq = 4000000"),
       "line 6 of a.sid: the body has 4000000 amplitudes; at most 200 are supported"},
      {replaced(text, "nelastq = 2", "nelastq = 0"), "line 6 of a.sid: the body has no amplitudes"},
      {replaced(text, "nelastq = 2", "nelastq = 3"),
       "line 107 of a.sid: mdCM depends on 2 amplitudes; expected 3, the value of nelastq"},
      {without(text, "Cr"), "a.sid: the file does not contain Cr"},
      {text.substr(0, text.find("m0(")), "line 20 of a.sid: the file ends here; expected end origin"},
      {replaced(text, "order = 1", "order = 3"),
       "line 14 of a.sid: the order of origin is 3; expected 0, 1 or 2"},
      {replaced(text, "m0( 1, 1)", "m2( 1, 1, 1)"),
       "line 20 of a.sid: expected m2 with four indices of origin, "
       "counted from 1, got m2( 1, 1, 1) = 1.7722141359156560D+00"},
      {replaced(text, "m0( 1, 1)", "m2( 1, 1, 3, 1)"),
       "line 20 of a.sid: m2(1, 1, 3, 1) is outside of origin, "
       "which has 3 rows, 1 columns and 2 amplitudes"},
      {replaced(text, "structure = 3", "structure = 5"),
       "line 19 of a.sid: the structure of origin is 5; expected 0 to 4"},
      {replaced(text, "nrow = 3", "rows = 3"), "line 15 of a.sid: expected order, nrow, ncol, nq, nqn, "
                                               "structure, m0, m1, m2 or end origin, got rows = 3"},
      {replaced(text, "m0( 1, 1)", "m0( 1)"), "line 20 of a.sid: expected m0(row, column) of origin, counted "
                                              "from 1, got m0( 1) = 1.7722141359156560D+00"},
      {replaced(text, "m0( 1, 1)", "m0( 0, 1)"), "line 20 of a.sid: expected m0(row, column) of origin, "
                                                 "counted from 1, got m0( 0, 1) = 1.7722141359156560D+00"},
      {replaced(text, "m1( 1, 1, 1)", "m1( 4, 1, 1)"),
       "line 23 of a.sid: m1(4, 1, 1) is outside of origin, which has 3 rows, 1 columns and 2 amplitudes"},
      {replaced(text, "m1( 1, 1, 1) = ", "m1( 1, 1, 1) = NaN"),
       "line 23 of a.sid: m1( 1, 1, 1) of origin: expected a finite number, got "
       "\"NaN-3.9599607288283190D-01\""},
      {replaced(text, "end node", "end origin"),
       "line 105 of a.sid: expected origin, phi, psi, AP or end node, got end origin"},
      {replaced(text, "new node = 12", "new node ="),
       "line 11 of a.sid: expected the number or name of the node after new node =, got new node ="},
      {replaced(text, "end psi", "end psi\npsi"),
       "line 70 of a.sid: there is a second psi; the first one begins in line 56"},
      {replaced(text, "end frame", "new node = 12\nend node\nend frame"),
       "line 106 of a.sid: there is a second node 12"},
      {replaced(text, "end frame", "new node = 13\nend node\nend frame"),
       "line 106 of a.sid: node 13 has no origin"},
  };
  for (const auto& [broken, expected] : mistakes)
    EXPECT_EQ(read_sid_text(broken, {}, "a.sid").cause(), expected);
}

TEST(read_sid, limits_the_memory_that_a_file_demands) {
  std::string nodes = "end frame";
  for (int i = 0; i < 100; ++i) nodes.insert(0, "new node = n" + std::to_string(i) + "\nend node\n");
  const std::string text =
      replaced(replaced(valid_text(), "nelastq = 2", "nelastq = 200"), "end frame", nodes);
  EXPECT_EQ(read_sid_text(text, {}, "a.sid").cause(),
            "a.sid: the file has 101 nodes with 200 amplitudes; at most 82 are supported");
}

TEST(read_sid, compares_matrices_that_determine_each_other) {
  const std::string& text = valid_text();
  const auto changed = [&](const std::string& section, const std::string& entry) {
    const std::size_t begin = text.find("     " + section + "\n"), at = text.find(entry, begin);
    std::string broken = text;
    const std::size_t value = text.find("= ", at) + 2;
    return broken.replace(value, text.find('\n', value) - value, "7.5");
  };
  const std::pair<std::string, std::string> mistakes[]{
      {changed("Gr", "m0( 3, 1)"),
       "line 213 of a.sid: Gr(3, 1) is 7.5, but J and Cr give -1.35293, a difference of 98.4 % of the "
       "largest entry; prefer_derived accepts such files"},
      {changed("Ge", "m0( 1, 5)"), "line 239 of a.sid: Ge(1, 5) is 7.5, but Cr gives -2.24524, a difference "
                                   "of 130 % of the largest entry; prefer_derived accepts such files"},
      {changed("Oe", "m0( 2, 4)"), "line 253 of a.sid: Oe(2, 4) is 7.5, but J gives 2.40972, a difference of "
                                   "67.9 % of the largest entry; prefer_derived accepts such files"},
      {changed("Oe", "m1( 1, 2, 5)"),
       "line 253 of a.sid: the coefficient of amplitude 2 in Oe(1, 5) is 7.5, but the coefficient with "
       "exchanged amplitudes is -2.17218, a difference of 129 % of the largest entry; prefer_derived accepts "
       "such files"},
      {changed("Ct", "m1( 1, 2, 3)"),
       "line 150 of a.sid: the coefficient of amplitude 2 in Ct(1, 3) is 7.5, but the coefficient with "
       "exchanged amplitudes is -0.622089, a difference of 108 % of the largest entry; prefer_derived "
       "accepts such files"},
      {changed("mdCM", "m1( 3, 1, 1)"),
       "line 107 of a.sid: the coefficient of amplitude 1 in mdCM(3, 1) is 7.5, but Ct gives 1.45644, a "
       "difference of 80.6 % of the largest entry; prefer_derived accepts such files"},
      {changed("De", "m0( 1, 2)"),
       "line 316 of a.sid: De(1, 2) is 7.5, but the opposite entry is -0.273449, a difference of 104 % of "
       "the largest entry; prefer_derived accepts such files"},
      {changed("origin", "m1( 2, 1, 1)"),
       "line 13 of a.sid: the coefficient of amplitude 1 in origin(2, 1) of node 12 is 7.5, but phi gives "
       "-0.609738, a difference of 108 % of the largest entry; prefer_derived accepts such files"},
      {changed("AP", "m1( 1, 1, 2)"),
       "line 70 of a.sid: the coefficient of amplitude 1 in AP(1, 2) of node 12 is 7.5, but psi gives "
       "-0.95118, a difference of 113 % of the largest entry; prefer_derived accepts such files"},
      {changed("AP", "m0( 1, 1)"), "line 70 of a.sid: AP of node 12 is not a rotation matrix"},
  };
  for (const auto& [broken, expected] : mistakes) {
    EXPECT_EQ(read_sid_text(broken, {}, "a.sid").cause(), expected);
  }
}

/// Texts with changed, omitted and repeated bytes: every one is read or reported in one sentence.
TEST(read_sid, survives_broken_files) {
  std::mt19937 random(2026);
  const auto any = [&](std::size_t below) { return static_cast<std::size_t>(random()) % below; };
  int read_well = 0;
  for (int i = 0; i < 1500; ++i) {
    std::string text = valid_text();
    for (std::size_t changes = 1 + any(4); changes > 0 && !text.empty(); --changes) {
      const std::size_t at = any(text.size()), length = 1 + any(60);
      switch (any(6)) {
      case 0: text[at] = static_cast<char>(any(256)); break;
      case 1: text.erase(at, length); break;
      case 2: text.insert(any(text.size()), text.substr(at, length)); break;
      case 3: text.resize(at); break;
      case 4: text.insert(at, any(2) == 0 ? "999999999" : "1D+308"); break;
      default: text[at] = "0123456789-.D,()= \n"[any(19)];
      }
    }
    const read_body read = read_sid_text(text, {.prefer_derived = true}, "a.sid");
    read_well += read ? 1 : 0;
    EXPECT_LT(read.cause().size(), 500u);
    EXPECT_TRUE(read || read.data.amplitudes == 0);
  }
  EXPECT_GT(read_well, 20);
}

TEST(read_sid, reports_files_that_cannot_be_read) {
  EXPECT_EQ(read_sid("nowhere.SID_FEM").cause(), "nowhere.SID_FEM cannot be read");
}

} // namespace
