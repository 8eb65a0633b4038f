// write FOLDER NAME OPTIONS...: writes a model in C, as kanexpr-export does.
#include <kanexpr/export.hpp>
#include <kanexpr/exporting/command_line.hpp>

#include <models/iiwa.hpp>

int main(int count, char** words) {
  return kanexpr::exporting::run_command_line<iiwa::System>(kanexpr::exporting::c_format, count, words, {});
}
