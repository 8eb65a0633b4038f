// kanexpr-flexible-body: writes the numbers of a flexible body as a header.
#include <kanexpr/flexible/header_writer.hpp>
#include <kanexpr/flexible/read_sid.hpp>
#ifdef KANEXPR_FLEXIBLE_READ_MODES
#include <kanexpr/flexible/read_modes.hpp>
#endif
#include <kanexpr/robots/identifiers.hpp>

#include <CLI/CLI.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <utility>

namespace {

using namespace kanexpr::flexible;

struct request {
  std::string file{}, name{}, header{};
  reading_options reading{};
  bool quiet = false;
};

read_body body_of(const std::string& file, const reading_options& options) {
  if (!file.ends_with(".json")) return read_sid(file, options);
#ifdef KANEXPR_FLEXIBLE_READ_MODES
  return read_modes(file, options);
#else
  return read_body(file +
                   " is a JSON file, but kanexpr-flexible-body was compiled without nlohmann-json, which "
                   "reads such files; the Debian package is nlohmann-json3-dev");
#endif
}

int refuse(const std::string& cause) {
  std::cerr << "kanexpr-flexible-body: " << cause << '\n';
  return 1;
}

int write(request r) {
  const std::filesystem::path path(r.file);
  if (r.name.empty()) r.name = kanexpr::robots::identifier_from(path.stem().string());
  if (!kanexpr::robots::is_valid_namespace(r.name))
    return refuse(r.name + " is not a valid namespace name; set one with --name");
  const read_body read = body_of(r.file, r.reading);
  if (!r.quiet)
    for (const std::string& note : read.notes) std::cerr << "kanexpr-flexible-body: note: " << note << '\n';
  if (!read) return refuse(read.cause());
  const std::string text = header_writer(read.data).write(r.name, path.filename().string());
  if (r.header.empty()) return std::cout << text, 0;
  std::ofstream out(r.header, std::ios::binary);
  out << text;
  out.close();
  return out ? 0 : refuse(r.header + " cannot be written");
}

} // namespace

int main(int count, char** arguments) {
  request r;
  CLI::App app("Writes the numbers of a flexible body as a C++ header.");
  app.add_option("file", r.file, "standard input data (SID); .json files are read as modes")->required();
  app.add_option("-n,--name", r.name, "the namespace of the numbers (default: the name of the file)");
  app.add_option("-o,--output", r.header, "the header to write (default: standard output)");
  app.add_option("--agreement", r.reading.agreement,
                 "the largest difference between entries that determine each other, relative to the largest "
                 "entry of the matrix (default: 0.01)");
  app.add_flag("--prefer-derived", r.reading.prefer_derived,
               "only note larger differences; J, Cr and Ct determine the other matrices");
  app.add_flag("-q,--quiet", r.quiet, "do not print notes about the file");
  CLI11_PARSE(app, count, arguments);
  return write(std::move(r));
}
