#include "page.hpp"
#include "equations.hpp"

#include <kanexpr/animate/write_page.hpp>
#include <kanexpr/export.hpp>
#include <kanexpr/figures.hpp>
#include <kanexpr/fmi.hpp>

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace gallery {

using namespace kanexpr;
using nlohmann::json;

namespace {

constexpr int most_products_for_second_derivatives =
    1500; // in u̇; those of larger models have tens of megabytes

/// Ends the program with a sentence if a part cannot be written.
void require(const outcome& written) {
  if (!written) throw std::runtime_error(written.cause());
}

json values_of(model& m, symbolic::symbol_kind kind, const Eigen::VectorXd& values) {
  json all = json::array();
  for (int i = 0; i < m.known()->count_of(kind); ++i)
    all.push_back({{"latex", latex_of(m, kind, i)}, {"value", values(i)}});
  return all;
}

void draw_figure(model& m, const material& all, const std::filesystem::path& file) {
  const figure_view& view = all.figure;
  const figure drawn = draw(m, all.state, all.parameters, all.inputs,
                            {.title = all.about.title,
                             .upward = view.upward,
                             .eye = view.eye,
                             .angles = view.angles,
                             .lengths = view.lengths,
                             .loads = view.loads,
                             .names = view.names});
  if (!drawn) throw std::runtime_error(drawn.cause());
  require(drawn.write(file.string()));
}

/// The values at which an FMU starts: those of the motion, without the speeds that constraints determine.
std::vector<named_value> start_values(const derivation::survey& known, const material& all) {
  std::vector<named_value> start;
  const int states = known.coordinates + known.speeds;
  for (int i = 0; i < states; ++i)
    if (!known.dependent[i] || i < known.coordinates)
      start.push_back({std::string(known.names[i].view()), all.start(i)});
  for (int i = 0; i < known.parameters; ++i)
    start.push_back({std::string(known.names[states + i].view()), all.parameters(i)});
  return start;
}

/// Writes the files to take away, and returns their names and what they are.
json write_files_of(const material& all, const std::string& folder, const std::string& name) {
  const derivation::survey known = *all.derive().known();
  json files = json::array();
  const auto write = [&](const exporting::export_format& format, std::vector<named_value> start,
                         std::vector<std::string> written, const std::string& what) {
    runtime::staged_derivation derivation(all.derive);
    const outcome done =
        format.write(derivation, {.folder = folder, .name = name, .start = std::move(start)});
    if (!done) return std::fprintf(stderr, "%s: %s\n", name.c_str(), done.cause().c_str()), void();
    for (const std::string& each : written) files.push_back({{"name", name + each}, {"what", what}});
  };
  write(exporting::c_format, {}, {".c", ".h"}, "C99");
  if (all.udot.multiplications <= most_products_for_second_derivatives)
    write(exporting::casadi_format, {}, {"_casadi.c", "_casadi.h"}, "CasADi");
  write(exporting::fmi_format, start_values(known, all), {".fmu"}, "FMI 3.0");
  return files;
}

json counts_of(const derivation::survey& known, const material& all) {
  return {{"coordinates", known.coordinates},
          {"speeds", known.speeds},
          {"constraints", known.constraints},
          {"degrees_of_freedom", known.speeds - known.constraints},
          {"multiplications", all.udot.multiplications},
          {"additions", all.udot.additions},
          {"divisions", all.udot.divisions},
          {"sincos", all.udot.trigonometric},
          {"other", all.udot.other},
          {"nanoseconds", all.nanoseconds},
          {"seconds_of_motion", all.motion.times.back() - all.motion.times.front()}};
}

json groups_of(model& m) {
  json groups = json::array();
  for (const equation_group& each : equations_of(m))
    groups.push_back(
        {{"heading", each.heading}, {"lines", each.lines}, {"note", each.note}, {"folded", each.is_folded}});
  return groups;
}

void write_parts(const material& all, const checks& done, const std::filesystem::path& folder,
                 const std::string& name) {
  require(animate::write_page((folder / "motion.html").string(), all.motion, {.title = all.about.title}));
  model m = all.derive();
  draw_figure(m, all, folder / "figure.svg");
  const json page{{"name", name},
                  {"title", all.about.title},
                  {"kind", all.about.kind},
                  {"see", all.about.see},
                  {"source", all.about.source},
                  {"proofs", done.proofs()},
                  {"equations", groups_of(m)},
                  {"counts", counts_of(*m.known(), all)},
                  {"parameters", values_of(m, symbolic::symbol_kind::parameter, all.parameters)},
                  {"files", write_files_of(all, folder.string(), name)}};
  std::ofstream out(folder / "page.json");
  out << page.dump(1) << '\n';
  if (!out) throw std::runtime_error("page.json cannot be written");
}

} // namespace

int page::write(const material& all) const {
  const std::filesystem::path folder = std::filesystem::absolute(folder_).lexically_normal();
  const std::string name = folder.filename().string();
  std::string cause = this->cause();
  if (cause.empty()) cause = all.motion.cause();
  if (cause.empty()) try {
      std::filesystem::create_directories(folder);
      write_parts(all, *this, folder, name);
    } catch (const std::exception& failure) {
      cause = failure.what();
    }
  if (cause.empty()) return 0;
  std::fprintf(stderr, "%s: %s\n", name.c_str(), cause.c_str());
  return 1;
}

} // namespace gallery
