// kanexpr-export: exports a robot from a file, or a model from a header, to other languages.
#include <kanexpr/exporting/c/write_c.hpp>
#include <kanexpr/exporting/casadi/write_casadi.hpp>
#include <kanexpr/exporting/command_line.hpp>
#include <kanexpr/exporting/shell.hpp>
#include <kanexpr/robots/identifiers.hpp>
#include <kanexpr/robots/read_urdf.hpp>
#include <kanexpr/robots/robot_builder.hpp>
#ifdef KANEXPR_ROBOTS_READ_SDF
#include <kanexpr/robots/read_sdf.hpp>
#endif
#ifdef KANEXPR_FMI_OPTIONS
#include <kanexpr/exporting/fmi/write_fmu.hpp>
#endif

#include <CLI/CLI.hpp>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

namespace {

using namespace kanexpr;
namespace files = std::filesystem;

using exporting::shell_quoted;

/// The formats; a format whose library is missing has no function that writes files.
constexpr exporting::export_format formats[]{exporting::c_format, exporting::casadi_format,
#ifdef KANEXPR_FMI_OPTIONS
                                             exporting::fmi_format
#else
#define KANEXPR_FMI_OPTIONS ""
                                             {.name = "fmi"}
#endif
};

/// Returns the program that an environment variable names, or the default.
std::string program_from_environment(const char* variable, const char* otherwise) {
  const char* const chosen = std::getenv(variable);
  return chosen != nullptr && *chosen != '\0' ? chosen : otherwise;
}

struct request {
  std::string file{}, system{}, name{}, folder{}, format = "c", scalar = "double", base = "fixed",
                                                  bind_robot = "numbers";
  std::string step{};
  std::vector<std::string> bound{}, start{}, results{}, expressions{}, include{};
  bool with_python = false, with_cpp = false, quiet = false;

  bool is_robot() const {
    return file.ends_with(".urdf") || file.ends_with(".sdf") || file.ends_with(".world");
  }
  const exporting::export_format& row() const {
    return *std::find_if(std::begin(formats), std::end(formats),
                         [&](const exporting::export_format& each) { return each.name == format; });
  }

  std::vector<std::string> arguments() const {
    std::vector<std::string> all{folder, name, "scalar=" + scalar};
    if (format == "fmi") all.push_back("compiler=" + program_from_environment("CC", "cc"));
    if (!step.empty()) all.push_back("step=" + step);
    for (const std::string& each : start) all.push_back("start=" + each);
    for (const std::string& each : bound) all.push_back("bind=" + each);
    for (const std::string& each : results) all.push_back("results=" + each);
    if (with_python) all.emplace_back("python");
    if (with_cpp) all.emplace_back("cpp");
    return all;
  }
};

int refuse(const std::string& cause) {
  std::cerr << "kanexpr-export: " << cause << '\n';
  return 1;
}

robots::read_robot read_robot_file(const std::string& file) {
  if (file.ends_with(".urdf")) return robots::read_urdf(file, {});
#ifdef KANEXPR_ROBOTS_READ_SDF
  return robots::read_sdf(file, {});
#else
  return robots::read_robot(file + " is an SDF file, but kanexpr-export was compiled without libsdformat 12, "
                                   "which reads such files; the Debian package is libsdformat-dev");
#endif
}

/// Adds the start values from the file and those of the robot at rest, unless the command line sets them.
void add_start_values(std::vector<std::string>& arguments, const request& r,
                      const robots::robot_builder& of) {
  const auto add = [&](const std::string& symbol, double value) {
    for (const auto* given : {&r.start, &r.bound})
      for (const std::string& each : *given)
        if (each.starts_with(symbol + '=')) return;
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    arguments.push_back("start=" + symbol + '=' + std::string(digits, end));
  };
  for (const auto& [symbol, value] : of.at_rest()) add(symbol, value);
  for (const auto& [symbol, value] : of.values()) add(symbol, value);
}

int write_robot(const request& r) {
  if (!r.expressions.empty())
    return refuse("--expression applies to headers; a robot file does not support expressions");
  robots::model_options model;
  model.base = r.base == "floating" ? robots::base_kind::floating : robots::base_kind::fixed;
  model.bind = r.bind_robot == "parameters" ? robots::binding::parameters : robots::binding::numbers;
  const robots::read_robot read = read_robot_file(r.file);
  if (!r.quiet)
    for (const std::string& note : read.notes) std::cerr << "kanexpr-export: note: " << note << '\n';
  if (!read) return refuse(read.cause());
  const robots::robot_builder of(read.robot, model);
  if (!of.cause().empty()) return refuse(r.file + ": " + of.cause());
  std::vector<std::string> arguments = r.arguments();
  if (r.format == "fmi") add_start_values(arguments, r, of);
  const exporting::command_line given(r.row(), arguments);
  runtime::staged_derivation derivation([&] { return runtime::derive_in_own_graph(of); });
  const outcome written = given.write(derivation);
  return written ? 0 : refuse(written.cause());
}

/// Whether the text has the form name=expression.
bool has_name(const std::string& expression) {
  const std::size_t end =
      expression.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_0123456789");
  return end != 0 && end != std::string::npos && expression[end] == '=' && end + 1 < expression.size();
}

std::string compiler() { return program_from_environment("CXX", "c++"); }

bool is_clang() {
  return std::system((compiler() + " -dM -E -x c++ /dev/null 2>/dev/null | grep -q __clang__").c_str()) == 0;
}

/// The compiler options: those of kanexpr's CMake target, and the include folders.
std::string options(const request& r) {
  std::string all = is_clang() ? " -fconstexpr-steps=1000000000 -fbracket-depth=1024"
                               : " -fconstexpr-ops-limit=1000000000 -fconstexpr-loop-limit=10000000";
  all += " -std=c++20 -fconstexpr-depth=2000";
  for (const std::string& each : r.include) all += " -I" + shell_quoted(each);
  std::error_code unknown;
  const files::path here = files::read_symlink("/proc/self/exe", unknown).parent_path();
  const files::path installed_headers = here.parent_path() / "include";
  if (files::exists(installed_headers / "kanexpr" / "export.hpp", unknown))
    all += " -I" + shell_quoted(installed_headers.string());
  all += " -isystem " + shell_quoted(KANEXPR_EIGEN);
  return r.format == "fmi" ? all + ' ' + KANEXPR_FMI_OPTIONS : all;
}

/// The source of the program that exports a model. Expressions are looked up in the namespace of the system.
std::string source_of_exporter(const request& r) {
  const std::string header = r.format == "fmi" ? "fmi.hpp>\n" : "export.hpp>\n";
  std::string text = "#include <kanexpr/exporting/command_line.hpp>\n#include <kanexpr/" + header +
                     "\n#include \"" + files::absolute(r.file).string() +
                     "\"\n\nint main(int count, char** arguments) {\n";
  const std::size_t end = r.system.substr(0, r.system.find('<')).rfind("::");
  if (end != std::string::npos && end > 0 && !r.expressions.empty())
    text += "  using namespace " + r.system.substr(0, end) + ";\n";
  text += "  return kanexpr::exporting::run_command_line<" + r.system + ">(kanexpr::exporting::" + r.format +
          "_format, count, arguments, {";
  for (const std::string& each : r.expressions) {
    const std::size_t equals = each.find('=');
    text += "kanexpr::exporting::expression<(" + each.substr(equals + 1) + ")>(\"" + each.substr(0, equals) +
            "\"), ";
  }
  return text + "});\n}\n";
}

int write_model(const request& r) {
  if (r.system.empty())
    return refuse("specify the system of " + r.file + " to export, as in --system arm::System");
  std::error_code unknown;
  if (!files::is_regular_file(r.file, unknown)) return refuse(r.file + " cannot be read");
  if (const exporting::command_line given(r.row(), r.arguments()); !given.cause().empty())
    return refuse(given.cause());
  for (const std::string& each : r.expressions)
    if (!has_name(each)) return refuse(each + " is not of the form name=expression");
  const exporting::temporary_folder with;
  if (with.path().empty()) return refuse("the temporary folder for the export program cannot be created");
  const std::string source = (with.path() / "write.cpp").string(), program = (with.path() / "write").string();
  std::ofstream(source) << source_of_exporter(r);
  const std::string compile =
      compiler() + ' ' + shell_quoted(source) + options(r) + " -o " + shell_quoted(program);
  if (std::system(compile.c_str()) != 0)
    return refuse(r.file + " with the system " + r.system + " does not compile; " + compiler() +
                  " reports the errors");
  std::string call = shell_quoted(program);
  for (const std::string& each : r.arguments()) call += ' ' + shell_quoted(each);
  return std::system(call.c_str()) == 0 ? 0 : 1;
}

/// Reports an option that does not apply to the file; empty if all do.
std::string inapplicable_option(const CLI::App& given, const request& r) {
  for (const char* option : {"--system", "--include"})
    if (r.is_robot() && given.count(option) != 0)
      return std::string(option) + " applies to headers, but " + r.file + " is a robot file";
  for (const char* option : {"--base", "--values"})
    if (!r.is_robot() && given.count(option) != 0)
      return std::string(option) + " applies to robots, but " + r.file + " is a header";
  return {};
}

} // namespace

int main(int count, char** arguments) {
  request r;
  CLI::App app("Exports the equations of motion of a robot or a model to other languages.");
  const auto add = [&](const char* option, auto& to, const char* help) {
    return app.add_option(option, to, help);
  };
  const auto add_repeated = [&](const char* option, auto& to, const char* help) {
    return add(option, to, help)->expected(1)->take_all();
  };
  const auto add_choice = [&](const char* option, auto& to, const std::vector<std::string>& choices,
                              const char* help) {
    add(option, to, help)->check(CLI::IsMember(choices))->option_text(CLI::detail::join(choices, "|"));
  };
  std::vector<std::string> names;
  for (const exporting::export_format& each : formats) names.emplace_back(each.name);
  add("file", r.file, "a robot file (.urdf, .sdf or .world), or the header of a model, which $CXX compiles")
      ->required();
  add("-s,--system", r.system, "the system in the header, as in arm::System");
  add("-n,--name", r.name, "the name of the exported system; default: that of the file");
  add("-o,--output", r.folder, "the output folder")->required();
  add_choice("--format", r.format, names, "the output format; default: c");
  add_choice("--scalar", r.scalar, {"double", "float"}, "the scalar type; default: double");
  add_repeated("--bind", r.bound, "a parameter to replace by a number; may be repeated")
      ->option_text("PARAMETER=NUMBER");
  add_repeated("--start", r.start,
               "the start value of a parameter, an input or a state of an FMU; may be repeated")
      ->option_text("SYMBOL=NUMBER");
  add("--step", r.step, "the internal step of an FMU's co-simulation, in s; default: 0.001")
      ->option_text("NUMBER");
  add_repeated(
      "--results", r.results,
      "a function with one result, or several separated by spaces; in an FMU, an output; may be repeated")
      ->option_text("RESULTS");
  add_repeated("--expression", r.expressions,
               "a function that evaluates an expression of the header's model; may be repeated")
      ->option_text("NAME=EXPRESSION");
  app.add_flag("--with-python", r.with_python, "also write a Python module");
  app.add_flag("--with-cpp", r.with_cpp, "also write a C++ header with the names of the model");
  add_repeated("-I,--include", r.include, "a folder to search for included headers; may be repeated");
  add_choice("--base", r.base, {"fixed", "floating"}, "the base of the robot: fixed (default) or floating");
  add_choice(
      "--values", r.bind_robot, {"numbers", "parameters"},
      "whether masses, mass centers, inertias, dampings and gravity of the robot are numbers (default) or "
      "parameters");
  app.add_flag("-q,--quiet", r.quiet, "suppress the notes about the robot file");
  CLI11_PARSE(app, count, arguments);
  if (const std::string wrong = inapplicable_option(app, r); !wrong.empty()) return refuse(wrong);
  if (r.row().write == nullptr)
    return refuse(
        "the format " + r.format +
        " requires libzip, without which kanexpr-export was compiled; the Debian package is libzip-dev");
  if (r.name.empty()) r.name = std::filesystem::path(r.file).stem().string();
  if (r.is_robot() && app.count("--name") == 0) r.name = kanexpr::robots::identifier_from(r.name);
  return r.is_robot() ? write_robot(r) : write_model(r);
}
