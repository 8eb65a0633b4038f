// write FOLDER NAME OPTIONS...: writes a model in C, as kanexpr-export does.
#include <kanexpr/export/by_words.hpp>

#include <models/iiwa.hpp>

int main(int count, char** words) {
  return kanexpr::exporting::write_by_words<iiwa::System>(count, words, {});
}
