// kanexpr-robot: writes the model of a robot that a URDF file describes as a header.
#include <kanexpr/robots/header_writer.hpp>
#include <kanexpr/robots/picture_writer.hpp>
#include <kanexpr/robots/read_urdf.hpp>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <string>

namespace {

using namespace kanexpr::robots;

struct request {
  std::string file{}, name{}, header{}, picture{};
  urdf_options reading{};
  model_options model{};
  bool as_written = false, quiet = false;
};

bool is_identifier(const std::string& name) {
  return !name.empty() &&
         name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") ==
             name.npos &&
         name.find_first_of("0123456789_") != 0;
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

int write(request r) {
  if (!is_identifier(r.name)) return refuse(r.name + " is not the name of a namespace");
  if (r.as_written) r.reading.right_angles = 0;
  const read_robot read = read_urdf(r.file, r.reading);
  if (!r.quiet)
    for (const std::string& note : read.notes) std::cerr << "kanexpr-robot: note: " << note << '\n';
  if (!read) return refuse(read.cause());
  header_writer writer(read.robot, r.model);
  if (!writer.cause().empty()) return refuse(r.file + ": " + writer.cause());
  const std::string text = writer.write(r.name, r.file.substr(r.file.rfind('/') + 1));
  if (!r.picture.empty() && !draw(read.robot, r)) return 1;
  if (r.header.empty()) return std::cout << text, 0;
  return leave(text, r.header) ? 0 : 1;
}

} // namespace

int main(int count, char** arguments) {
  request r;
  CLI::App app("Writes the model of a robot that a URDF file describes as a header.");
  app.add_option("urdf", r.file, "the file")->required();
  app.add_option("-n,--name", r.name, "the namespace of the model")->required();
  app.add_option("-o,--output", r.header, "the header; without one it is printed");
  app.add_option("--picture", r.picture, "a second header, with what the robot looks like");
  const std::map<std::string, base_kind> bases{{"fixed", base_kind::fixed},
                                               {"floating", base_kind::floating}};
  app.add_option("--base", r.model.base, "whether the root is fixed or floating")
      ->transform(CLI::CheckedTransformer(bases));
  const std::map<std::string, binding> bindings{{"numbers", binding::numbers},
                                                {"parameters", binding::parameters}};
  app.add_option("--bind", r.model.bind, "what masses are in the model")
      ->transform(CLI::CheckedTransformer(bindings));
  app.add_option("--gravity", r.model.gravity, "against the z axis of the root, in m/s^2");
  app.add_flag("--as-written", r.as_written, "angles as they are written: 1.5708 is no right angle");
  app.add_flag("!--no-mimic", r.reading.mimic, "joints that follow others move by themselves");
  app.add_flag("!--no-damping", r.model.damping, "leave the damping of joints out");
  app.add_flag("--friction", r.model.friction, "with the dry friction of joints");
  app.add_flag("-q,--quiet", r.quiet, "do not say what is strange in the file");
  CLI11_PARSE(app, count, arguments);
  return write(std::move(r));
}
