// kanexpr-robot: writes the model of a robot described by a URDF or SDF file as a header.
#include <kanexpr/robots/header_writer.hpp>
#include <kanexpr/robots/picture_writer.hpp>
#include <kanexpr/robots/read_urdf.hpp>
#include <kanexpr/robots/robot_builder.hpp>
#ifdef KANEXPR_ROBOTS_READ_SDF
#include <kanexpr/robots/read_sdf.hpp>
#endif
#include <kanexpr/runtime/explain.hpp>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace {

using namespace kanexpr::robots;
using kanexpr::symbolic::operation_weights;

struct request {
  std::string file{}, name{}, header{}, picture{}, base = "fixed", bind = "numbers";
  reading_options reading{};
  model_options model{};
  bool as_written = false, without_mimic = false, without_damping = false, quiet = false;
  bool explains = false, is_cheapest = false, without_search = false;
  std::vector<std::string> weights{};
};

read_robot robot_of(const std::string& file, const reading_options& options) {
  if (!file.ends_with(".sdf") && !file.ends_with(".world")) return read_urdf(file, options);
#ifdef KANEXPR_ROBOTS_READ_SDF
  return read_sdf(file, options);
#else
  return read_robot(file + " is an SDF file, but kanexpr-robot was compiled without libsdformat 12, which "
                           "reads such files; the Debian package is libsdformat-dev");
#endif
}

int refuse(const std::string& cause) {
  std::cerr << "kanexpr-robot: " << cause << '\n';
  return 1;
}

bool leave(const std::string& text, const std::string& file) {
  std::ofstream out(file, std::ios::binary);
  out << text;
  out.close();
  return out || refuse(file + " cannot be written") == 0;
}

bool draw(const robot& seen, const request& r) {
  const std::filesystem::path folder = std::filesystem::absolute(r.file).parent_path();
  picture_writer writer(seen, r.model, folder.string());
  const std::string text = writer.write(r.name);
  if (!r.quiet && !writer.note().empty()) std::cerr << "kanexpr-robot: note: " << writer.note() << '\n';
  return leave(text, r.picture);
}

/// Reads what operations cost from words such as "addition=12"; returns the mistake, empty if there is none.
/// A fused product costs as much as a product and a sum if no word states it.
std::string read_weights(const std::vector<std::string>& words, operation_weights& into) {
  constexpr int most = 1'000'000; // so that weighted counts remain exact
  into.fused = -1;
  std::vector<std::string> stated;
  for (const std::string& word : words) {
    const std::size_t sign = word.find('=');
    if (sign == word.npos) return "the weight '" + word + "' lacks a number, as in addition=12";
    const std::string called = word.substr(0, sign), number = word.substr(sign + 1);
    int operation_weights::* weight = nullptr;
    std::string known;
    for (const auto& each : kanexpr::symbolic::weighted_operations) {
      if (called == each.called) weight = each.weight;
      known.append(known.empty() ? "" : ", ").append(each.called);
    }
    if (weight == nullptr) return "there is no weight of '" + called + "'; weights are those of " + known;
    if (std::ranges::find(stated, called) != stated.end()) return called + " has two weights";
    stated.push_back(called);
    const char* const end = number.data() + number.size();
    const auto [rest, error] = std::from_chars(number.data(), end, into.*weight);
    if (error != std::errc{} || rest != end || into.*weight < 0 || into.*weight > most)
      return "the weight " + word + " is not an integer from 0 to " + std::to_string(most);
  }
  if (into.fused < 0) into.fused = into.multiplication + into.addition;
  return {};
}

/// The forms of the equations of a robot. A header has no names for the axes in which joints are mounted.
kanexpr::explanation forms_of(const robot& r, const request& wanted, const operation_weights& weights) {
  robot_builder built(r, wanted.model);
  if (const std::string cause = built.cause(); !cause.empty()) return {.mistake = cause};
  built.weighted_by(weights);
  kanexpr::explain_options how;
  how.may_use = [](std::string_view frame) { return !frame.ends_with("_home"); };
  how.searches = !wanted.without_search;
  return kanexpr::explain(built, how);
}

int write(request r) {
  const std::string file = std::filesystem::path(r.file).stem().string();
  const std::string name = r.name.empty() ? identifier_from(file) : r.name;
  if (!is_valid_namespace(name))
    return refuse(r.name.empty() ? file + " is not a valid namespace name; set one with --name"
                                 : name + " is not a valid namespace name");
  r.name = name;
  if (r.without_search && !r.explains && !r.is_cheapest)
    return refuse("--no-search needs --cheapest or --explain");
  operation_weights weights;
  if (!r.weights.empty())
    if (const std::string mistake = read_weights(r.weights, weights); !mistake.empty())
      return refuse(mistake);
  if (r.as_written) r.reading.right_angles = 0;
  r.reading.mimic = !r.without_mimic, r.model.damping = !r.without_damping;
  r.model.base = r.base == "floating" ? base_kind::floating : base_kind::fixed;
  r.model.bind = r.bind == "parameters" ? binding::parameters : binding::numbers;
  const read_robot read = robot_of(r.file, r.reading);
  if (!r.quiet)
    for (const std::string& note : read.notes) std::cerr << "kanexpr-robot: note: " << note << '\n';
  if (!read) return refuse(read.cause());
  if (weights != operation_weights{})
    r.model.formulation = "formulation<" + kanexpr::runtime::word_of(weights) + ">";
  if (r.explains || r.is_cheapest) {
    const kanexpr::explanation forms = forms_of(read.robot, r, weights);
    if (!forms.mistake.empty()) return refuse(r.file + ": " + forms.mistake);
    if (r.explains) return std::cout << forms.text(), 0;
    if (!forms.best().word.empty()) r.model.formulation = forms.best().word;
  }
  header_writer writer(read.robot, r.model);
  if (!writer.cause().empty()) return refuse(r.file + ": " + writer.cause());
  if (const std::string renamed = writer.renamed(); !renamed.empty() && !r.quiet)
    std::cerr << "kanexpr-robot: note: names in C++: " << renamed << '\n';
  const std::string text = writer.write(r.name, r.file.substr(r.file.rfind('/') + 1));
  if (!r.picture.empty() && !draw(read.robot, r)) return 1;
  if (r.header.empty()) return std::cout << text, 0;
  return leave(text, r.header) ? 0 : 1;
}

} // namespace

int main(int count, char** arguments) {
  request r;
  CLI::App app("Writes the model of a robot described by a URDF or SDF file as a C++ header.");
  app.add_option("file", r.file, "the robot; .sdf and .world files are read as SDF")->required();
  app.add_option("-n,--name", r.name, "the namespace of the model (default: the name of the file)");
  auto* const output =
      app.add_option("-o,--output", r.header, "the header to write (default: standard output)");
  auto* const picture =
      app.add_option("--picture", r.picture, "a second header to write, with the picture of the robot");
  app.add_option("--base", r.base, "whether the root is fixed (default) or moves")
      ->check(CLI::IsMember({"fixed", "floating"}))
      ->option_text("fixed|floating");
  app.add_option("--bind", r.bind,
                 "whether masses, mass centers, inertias, dampings and gravity are numbers (default) or "
                 "parameters with these values")
      ->check(CLI::IsMember({"numbers", "parameters"}))
      ->option_text("numbers|parameters");
  app.add_option("--gravity", r.model.gravity,
                 "gravity along -z of the root, in m/s^2 (default: that of an SDF world, or 9.81)")
      ->option_text("NUMBER");
  app.add_flag("--as-written", r.as_written, "use angles as written: 1.5708 is not a right angle");
  app.add_flag("--no-mimic", r.without_mimic, "let joints that mimic others move independently");
  app.add_flag("--no-damping", r.without_damping, "omit the damping of joints");
  app.add_flag_callback(
      "--friction", [&r] { r.model.friction.emplace(); }, "include the dry friction of joints");
  app.add_flag_callback("--stops", [&r] { r.model.stops.emplace(); }, "make the limits of joints stops");
  auto* const cheapest = app.add_flag(
      "--cheapest", r.is_cheapest, "state the form of the equations in which u' takes the fewest operations");
  app.add_flag("--explain", r.explains,
               "print the forms of the equations and what u' costs in each; write nothing")
      ->excludes(output, picture, cheapest);
  app.add_option("--weights", r.weights,
                 "what operations cost on the target, in any unit, for --cheapest, --explain and the header: "
                 "addition=12,division=45")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->option_text("OPERATION=NUMBER,...");
  app.add_flag("--no-search", r.without_search,
               "compare only forms that treat all bodies alike, which is faster for large robots");
  app.add_flag("-q,--quiet", r.quiet, "do not print notes about the file and about renamed links and joints");
  CLI11_PARSE(app, count, arguments);
  return write(std::move(r));
}
