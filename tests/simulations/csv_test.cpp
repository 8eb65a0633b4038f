// builds: clang++
#include <kanexpr/simulations/tables/csv.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <locale>
#include <random>
#include <sstream>

namespace {

using kanexpr::csv_writer;
using kanexpr::outcome;
using kanexpr::read_csv;
using kanexpr::table;
using kanexpr::write_csv;

table read(const std::string& text) {
  std::istringstream in(text);
  return read_csv(in, "run.csv");
}

std::string written(const table& all) {
  std::ostringstream out;
  const outcome done = write_csv(all, out);
  EXPECT_TRUE(done) << done.cause();
  return out.str();
}

std::string in_directory_of_tests(const std::string& name) { return testing::TempDir() + name; }

constexpr double infinite = std::numeric_limits<double>::infinity();

TEST(csv, writes_names_and_then_rows) {
  table run;
  EXPECT_TRUE(run.add("t", {0, 0.1, -1e-300}));
  EXPECT_TRUE(run.add("q1", {std::nan(""), -infinite, 3}));
  EXPECT_EQ(written(run), "t,q1\n0,nan\n0.1,-inf\n-1e-300,3\n");
}

TEST(csv, reproduces_all_bits) {
  std::mt19937_64 random(7);
  std::vector<double> any, usual,
      special{0.0,
              -0.0,
              0.1,
              1.0 / 3,
              infinite,
              -infinite,
              std::numeric_limits<double>::max(),
              std::numeric_limits<double>::min(),
              std::numeric_limits<double>::denorm_min(),
              -std::numeric_limits<double>::lowest(),
              1e23,
              9007199254740993.0};
  while (any.size() < 20000) {
    const double number = std::bit_cast<double>(random());
    if (std::isfinite(number)) any.push_back(number);
    if (std::isfinite(number)) usual.push_back(std::uniform_real_distribution(-10.0, 10.0)(random));
  }
  special.resize(any.size(), std::numeric_limits<double>::epsilon());
  table run;
  EXPECT_TRUE(run.add("any", any));
  EXPECT_TRUE(run.add("usual", usual));
  EXPECT_TRUE(run.add("special", special));
  const table again = read(written(run));
  ASSERT_TRUE(again) << again.cause();
  EXPECT_EQ(again.names(), run.names());
  for (std::size_t j = 0; j < run.columns(); ++j)
    for (std::size_t i = 0; i < run.rows(); ++i)
      ASSERT_EQ(std::bit_cast<std::uint64_t>(again.values(j)[i]),
                std::bit_cast<std::uint64_t>(run.values(j)[i]))
          << run.names()[j] << " " << run.values(j)[i];
}

TEST(csv, quotes_names_if_necessary) {
  table run;
  const std::vector<std::string> names{"q1",         "a,b", "the \"rate\"", " before",       "after ",
                                       "two\nlines", "\"",  "\",\"\n\"",    "dq1/dt (rad/s)"};
  for (const std::string& name : names) EXPECT_TRUE(run.add(name, {1, 2}));
  const std::string text = written(run);
  EXPECT_EQ(text.substr(0, text.find(" before")), "q1,\"a,b\",\"the \"\"rate\"\"\",\"");
  const table again = read(text);
  ASSERT_TRUE(again) << again.cause();
  EXPECT_EQ(again.names(), names);
  EXPECT_EQ(again.rows(), 2u);
}

TEST(csv, writes_and_reads_units) {
  table run;
  EXPECT_TRUE(run.add("t", {0}, "s"));
  EXPECT_TRUE(run.add("F, x", {2}, "kg m/s²"));
  EXPECT_TRUE(run.add("k", {3}));
  EXPECT_EQ(written(run), "t [s],\"F, x [kg m/s²]\",k\n0,2,3\n");
  std::ostringstream names;
  ASSERT_TRUE(write_csv(run, names, "names", {.with_units = false}));
  EXPECT_EQ(names.str(), "t,\"F, x\",k\n0,2,3\n");

  const table again = read(written(run));
  ASSERT_TRUE(again) << again.cause();
  EXPECT_EQ(again.names(), run.names());
  EXPECT_EQ(again.units(), run.units());
  EXPECT_EQ(again["t"].unit(), "s");
  EXPECT_EQ(again["F, x [kg m/s²]"][0], 2); // as other programs name it
  EXPECT_EQ(again["k"].unit(), "");

  const table twice = read("v [m/s],v [km/h],[m],a[m]\n1,3.6,2,4\n");
  ASSERT_TRUE(twice) << twice.cause();
  EXPECT_EQ(twice.names(), (std::vector<std::string>{"v", "v [km/h]", "[m]", "a[m]"}));
  EXPECT_EQ(twice.units(), (std::vector<std::string>{"m/s", "", "", ""}));
}

TEST(csv, reads_files_of_other_programs) {
  const table run =
      read("\xEF\xBB\xBF t , \"q1\" ,u1\r\n 0 , +1.5e3,NaN \r\n\"-.5\",INF,-infinity\r\n\r\n\n \t\n");
  ASSERT_TRUE(run) << run.cause();
  EXPECT_EQ(run.names(), (std::vector<std::string>{"t", "q1", "u1"}));
  EXPECT_EQ(run.values(0), (std::vector<double>{0, -0.5}));
  EXPECT_EQ(run.values(1), (std::vector<double>{1500, infinite}));
  EXPECT_TRUE(std::isnan(run["u1"][0]));
  EXPECT_EQ(run["u1"][1], -infinite);
}

TEST(csv, reads_a_last_line_without_its_end) {
  const table run = read("t\n1\n2");
  ASSERT_TRUE(run) << run.cause();
  EXPECT_EQ(run.values(0), (std::vector<double>{1, 2}));
}

TEST(csv, reads_a_header_without_rows) {
  const table run = read("t,q1\n");
  ASSERT_TRUE(run) << run.cause();
  EXPECT_EQ(run.columns(), 2u);
  EXPECT_EQ(run.rows(), 0u);
}

TEST(csv, reports_mistakes_with_their_position) {
  const auto expect_refused = [](const std::string& text, const std::string& cause) {
    const table run = read(text);
    EXPECT_FALSE(run) << text;
    EXPECT_EQ(run.cause(), cause);
    EXPECT_EQ(run.columns(), 0u);
  };
  expect_refused("", "run.csv is empty");
  expect_refused("\r\n \n", "run.csv is empty");
  expect_refused("t,q1\n1,2\n3,abc\n", "line 3 of run.csv: 'abc' in column q1 is not a number");
  expect_refused("t,q1\n1,2 3\n", "line 2 of run.csv: '2 3' in column q1 is not a number");
  expect_refused("t,q1\n,2\n", "line 2 of run.csv: '' in column t is not a number");
  expect_refused("t,q1\n1,\n", "line 2 of run.csv: '' in column q1 is not a number");
  expect_refused("t,q1\n1,0x10\n", "line 2 of run.csv: '0x10' in column q1 is not a number");
  expect_refused("t,q1\n1,+-2\n", "line 2 of run.csv: '+-2' in column q1 is not a number");
  expect_refused("t,q1\n1,1e999\n",
                 "line 2 of run.csv: '1e999' in column q1 is too large or too small for a double");
  expect_refused("a,b,c,d,e\n1,2,3,4,5\n1,2,3,4\n", "line 3 of run.csv has 4 fields; expected 5");
  expect_refused("a,b\n1\n", "line 2 of run.csv has 1 field; expected 2");
  expect_refused("a,b\n1,2,\n", "line 2 of run.csv has 3 fields; expected 2");
  expect_refused("a,b\n1,2\n\n3,4\n", "line 3 of run.csv is empty");
  expect_refused("\n\na,b\n1,2\n", "line 1 of run.csv is empty");
  expect_refused("t,q1,t\n", "line 1 of run.csv is not a header: column t already exists");
  expect_refused("t,,u1\n", "line 1 of run.csv is not a header: a column has no name");
  expect_refused("1,2\n3,4\n",
                 "line 1 of run.csv contains numbers; it must contain the names of the columns");
  expect_refused("nan\n", "line 1 of run.csv contains numbers; it must contain the names of the columns");
  expect_refused("t;q1\n0,5;1,5\n", "line 1 of run.csv uses semicolons as separators; it must use commas");
  expect_refused("1;2\n3;4\n", "line 1 of run.csv uses semicolons as separators; it must use commas");
  expect_refused("t\tq1\n1\t2\n", "line 1 of run.csv uses tabs as separators; it must use commas");
  expect_refused("t,\"q1\n1,2\n", "line 1 of run.csv opens a quote that is not closed");
  expect_refused("t,\"q\"1\n", "line 1 of run.csv has text after a closing quote");
  expect_refused("\"two\nlines\",b\n1,2\n1,x\n", "line 4 of run.csv: 'x' in column b is not a number");
}

// Lines that end with a carriage return, as old Macintosh programs wrote them, would be read as one line.
TEST(csv, rejects_lone_carriage_returns) {
  for (const char* text : {"t,q1\r0,1\r2,3\r", "t\r0\r1", "\"t\",\"q1\"\r0,1", "\"t\",\"q1\"\r,1",
                           "t,\r0,1\n", "t,q1\r\"0\",1\n"})
    EXPECT_EQ(read(text).cause(),
              "line 1 of run.csv contains a carriage return; lines must end with LF or CR LF")
        << text;
  EXPECT_EQ(read("t\n0\r1\n").cause(),
            "line 2 of run.csv contains a carriage return; lines must end with LF or CR LF");
  EXPECT_TRUE(read("t,q1\r\r\n0,1\r\n2,3\r"));
  EXPECT_EQ(read("\"two\r\nlines\"\r\n1\r\n").names()[0], "two\r\nlines");
}

TEST(csv, reads_the_byte_order_mark_of_utf_8) {
  const std::string mark = "\xEF\xBB\xBF";
  for (const char* text : {"t\n1\n", "\"t\"\r\n1\r\n"}) {
    const table run = read(mark + text);
    ASSERT_TRUE(run) << run.cause();
    EXPECT_EQ(run.names()[0], "t");
    EXPECT_EQ(run.values(0), std::vector<double>{1});
  }
  EXPECT_EQ(read(mark).cause(), "run.csv is empty");
  EXPECT_EQ(read(mark + "\r\n").cause(), "run.csv is empty");
  table marked;
  EXPECT_TRUE(marked.add(mark + "t", {1}));
  EXPECT_EQ(read(written(marked)).names(), marked.names());
}

TEST(csv, rejects_utf_16) {
  const auto in_utf_16 = [](const std::string& text, bool small_end_first) {
    std::string wide;
    for (const char c : text)
      for (const char half : {small_end_first ? c : '\0', small_end_first ? '\0' : c}) wide += half;
    return wide;
  };
  for (const bool small_end_first : {true, false}) {
    const std::string mark = small_end_first ? "\xFF\xFE" : "\xFE\xFF",
                      text = in_utf_16("t\n1\n", small_end_first);
    EXPECT_EQ(read(mark + text).cause(), "line 1 of run.csv is not UTF-8 but UTF-16 or UTF-32");
    EXPECT_EQ(read(text).cause(), "line 1 of run.csv contains a zero byte: it is not text in UTF-8");
  }
  EXPECT_EQ(read(std::string("t\n1\n\0\n", 6)).cause(),
            "line 3 of run.csv contains a zero byte: it is not text in UTF-8");
}

TEST(csv, names_a_stream_without_a_name) {
  std::istringstream empty, wrong("t\nx\n"), failed("t\n1\n");
  EXPECT_EQ(read_csv(empty).cause(), "the stream is empty");
  EXPECT_EQ(read_csv(wrong).cause(), "line 2: 'x' in column t is not a number");
  failed.setstate(std::ios::failbit);
  EXPECT_EQ(read_csv(failed).cause(), "the stream cannot be read");
}

TEST(csv, writes_and_reads_files) {
  const std::string path = in_directory_of_tests("kanexpr_csv_test.csv");
  table run;
  EXPECT_TRUE(run.add("t", {0, 0.1}));
  const outcome done = write_csv(run, path);
  ASSERT_TRUE(done) << done.cause();
  const table again = read_csv(path);
  ASSERT_TRUE(again) << again.cause();
  EXPECT_EQ(again.values(0), run.values(0));
  std::filesystem::remove(path);
  EXPECT_EQ(read_csv(path).cause(), path + " cannot be opened: No such file or directory");
  EXPECT_EQ(write_csv(read_csv(path), path).cause(), path + " cannot be opened: No such file or directory");
  EXPECT_FALSE(std::filesystem::exists(path));
  const std::string nowhere = path + "/of/nothing.csv";
  EXPECT_EQ(write_csv(run, nowhere).cause(), nowhere + " cannot be opened: No such file or directory");
  EXPECT_EQ(read_csv(testing::TempDir()).cause(), testing::TempDir() + " cannot be read");
}

TEST(csv, reports_a_full_disk) {
  table run;
  EXPECT_TRUE(run.add("t", std::vector<double>(100, 0.1)));
  EXPECT_EQ(write_csv(run, "/dev/full").cause(), "writing /dev/full failed after row 100");
  table more;
  EXPECT_TRUE(more.add("t", std::vector<double>(100000, 0.1)));
  const outcome done = write_csv(more, "/dev/full");
  EXPECT_FALSE(done);
  EXPECT_TRUE(done.cause().starts_with("writing /dev/full failed at row ")) << done.cause();
}

// Numbers with a decimal comma and groups of digits, as in some locales.
struct foreign : std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(csv, does_not_depend_on_the_locale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new foreign));
  table run;
  EXPECT_TRUE(run.add("t", {1234567.25, 0.5}));
  const std::string text = written(run);
  const table again = read(text);
  std::locale::global(before);
  EXPECT_EQ(text, "t\n1234567.25\n0.5\n");
  EXPECT_TRUE(again) << again.cause();
}

TEST(csv_writer, streams_rows) {
  std::ostringstream out;
  csv_writer writer(out, {"t", "q,1"});
  EXPECT_EQ(out.str(), "t,\"q,1\"\n");
  EXPECT_TRUE(writer.row({0, 0.1}));
  EXPECT_EQ(out.str(), "t,\"q,1\"\n0,0.1\n");
  EXPECT_TRUE(writer.row(std::vector<double>{1, 2.5}));
  EXPECT_TRUE(writer.finish());
  EXPECT_TRUE(writer);
  EXPECT_EQ(writer.cause(), "");
  EXPECT_EQ(out.str(), "t,\"q,1\"\n0,0.1\n1,2.5\n");
}

TEST(csv_writer, rejects_a_row_of_wrong_length_and_later_rows) {
  std::ostringstream out;
  csv_writer writer(out, {"t", "q1"});
  EXPECT_TRUE(writer.row({0, 1}));
  EXPECT_FALSE(writer.row({3}));
  EXPECT_EQ(writer.cause(), "row 2 has 1 number, but the header has 2 names");
  EXPECT_FALSE(writer.row({4, 5}));
  EXPECT_FALSE(writer.finish());
  EXPECT_FALSE(writer);
  EXPECT_EQ(writer.cause(), "row 2 has 1 number, but the header has 2 names");
  EXPECT_EQ(out.str(), "t,q1\n0,1\n");
}

// A table that could not be read.
TEST(csv_writer, rejects_an_invalid_header) {
  std::ostringstream out;
  csv_writer doubled(out, {"t", "q", "t"}), nameless(out, {"t", ""});
  EXPECT_EQ(doubled.cause(), "column t already exists");
  EXPECT_FALSE(doubled.row({0, 1, 2}));
  EXPECT_EQ(nameless.cause(), "a column has no name");
  EXPECT_EQ(out.str(), "");
}

TEST(csv_writer, reports_a_failed_stream) {
  std::ostringstream out;
  csv_writer writer(out, {"t"}, "run.csv");
  EXPECT_TRUE(writer.row({0}));
  out.setstate(std::ios::badbit);
  EXPECT_FALSE(writer.row({1}));
  EXPECT_EQ(writer.cause(), "writing run.csv failed at row 2");
  out.clear();
  EXPECT_FALSE(writer.row({2})); // it is gone
  EXPECT_EQ(out.str(), "t\n0\n");
  out.setstate(std::ios::failbit);
  EXPECT_EQ(csv_writer(out, {"t"}).cause(), "writing the stream failed at the header");
}

} // namespace
