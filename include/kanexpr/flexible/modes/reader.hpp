#pragma once

#include <kanexpr/flexible/file_report.hpp>
#include <kanexpr/flexible/limits.hpp>
#include <kanexpr/flexible/modes/modal_model.hpp>
#include <kanexpr/numeric/powers_of_two.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace kanexpr::flexible::modes {

namespace detail {

/// Finds the position of the first syntax error.
struct error_finder : nlohmann::json_sax<nlohmann::json> {
  std::size_t position = 0;

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return true; }
  bool key(string_t&) override { return true; }
  bool end_object() override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool parse_error(std::size_t at, const std::string&, const nlohmann::detail::exception&) override {
    position = at;
    return false;
  }
};

} // namespace detail

/// Reads the modes of a finite-element model from JSON. The keys and their meaning are those of
/// `modal_model`.
class reader {
public:
  modal_model model{};
  std::vector<double> frequencies{}; ///< in Hz; empty if the stiffness is given
  std::vector<double> ratios{};      ///< the damping ratio of each amplitude; empty if not given

  explicit reader(file_report& report) : report_(report) {}

  /// Whether the text describes a body; otherwise, the report contains the first mistake.
  bool read(const std::string& text) {
    all_ = json::parse(text, nullptr, false);
    if (all_.is_discarded()) return fail_by_syntax(text);
    if (!all_.is_object())
      return report_.fail("expected an object with the keys positions, masses and shapes");
    return check_keys() && read_positions() && read_shapes() && read_masses() && read_inertias() &&
           read_matrices() && read_names() && read_attachments();
  }

private:
  using json = nlohmann::json;
  using vectors = modal_model::vectors;
  static constexpr std::array<std::string_view, 19> keys{"positions",
                                                         "masses",
                                                         "mass_matrix",
                                                         "inertias",
                                                         "shapes",
                                                         "rotations",
                                                         "bends",
                                                         "rotation_bends",
                                                         "nodes",
                                                         "attachments",
                                                         "modal_mass",
                                                         "stiffness",
                                                         "frequencies",
                                                         "damping",
                                                         "ratios",
                                                         "acceleration",
                                                         "angular_acceleration",
                                                         "rotation",
                                                         "comment"};

  bool fail_by_syntax(const std::string& text) {
    detail::error_finder finder;
    json::sax_parse(text, &finder);
    const std::size_t end = (std::min)(finder.position, text.size());
    const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
    return report_.fail(static_cast<int>(line) + 1, "this is not valid JSON");
  }

  bool has(const char* key) const { return all_.contains(key); }
  static std::string index(const std::string& of, std::size_t i) {
    return of + "[" + std::to_string(i) + "]";
  }
  static std::string counted_entries(std::size_t n) {
    return std::to_string(n) + (n == 1 ? " entry" : " entries");
  }

  bool check_keys() {
    for (const auto& item : all_.items())
      if (std::ranges::find(keys, item.key()) == keys.end())
        report_.note("the key " + printable(item.key()) + " is unknown and ignored");
    for (const char* key : {"positions", "shapes"})
      if (!has(key)) return report_.fail(std::string("the file does not contain ") + key);
    if (has("masses") == has("mass_matrix"))
      return report_.fail("the file must contain either masses or mass_matrix");
    return has("stiffness") != has("frequencies") ||
           report_.fail("the file must contain either stiffness or frequencies");
  }

  bool read_number(const json& from, double& into, const std::string& what) {
    if (!from.is_number()) return report_.fail(what + " is not a number");
    into = from.get<double>();
    return numeric::is_finite(into) || report_.fail(what + " is not finite");
  }
  /// Reads a list of `size` numbers.
  bool read_list(const json& from, std::size_t size, std::vector<double>& into, const std::string& what) {
    if (!has_size(from, size, what)) return false;
    for (std::size_t i = 0; i < size; ++i) {
      into.push_back(0);
      if (!read_number(from[i], into.back(), index(what, i))) return false;
    }
    return true;
  }
  bool has_size(const json& from, std::size_t size, const std::string& what) {
    if (!from.is_array()) return report_.fail(what + " is not a list");
    return from.size() == size ||
           report_.fail(what + " has " + counted_entries(from.size()) + "; expected " + std::to_string(size));
  }

  std::size_t nodes() const { return model.positions.size() / 3; }

  /// Reads a list with three components for each node.
  bool read_vectors(const json& from, std::size_t size, vectors& into, const std::string& what) {
    if (!has_size(from, size, what)) return false;
    for (std::size_t i = 0; i < size; ++i)
      if (!read_list(from[i], 3, into, index(what, i))) return false;
    return true;
  }

  bool read_positions() {
    const json& list = all_["positions"];
    if (!list.is_array() || list.empty()) return report_.fail("positions is not a list of points");
    return read_vectors(list, list.size(), model.positions, "positions");
  }

  bool read_shapes() {
    const json& list = all_["shapes"];
    if (!list.is_array() || list.empty()) return report_.fail("shapes is not a list of shapes");
    if (list.size() > most_amplitudes)
      return report_.fail("the body has " + std::to_string(list.size()) + " shapes" + "; at most " +
                          std::to_string(most_amplitudes) + " are supported");
    model.amplitudes = static_cast<int>(list.size());
    if (!read_by_amplitude("shapes", model.shapes) || !read_by_amplitude("rotations", model.rotations))
      return false;
    if (has("rotation_bends") && !has("rotations"))
      return report_.fail("the file contains rotation_bends, but no rotations");
    return read_by_pair("bends", model.bends) && read_by_pair("rotation_bends", model.rotation_bends);
  }
  bool read_by_amplitude(const char* key, std::vector<vectors>& into) {
    if (!has(key)) return true;
    const json& list = all_[key];
    if (!has_size(list, model.count(), key)) return false;
    for (std::size_t k = 0; k < model.count(); ++k)
      if (!read_vectors(list[k], nodes(), into.emplace_back(), index(key, k))) return false;
    return true;
  }
  /// Reads vectors for each pair of amplitudes and each node, which are equal if the amplitudes are
  /// exchanged.
  bool read_by_pair(const char* key, std::vector<vectors>& into) {
    if (!has(key)) return true;
    const json& rows = all_[key];
    if (!has_size(rows, model.count(), key)) return false;
    for (std::size_t k = 0; k < model.count(); ++k) {
      if (!has_size(rows[k], model.count(), index(key, k))) return false;
      for (std::size_t l = 0; l < model.count(); ++l)
        if (!read_vectors(rows[k][l], nodes(), into.emplace_back(), index(index(key, k), l))) return false;
    }
    for (std::size_t k = 0; k < model.count(); ++k)
      for (std::size_t l = 0; l < k; ++l)
        if (into[k * model.count() + l] != into[l * model.count() + k])
          return report_.fail(index(index(key, k), l) + " is not equal to " + index(index(key, l), k));
    return true;
  }

  bool read_masses() {
    if (has("mass_matrix")) return read_mass_matrix();
    std::vector<double> masses;
    if (!read_list(all_["masses"], nodes(), masses, "masses")) return false;
    for (std::size_t i = 0; i < masses.size(); ++i) {
      if (masses[i] < 0) return report_.fail(index("masses", i) + " is negative");
      if (masses[i] > 0) model.masses.push_back({i, i, masses[i]});
    }
    return !model.masses.empty() || report_.fail("the body has no mass");
  }
  /// The entries of the mass matrix that are not zero, as triples of row, column and mass.
  bool read_mass_matrix() {
    const json& list = all_["mass_matrix"];
    if (!list.is_array()) return report_.fail("mass_matrix is not a list of [row, column, mass]");
    std::map<std::pair<std::size_t, std::size_t>, double> opposite;
    for (std::size_t i = 0; i < list.size(); ++i) {
      std::vector<double> written;
      const std::string what = index("mass_matrix", i);
      if (!read_list(list[i], 3, written, what)) return false;
      const auto is_node = [&](double x) {
        return x >= 0 && x < static_cast<double>(nodes()) && std::floor(x) >= x;
      };
      if (!is_node(written[0]) || !is_node(written[1]))
        return report_.fail(what + " begins with " + list[i][0].dump() + ", " + list[i][1].dump() +
                            "; expected two indices of nodes, from 0 to " + std::to_string(nodes() - 1));
      const auto row = static_cast<std::size_t>(written[0]), column = static_cast<std::size_t>(written[1]);
      model.masses.push_back({row, column, written[2]});
      opposite[{row, column}] += written[2], opposite[{column, row}] -= written[2];
    }
    double largest = 0;
    for (const modal_model::mass_entry& e : model.masses) largest = (std::max)(largest, std::abs(e.mass));
    for (const auto& [place, difference] : opposite)
      if (std::abs(difference) > 1e-6 * largest)
        return report_.fail("mass_matrix is not symmetric in row " + std::to_string(place.first) +
                            " and column " + std::to_string(place.second));
    return true;
  }

  /// Reads the rotary inertias of the nodes, each as a matrix or as its diagonal.
  bool read_inertias() {
    if (!has("inertias")) return true;
    if (!has("rotations"))
      return report_.fail("the file contains inertias, but no rotations, by which the nodes turn");
    if (!has_size(all_["inertias"], nodes(), "inertias")) return false;
    for (std::size_t i = 0; i < nodes(); ++i)
      if (!read_inertia(all_["inertias"][i], index("inertias", i))) return false;
    return true;
  }
  bool read_inertia(const json& from, const std::string& what) {
    if (!has_size(from, 3, what)) return false;
    modal_model::tensor& into = model.inertias.emplace_back();
    double largest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      std::vector<double> row(3, 0.0);
      if (from[i].is_number()) {
        if (!read_number(from[i], row[i], index(what, i))) return false;
      } else {
        row.clear();
        if (!read_list(from[i], 3, row, index(what, i))) return false;
      }
      std::ranges::copy(row, into[i].begin());
      for (const double each : row) largest = (std::max)(largest, std::abs(each));
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3;
      if (std::abs(into[i][j] - into[j][i]) > 1e-6 * largest)
        return report_.fail(index(index(what, i), j) + " is not equal to " + index(index(what, j), i));
      into[i][j] = into[j][i] = (into[i][j] + into[j][i]) / 2;
    }
    return has_no_negative_moment(into, largest) ||
           report_.fail(what + " has a negative moment of inertia about some axis");
  }
  /// Whether a symmetric matrix is positive semidefinite, except for rounding.
  static bool has_no_negative_moment(const modal_model::tensor& m, double largest) {
    double determinant = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      const double rounding = 1e-6 * largest;
      if (m[i][i] < -rounding || m[i][i] * m[j][j] - m[i][j] * m[i][j] < -rounding * largest) return false;
      determinant += m[0][i] * (m[1][j] * m[2][k] - m[1][k] * m[2][j]);
    }
    return determinant >= -1e-6 * largest * largest * largest;
  }

  /// Reads a symmetric matrix of the amplitudes, or its diagonal.
  bool read_matrix(const json& from, modal_model::matrix& into, const std::string& what) {
    const std::size_t n = model.count();
    if (!has_size(from, n, what)) return false;
    into.assign(n * n, 0);
    for (std::size_t k = 0; k < n; ++k) {
      if (from[k].is_number()) {
        if (!read_number(from[k], into[k * n + k], index(what, k))) return false;
        continue;
      }
      std::vector<double> row;
      if (!read_list(from[k], n, row, index(what, k))) return false;
      std::ranges::copy(row, into.begin() + static_cast<std::ptrdiff_t>(k * n));
    }
    return make_symmetric(into, what);
  }
  bool make_symmetric(modal_model::matrix& m, const std::string& what) {
    const std::size_t n = model.count();
    double largest = 0;
    for (double each : m) largest = (std::max)(largest, std::abs(each));
    for (std::size_t k = 0; k < n; ++k)
      for (std::size_t l = 0; l < k; ++l) {
        double &one = m[k * n + l], &other = m[l * n + k];
        if (std::abs(one - other) > 1e-6 * largest)
          return report_.fail(index(index(what, k), l) + " is not equal to " + index(index(what, l), k));
        one = other = (one + other) / 2;
      }
    return true;
  }
  bool read_matrices_of(const char* key, std::size_t count, std::vector<modal_model::matrix>& into) {
    if (!has(key)) return true;
    if (!has_size(all_[key], count, key)) return false;
    for (std::size_t i = 0; i < count; ++i)
      if (!read_matrix(all_[key][i], into.emplace_back(), index(key, i))) return false;
    return true;
  }

  bool read_matrices() {
    if (has("modal_mass") && !read_matrix(all_["modal_mass"], model.modal_mass, "modal_mass")) return false;
    if (has("stiffness") && !read_matrix(all_["stiffness"], model.stiffness, "stiffness")) return false;
    if (has("damping") && has("ratios")) return report_.fail("the file contains both damping and ratios");
    if (has("damping") && !read_matrix(all_["damping"], model.damping, "damping")) return false;
    if (has("frequencies") && !read_list(all_["frequencies"], model.count(), frequencies, "frequencies"))
      return false;
    if (has("ratios") && !read_list(all_["ratios"], model.count(), ratios, "ratios")) return false;
    for (const std::vector<double>* list : {&frequencies, &ratios})
      for (std::size_t k = 0; k < list->size(); ++k)
        if ((*list)[k] < 0)
          return report_.fail(index(list == &ratios ? "ratios" : "frequencies", k) + " is negative");
    for (std::size_t k = 0; k < ratios.size() && !model.stiffness.empty(); ++k)
      if (model.stiffness[k * (model.count() + 1)] < 0)
        return report_.fail(index(index("stiffness", k), k) + " is negative, so it allows no damping ratio");
    return read_matrices_of("acceleration", 3, model.by_acceleration) &&
           read_matrices_of("angular_acceleration", 3, model.by_angular_acceleration) &&
           read_matrices_of("rotation", 6, model.by_rotation);
  }

  /// Reads the names of nodes, which are texts or integers; by default, they are the indices.
  bool read_names() {
    if (!has("nodes")) {
      for (std::size_t i = 0; i < nodes(); ++i) places_.emplace(std::to_string(i), i);
      return true;
    }
    const json& list = all_["nodes"];
    if (!has_size(list, nodes(), "nodes")) return false;
    for (std::size_t i = 0; i < nodes(); ++i) {
      std::string called;
      if (!read_name(list[i], called, index("nodes", i))) return false;
      if (!places_.emplace(called, i).second)
        return report_.fail("two nodes are called " + printable(called));
    }
    return true;
  }
  bool read_name(const json& from, std::string& into, const std::string& what) {
    if (!from.is_string() && !from.is_number_integer())
      return report_.fail(what + " is neither a text nor an integer");
    into = from.is_string() ? from.get<std::string>() : from.dump();
    return true;
  }

  bool read_attachments() {
    if (!has("attachments")) return true;
    const json& list = all_["attachments"];
    if (!list.is_array()) return report_.fail("attachments is not a list of nodes");
    if (list.size() > most_nodes(model.amplitudes))
      return report_.fail("attachments has " + counted_entries(list.size()) + "; at most " +
                          std::to_string(most_nodes(model.amplitudes)) + " are supported");
    for (std::size_t i = 0; i < list.size(); ++i) {
      modal_model::attachment& a = model.attachments.emplace_back();
      if (!read_name(list[i], a.called, index("attachments", i))) return false;
      const auto found = places_.find(a.called);
      if (found == places_.end())
        return report_.fail(index("attachments", i) + " is " + printable(a.called) +
                            ", which is not the name of a node");
      a.node = found->second;
      for (std::size_t j = 0; j < i; ++j)
        if (model.attachments[j].called == a.called)
          return report_.fail("node " + printable(a.called) + " is listed twice among the attachments");
    }
    return true;
  }

  file_report& report_;
  json all_{};
  std::map<std::string, std::size_t> places_{};
};

} // namespace kanexpr::flexible::modes
