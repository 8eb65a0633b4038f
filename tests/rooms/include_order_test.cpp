// builds: clang++
#include "rooms/include_order.hpp"

#include <gmock/gmock.h>

namespace {

using rooms::headers;
using rooms::order;
using testing::ElementsAre;
using testing::IsEmpty;

const std::filesystem::path project = KANEXPR_SOURCE_DIR;

const order& order_of_rooms() {
  static const order read(rooms::text_of(project / "docs/how-it-works.md"));
  return read;
}

const headers& library() {
  static const headers read = rooms::headers_in(project / "include");
  return read;
}

headers with(headers all, const std::string& header, const std::string& text) {
  all[header] += text;
  return all;
}

TEST(include_order, every_folder_has_a_place) {
  EXPECT_FALSE(order_of_rooms().empty());
  EXPECT_THAT(rooms::homeless(library(), order_of_rooms()), IsEmpty());
}

TEST(include_order, every_included_file_is_there) { EXPECT_THAT(rooms::dangling(library()), IsEmpty()); }

TEST(include_order, nothing_includes_what_stands_above_it) {
  EXPECT_THAT(rooms::upward(library(), order_of_rooms()), IsEmpty());
}

TEST(include_order, nothing_includes_itself_by_way_of_others) {
  EXPECT_THAT(rooms::circles(library()), IsEmpty());
}

bool is_header(const std::string& named) {
  return library().contains("kanexpr/" + named) || library().contains(named) ||
         std::filesystem::exists(project / named);
}

/// Whether the table of rooms names a file in a folder of a room.
bool is_in_a_room(const std::string& named) {
  return std::ranges::any_of(order_of_rooms().rooms(),
                             [&](const std::string& room) { return is_header(room + "/" + named); });
}

TEST(include_order, headers_named_in_the_documents_are_there) {
  std::vector<std::filesystem::path> pages{project / "CONTRIBUTING.md"};
  for (const auto& file : std::filesystem::directory_iterator(project / "docs"))
    if (file.path().extension() == ".md") pages.push_back(file.path());
  for (const std::filesystem::path& page : pages)
    for (const std::string& named : rooms::matches(rooms::text_of(page), "`([a-z_/]+/[a-z_]+\\.hpp)`"))
      EXPECT_TRUE(is_header(named) || is_in_a_room(named))
          << page << " names " << named << ", which is not there";
}

TEST(include_order, every_room_has_a_page_whose_headers_are_there) {
  const std::filesystem::path folder = project / "include/kanexpr";
  for (const std::string& room : order_of_rooms().rooms())
    EXPECT_TRUE(std::filesystem::exists(folder / room / "README.md")) << room << " has no README.md";
  for (const auto& file : std::filesystem::recursive_directory_iterator(folder)) {
    if (file.path().extension() != ".md") continue;
    const std::string text = rooms::text_of(file),
                      here = file.path().parent_path().lexically_relative(folder).generic_string(),
                      room = here.substr(0, here.find('/'));
    EXPECT_LE(std::ranges::count(text, '\n'), 60) << file.path() << " has more than 60 lines";
    for (const std::string& named : rooms::matches(text, "`([a-z0-9_/]+\\.hpp)`"))
      EXPECT_TRUE(is_header(here + "/" + named) || is_header(room + "/" + named) || is_header(named))
          << file.path() << " names " << named << ", which is not there";
  }
}

TEST(include_order, sees_a_folder_without_a_place) {
  EXPECT_THAT(rooms::homeless(with(library(), "kanexpr/attic/box.hpp", ""), order_of_rooms()),
              ElementsAre("kanexpr/attic/box.hpp is in a folder that the order of the rooms does not have"));
}

TEST(include_order, sees_a_file_that_is_not_there) {
  EXPECT_THAT(
      rooms::dangling(with(library(), "kanexpr/base/status.hpp", "#include <kanexpr/base/gone.hpp>\n")),
      ElementsAre("kanexpr/base/status.hpp includes kanexpr/base/gone.hpp, which is not there"));
  EXPECT_THAT(rooms::dangling(with(library(), "kanexpr/base/status.hpp", "#include \"sequence.hpp\"\n")),
              ElementsAre("kanexpr/base/status.hpp includes sequence.hpp, which is not there"));
}

TEST(include_order, sees_an_arrow_to_a_room_above) {
  EXPECT_THAT(
      upward(with(library(), "kanexpr/numeric/angle.hpp", "# include <kanexpr/lower/tape.hpp>\n"),
             order_of_rooms()),
      ElementsAre("kanexpr/numeric/angle.hpp includes kanexpr/lower/tape.hpp, which stands above it"));
}

TEST(include_order, sees_an_arrow_to_a_folder_above_within_a_room) {
  EXPECT_THAT(rooms::upward(with(library(), "kanexpr/mechanics/model/fixed.hpp",
                                 "#include <kanexpr/mechanics/dynamics/kane.hpp>\n"),
                            order_of_rooms()),
              ElementsAre("kanexpr/mechanics/model/fixed.hpp includes kanexpr/mechanics/dynamics/kane.hpp, "
                          "which stands above it"));
}

TEST(include_order, sees_an_arrow_out_of_all_rooms) {
  EXPECT_THAT(
      rooms::upward(with(library(), "kanexpr/animate/elements.hpp", "#include <kanexpr/kanexpr.hpp>\n"),
                    order_of_rooms()),
      ElementsAre("kanexpr/animate/elements.hpp includes kanexpr/kanexpr.hpp, which stands above it"));
}

TEST(include_order, sees_a_circle) {
  const headers two{{"kanexpr/base/a.hpp", "#include <kanexpr/base/b.hpp>\n"},
                    {"kanexpr/base/b.hpp", "#include <kanexpr/base/a.hpp>\n"},
                    {"kanexpr/base/c.hpp", "#include <kanexpr/base/a.hpp>\n"}};
  EXPECT_THAT(rooms::circles(two),
              ElementsAre("kanexpr/base/b.hpp includes kanexpr/base/a.hpp, which includes it in turn"));
}

} // namespace
