#include "output.hpp"

#include <kanexpr/animate/write_page.hpp>
#include <kanexpr/simulations/tables/csv.hpp>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstdlib>

namespace {

bool tell(const std::string& file, const std::string& failure) {
  if (failure.empty())
    std::printf("  left in %s\n", file.c_str());
  else
    std::fprintf(stderr, "%s\n", failure.c_str());
  return failure.empty();
}

} // namespace

output::output(const char* title, const char* about, int count, char** words) : title_(title), about_(about) {
  CLI::App line(about_);
  line.add_option("--page", page_, "leave the motion in a page for a browser")->type_name("FILE");
  line.add_option("--csv", csv_, "leave the motion in a table")->type_name("FILE");
  try {
    line.parse(count, words);
  } catch (const CLI::ParseError& end) {
    std::exit(line.exit(end));
  }
}

bool output::write(const kanexpr::table& all) const {
  return tell(csv_, kanexpr::write_csv(all, csv_).cause());
}

bool output::write(const kanexpr::animation& moving) const {
  return tell(page_, kanexpr::animate::write_page(page_, moving, {.title = title_, .text = about_}).cause());
}
