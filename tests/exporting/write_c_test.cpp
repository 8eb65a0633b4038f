// builds: clang++
// Exports of builders, and refused exports.
#include <kanexpr/export.hpp>
#include <kanexpr/fmi.hpp>
#include <kanexpr/runtime/builder.hpp>

#include <models/pendulum_nonminimal.hpp>
#include <models/simple_pendulum.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <vector>

#include <sys/resource.h>

namespace {

using namespace kanexpr;
using namespace exporting;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A folder that is removed after the test.
struct folder {
  std::filesystem::path path = std::filesystem::temp_directory_path() / "kanexpr_write_c_test";
  folder() { std::filesystem::remove_all(path); }
  ~folder() { std::filesystem::remove_all(path); }

  std::string text_of(const std::string& file) const {
    std::ostringstream all;
    all << std::ifstream(path / file).rdbuf();
    return all.str();
  }
};

std::string cause_of(const std::string& name, const c_options& chosen) {
  const folder to;
  const outcome written = write_c<simple_pendulum::System>(to.path, name, chosen);
  EXPECT_FALSE(written);
  EXPECT_FALSE(std::filesystem::exists(to.path)) << "something is left";
  return written.cause();
}

c_options with(std::vector<requested_function> functions) { return {.functions = std::move(functions)}; }

TEST(WriteC, DerivesTheSystemOnce) {
  int derivations = 0;
  runtime::staged_derivation derivation([&] {
    ++derivations;
    return derive<simple_pendulum::System>();
  });
  EXPECT_EQ(exporter("arm", derivation, {}).run().system.functions.size(), default_results().size());
  EXPECT_EQ(derivations, 1);
}

TEST(WriteC, DividesOnlyLongFunctions) {
  const folder to;
  ASSERT_TRUE(write_c<simple_pendulum::System>(to.path, "whole"));
  ASSERT_TRUE(write_c<simple_pendulum::System>(to.path, "divided", {.lengths = {.longest = 8, .piece = 4}}));
  EXPECT_THAT(to.text_of("whole.c"), Not(HasSubstr("piece")));
  EXPECT_THAT(to.text_of("divided.c"),
              HasSubstr("divided_PIECE void divided_explicit_form_piece_2(double t"));
}

TEST(WriteC, NamesWhatCannotBeExported) {
  EXPECT_THAT(cause_of("arm", with({results("velocity")})),
              AllOf(StartsWith("there is no result velocity; expected mass_matrix, forcing, "),
                    HasSubstr(", explicit_form, jacobian or implicit_form, or a step, runge_kutta_4, "),
                    Not(HasSubstr("hessian"))));
  EXPECT_THAT(cause_of("arm", with({results("udot speeds")})), StartsWith("there is no result speeds; "));
  EXPECT_EQ(cause_of("arm", with({results("udot runge_kutta_4")})),
            "runge_kutta_4 is a separate function and cannot be combined with other results");
  EXPECT_EQ(cause_of("arm", with({fixed_step("step", {"runge_kutta_4", -1})})),
            "the number of corrections of a step must be at least 0");
  EXPECT_EQ(cause_of("arm", with({fixed_step("step", {"heun_2"})})),
            "unknown step method heun_2; expected runge_kutta_4, ralston_3 or semi_implicit_euler");
  EXPECT_EQ(cause_of("arm", with({results(" ")})), "a function must have at least one result");
  EXPECT_EQ(cause_of("arm", {.lengths = {.piece = 0}}),
            "functions must be allowed to have at least one line");
  EXPECT_EQ(cause_of("arm", with({results("multipliers")})), "multipliers of arm has no entries");
  EXPECT_EQ(cause_of("arm", {.bound = {{"k", 1}}}), "there is no parameter k to bind to a number");
  EXPECT_EQ(cause_of("arm", {.bound = {{"m", std::numeric_limits<double>::infinity()}}}),
            "parameter m must be bound to a finite number");
  EXPECT_EQ(cause_of("arm", {.bound = {{"m", 1}, {"m", 2}}}), "parameter m is bound twice");
  EXPECT_EQ(cause_of("arm", {.bound = {{"m", -1}}}), "parameter m, the mass of a body, is negative");
  c_options huge{.functions = {results("mass_matrix")}, .bound = {{"m", 1e308}, {"l", 1e308}}};
  EXPECT_EQ(cause_of("arm", huge), "function mass_matrix contains a number that double cannot represent");
  huge = {
      .functions = {results("mass_matrix")}, .bound = {{"m", 1e308}}, .number = precision::single_precision};
  EXPECT_EQ(cause_of("arm", huge), "function mass_matrix contains a number that float cannot represent");
  const std::vector<bound_parameter> tiny{{"l", 1}, {"c", 1e-46}}, denormal{{"c", 1e-45}};
  EXPECT_EQ(cause_of("arm", {.bound = tiny, .number = precision::single_precision}),
            "parameter c is bound to a number that is 0 in float");
  EXPECT_TRUE(write_c<simple_pendulum::System>(folder().path, "arm", {.bound = tiny}));
  EXPECT_TRUE(write_c<simple_pendulum::System>(folder().path, "arm",
                                               {.bound = denormal, .number = precision::single_precision}));
  EXPECT_EQ(cause_of("math", {}), "the name of an exported system must be a C identifier of letters, digits "
                                  "and underscores; \"math\" is not one");
  EXPECT_EQ(cause_of("7 arms", {}), "the name of an exported system must be a C identifier of letters, "
                                    "digits and underscores; \"7 arms\" is not one");
  EXPECT_EQ(cause_of("", {}), "the name of an exported system must be a C identifier of letters, digits and "
                              "underscores; \"\" is not one");
}

TEST(WriteC, LeavesNothingHalfWritten) {
  const folder to;
  std::filesystem::create_directories(to.path / "arm.c"); // a folder in place of the file
  const outcome written = write_c<simple_pendulum::System>(to.path, "arm");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.cause(), (to.path / "arm.c").string() + " cannot be written");
  EXPECT_FALSE(std::filesystem::exists(to.path / "arm.h"));
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(to.path), {}), 1) << "something is left";
  EXPECT_EQ(write_c<simple_pendulum::System>("/proc/none/of/these", "arm").cause(),
            "/proc/none/of/these/arm.h cannot be written");
}

TEST(WriteC, LeavesFilesOfNamesLikeItsOwn) {
  const folder to;
  std::filesystem::create_directories(to.path);
  std::ofstream(to.path / "arm.c.1.part") << "of the user";
  ASSERT_TRUE(write_c<simple_pendulum::System>(to.path, "arm"));
  EXPECT_EQ(to.text_of("arm.c.1.part"), "of the user");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(to.path), {}), 3) << "something is left";
}

TEST(WriteC, TakesBackWhatItReplacedWhereTheNextFileCannotBe) {
  const folder to;
  std::filesystem::create_directories(to.path);
  const file_text first{to.path / "arm.h", "new"}, second{to.path / "arm.c", "new"};
  std::ofstream(first.path) << "before";
  exporting::detail::file_transaction changes;
  ASSERT_TRUE(changes.write(first) && changes.write(second));
  std::filesystem::remove(to.path / "arm.c.1.part");
  EXPECT_TRUE(changes.move_into_place(0, first.path));
  EXPECT_EQ(to.text_of("arm.h"), "new");
  EXPECT_FALSE(changes.move_into_place(1, second.path));
  changes.roll_back();
  EXPECT_EQ(to.text_of("arm.h"), "before");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(to.path), {}), 1) << "something is left";
}

/// Limits the size of files, as on a full disk.
struct full_disk {
  rlimit before{};
  full_disk() {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit now{.rlim_cur = 1000, .rlim_max = before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &now);
  }
  ~full_disk() { setrlimit(RLIMIT_FSIZE, &before); }
};

TEST(WriteC, LeavesWhatWasThereWhereTheDiskIsFull) {
  const folder to;
  const auto write = [&](const char* below, const char* results_of) {
    return write_c<simple_pendulum::System>(to.path / below, "arm", with({results(results_of)}));
  };
  ASSERT_TRUE(write("", "udot"));
  const std::string before = to.text_of("arm.h") + to.text_of("arm.c");
  std::string cause, in_new_folder;
  {
    const full_disk here;
    cause = write("", "rhs").cause();
    in_new_folder = write("a/b", "rhs").cause();
  }
  EXPECT_EQ(cause, (to.path / "arm.h").string() + " cannot be written");
  EXPECT_EQ(in_new_folder, (to.path / "a/b/arm.h").string() + " cannot be written");
  EXPECT_EQ(to.text_of("arm.h") + to.text_of("arm.c"), before);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(to.path), {}), 2) << "something is left";
}

namespace without_list {
using namespace simple_pendulum;
struct System : kane_system<inertial<N>, coordinates<q>, speeds<u>, kinematics<simple>, bodies<Bob>,
                            loads<torque<A, T * N::z>>> {};
} // namespace without_list

TEST(WriteC, RefusesAnInputThatTheSystemDoesNotHave) {
  const c_options pushed = with({exporting::expression<simple_pendulum::q * input<"F">{}>("pushed")});
  EXPECT_EQ(cause_of("arm", pushed), "input F, which an expression contains, is not in the list of inputs");
  EXPECT_EQ(write_c<without_list::System>("nowhere", "arm", pushed).cause(),
            "function pushed uses an input that the system does not have");
  EXPECT_FALSE(std::filesystem::exists("nowhere"));
}

TEST(WriteC, CountsTheOperationsOfAStep) {
  const folder to;
  ASSERT_TRUE(write_c<simple_pendulum::System>(to.path, "arm", with({results("runge_kutta_4")})));
  const std::string all = to.text_of("arm.c");
  const std::size_t begin = all.find("arm_runge_kutta_4(");
  const std::string code = all.substr(begin, all.find("(void)t", begin) - begin);
  const auto times = [&](const std::string& what) {
    std::size_t count = 0;
    for (std::size_t at = 0; (at = code.find(what, at)) != code.npos; ++at) ++count;
    return count;
  };
  const std::size_t turns = times("_sine_and_cosine(");
  EXPECT_EQ(turns, 4);
  std::ostringstream told;
  told << "/* " << times(" * ") << " multiplications, " << times(" + ") + times(" - ") << " additions, "
       << times(" / ") << " divisions, " << turns << " sines and cosines or the like, 0 other functions.";
  EXPECT_THAT(to.text_of("arm.h"), HasSubstr(told.str()));
}

TEST(WriteC, ExportsExpressionsByNamesOfTheirOwn) {
  using namespace simple_pendulum;
  const folder to;
  const outcome written =
      write_c<System>(to.path, "arm", with({exporting::expression<position_of<P, O>>("tip")}));
  ASSERT_TRUE(written) << written.cause();
  EXPECT_THAT(to.text_of("arm.h"), HasSubstr("arm_tip_rows = 3,"));
  EXPECT_THAT(to.text_of("arm.c"), HasSubstr("tip[0] = "));
}

TEST(WriteC, TakesWhatABuilderBuilt) {
  runtime::builder b("N");
  const auto angle = b.coordinate("int"), rate = b.speed("ω"), g = b.parameter("g");
  b.kinematic_equation(b.dot(angle) - rate);
  const auto N = b.inertial_frame();
  const auto A = b.rotated("A", N, angle, b.along(N, 0, 0, 1));
  const auto P = b.offset("P", b.origin("O"), b.along(A, 2, 0, 0));
  b.particle("Bob", P, b.number(3));
  b.gravity(b.along(N, g, 0, 0));
  const auto exponent = b.parameter("exp"), rows = b.parameter("udot_rows"), end = b.parameter("a*/b");
  b.force(P, b.along(N, exponent * rate, 1 + rows * 2, end));
  const folder to;
  ASSERT_TRUE(write_c(b, to.path, "pendulum", with({results("udot")})));
  const std::string header = to.text_of("pendulum.h"), code = to.text_of("pendulum.c");
  EXPECT_THAT(header, HasSubstr("   ω is called u03c9 here.\n"));
  EXPECT_THAT(header, HasSubstr("  pendulum_int = 0,\n  pendulum_u03c9 = 1,\n  pendulum_g = 0,\n"));
  EXPECT_THAT(header, HasSubstr("   a* b is called a__b here.\n")) << "in one comment";
  EXPECT_THAT(header, HasSubstr("   udot_rows is called udot_rows_ here.\n"));
  EXPECT_THAT(code, HasSubstr("  const double int_ = x[0];\n")) << "no word of the language";
  EXPECT_THAT(code, HasSubstr("  const double exp_ = p[1];\n")) << "no function of math.h";
}

TEST(WriteC, CallsNothingWhatAHeaderDefines) {
  runtime::builder b("N");
  const auto q = b.coordinate("q"), u = b.speed("u"), hoist = b.input("H"), other = b.input("HPP");
  b.kinematic_equation(b.dot(q) - u);
  const auto N = b.inertial_frame();
  const auto P = b.offset("P", b.origin("O"), b.along(N, q, 0, 0));
  b.particle("Load", P, b.parameter("errno"));
  b.force(P, b.along(N, hoist + other, 0, 0));
  const folder to;
  ASSERT_TRUE(write_c(b, to.path, "crane", {.with_cpp = true}));
  const std::string header = to.text_of("crane.h"), names = to.text_of("crane.hpp");
  EXPECT_THAT(header, HasSubstr("  crane_H = 0,\n  crane_HPP = 1,\n"));
  for (const std::string& file : {header, names})
    for (const char* taken : {"#define crane_H\n", "#define crane_HPP\n"})
      EXPECT_THAT(file, Not(HasSubstr(taken)));
  EXPECT_THAT(names, HasSubstr("  double errno_ = "));
  EXPECT_THAT(to.text_of("crane.c"), HasSubstr("const double errno_ = p[0];"));
}

/// A pendulum whose force has terms created in order, from the first or from the last, as compilers evaluate
/// operands.
std::string code_of_pendulum(const folder& to, bool from_the_first) {
  runtime::builder b("N");
  const auto q = b.coordinate("q"), u = b.speed("u"), m = b.parameter("m"), g = b.parameter("g"),
             c = b.parameter("c"), k = b.parameter("k");
  b.kinematic_equation(b.dot(q) - u);
  const auto N = b.inertial_frame();
  const auto A = b.rotated("A", N, q, b.along(N, 0, 0, 1));
  const auto P = b.offset("P", b.origin("O"), b.along(A, 2, 0, 0));
  b.particle("Bob", P, m);
  symbolic::expression force[3];
  for (int i = 0; i < 3; ++i) {
    const int term = from_the_first ? i : 2 - i;
    force[term] = term == 0 ? m * g : term == 1 ? c * u : k * sin(q);
  }
  b.force(P, b.along(N, force[0] + force[1] * force[2], force[2] + force[0], 0));
  EXPECT_TRUE(write_c(b, to.path, "once"));
  const std::string once = to.text_of("once.c");
  EXPECT_TRUE(write_c(b, to.path, "once"));
  EXPECT_EQ(to.text_of("once.c"), once) << "the same, however often it is written";
  return once;
}

TEST(WriteC, WritesTheSameInWhateverOrderABuilderWasGivenTerms) {
  const folder to;
  EXPECT_EQ(code_of_pendulum(to, true), code_of_pendulum(to, false));
}

TEST(WriteC, WritesExpressionsOfABuilder) {
  const folder to;
  runtime::builder b("N"), other("N");
  const auto q = b.coordinate("q"), u = b.speed("u"), l = b.parameter("l");
  b.kinematic_equation(b.dot(q) - u);
  const auto N = b.inertial_frame();
  const auto P = b.offset("P", b.origin("O"), b.along(b.rotated("A", N, q, b.along(N, 0, 0, 1)), l, 0, 0));
  b.particle("Bob", P, b.number(3));
  const auto written = [&](const requested_function& wanted) {
    return write_c(b, to.path, "arm", with({wanted}));
  };
  ASSERT_TRUE(written(exporting::expression("height", l * cos(q))));
  EXPECT_THAT(to.text_of("arm.c"), HasSubstr("arm_height("));
  EXPECT_EQ(written(exporting::expression("turn", other.coordinate("turn"))).cause(),
            "turn is not an expression of the exported system");
}

struct doubled {
  template <class T>
  T operator()(const T& x) const {
    return 2 * x;
  }
};

TEST(WriteC, RefusesFunctionsOfTheProgram) {
  runtime::builder b("N");
  const auto q = b.coordinate("q"), u = b.speed("u");
  b.kinematic_equation(b.dot(q) - u);
  const auto N = b.inertial_frame();
  const auto P = b.offset("P", b.origin("O"), b.along(N, q, 0, 0));
  b.particle("Bob", P, b.number(3));
  b.force(P, b.along(N, external<"spring", doubled>()(q), 0, 0));
  const folder to;
  EXPECT_EQ(write_c(b, to.path, "arm", with({results("udot")})).cause(),
            "function udot calls spring, a function of the program, which cannot be exported");
}

TEST(WriteC, TellsTheMistakeOfAModel) {
  runtime::builder b("N");
  const auto q = b.coordinate("q"), u = b.speed("u");
  b.inertial_frame();
  b.kinematic_equation(b.dot(q) - 2 * u);
  const folder to;
  EXPECT_EQ(write_c(b, to.path, "arm").cause(), derive(b).mistake());
  EXPECT_NE(derive(b).mistake(), "");
}

std::string cause_for_casadi(const std::string& name, const casadi_options& chosen = {}) {
  const folder to;
  const outcome written = write_casadi<simple_pendulum::System>(to.path, name, chosen);
  EXPECT_FALSE(written);
  EXPECT_FALSE(std::filesystem::exists(to.path)) << "something is left";
  return written.cause();
}

TEST(WriteCasadi, NamesWhatCannotBeExported) {
  for (const char* const name : {"_arm", "arm_", "arm__1", "7arms", "", "jac", "while", "main", "sinl",
                                 "sinf64x", "double_t", "M_PI_2", "abs", "memcpy", "wcsxfrm", "link"})
    EXPECT_EQ(
        cause_for_casadi(name),
        std::string(
            "the name of a CasADi function must begin with a letter, must not contain two consecutive "
            "underscores or end with one, and must not be a reserved name in C, its library or CasADi; \"") +
            name + "\" is not a valid name");
  EXPECT_EQ(cause_for_casadi("arm", {{{"k", 1}}}), "there is no parameter k to bind to a number");
  EXPECT_EQ(cause_for_casadi("arm", {{{"m", 1e300}, {"l", 1e300}}}),
            "function rates contains a number that double cannot represent");
}

TEST(WriteCasadi, TellsTheMistakeOfAModel) {
  runtime::builder b("N");
  const auto q = b.coordinate("q"), u = b.speed("u");
  b.inertial_frame();
  b.kinematic_equation(b.dot(q) - 2 * u);
  const folder to;
  EXPECT_EQ(write_casadi(b, to.path, "arm").cause(), derive(b).mistake());
}

/// A function with a dense result, 1, a sparse result with one entry, 2 or 3, and the value for a check, 4.
exported_function with_entry_at(int row, int column, int value) {
  exported_function f;
  f.results = {{"dense", 1, 1, 0}, {"sparse", 2, 2, 1}};
  f.results[1].is_sparse = true;
  f.results[1].places = {{column, row}};
  for (const int number : {1, value, 4})
    f.code.results.push(f.code.lines.push({.a = f.code.numbers.push(symbolic::exactly(number))}));
  return f;
}

TEST(CommonShapes, PutsZerosWhereTheOtherHasAnEntry) {
  exported_function one = with_entry_at(0, 1, 2), other = with_entry_at(1, 0, 3);
  common_shapes::unify(one, other);
  const auto values = [](const exported_function& f) {
    std::vector<double> all;
    for (const int line : f.code.results) all.push_back(f.code.numbers[f.code.lines[line].a].value());
    return all;
  };
  EXPECT_EQ(values(one), (std::vector<double>{1, 0, 2, 4}));
  EXPECT_EQ(values(other), (std::vector<double>{1, 3, 0, 4}));
  for (const exported_function& f : {one, other}) {
    EXPECT_EQ(f.results[1].places, (std::vector<std::pair<int, int>>{{0, 1}, {1, 0}}));
  }
}

TEST(WriteCasadi, LeavesNothingHalfWritten) {
  const folder to;
  std::filesystem::create_directories(to.path / "arm_casadi.c"); // a folder in place of the file
  const outcome written = write_casadi<simple_pendulum::System>(to.path, "arm");
  ASSERT_FALSE(written);
  EXPECT_EQ(written.cause(), (to.path / "arm_casadi.c").string() + " cannot be written");
  EXPECT_FALSE(std::filesystem::exists(to.path / "arm_casadi.h"));
  std::ofstream(to.path / "file") << "no folder";
  const std::filesystem::path below = to.path / "file" / "models";
  EXPECT_EQ(write_casadi<simple_pendulum::System>(below, "arm").cause(),
            (below / "arm_casadi.h").string() + " cannot be written");
}

fmu_options with_starts() {
  return {.start = {{"q", 0.3}, {"m", 2}, {"l", 0.5}, {"g", 9.81}, {"c", 0.1}}, .compiler = ""};
}

/// Returns the reason why there is no FMU of a pendulum with options modified by `change`.
template <class Change>
std::string cause_of_fmu(const Change& change, const std::string& name = "arm") {
  const folder to;
  fmu_options chosen = with_starts();
  change(chosen);
  const written_fmu written = write_fmu<simple_pendulum::System>(to.path, name, chosen);
  EXPECT_FALSE(written);
  EXPECT_FALSE(std::filesystem::exists(to.path)) << "something is left";
  return written.cause();
}

TEST(WriteFmu, StartsNoSpeedThatTheConstraintsGive) {
  const folder to;
  const auto of = [&](const char* speed) {
    const fmu_options chosen{.start = {{"m", 1}, {"L", 1}, {"g", 9.81}, {"q1", 1}, {speed, 3}},
                             .compiler = ""};
    return std::string(write_fmu<pendulum_nonminimal::System>(to.path, "bob", chosen).cause());
  };
  EXPECT_EQ(of("u2"), "");
  EXPECT_EQ(of("u1"), "speed u1 is dependent and cannot have a start value; it follows from the constraints");
}

TEST(WriteFmu, NamesWhatCannotBeExported) {
  using simple_pendulum::q, simple_pendulum::u;
  const auto of = [](auto change) { return cause_of_fmu(change); };
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(of([](fmu_options& o) { o.start.pop_back(); }), "parameter c has no start value");
  EXPECT_EQ(of([&](fmu_options& o) { o.start[0].value = none; }), "the start value of q is not finite");
  EXPECT_EQ(of([](fmu_options& o) { o.start.push_back({"q", 1}); }), "q has two start values");
  EXPECT_EQ(of([](fmu_options& o) { o.start[1].value = -1; }),
            "parameter m, the mass of a body, is negative");
  EXPECT_EQ(of([](fmu_options& o) { o.start.erase(o.start.begin() + 1), o.bound = {{"m", -1}}; }),
            "parameter m, the mass of a body, is negative");
  EXPECT_EQ(of([](fmu_options& o) { o.start.push_back({"k", 1}); }),
            "there is no coordinate, speed, parameter or input k to set a start value for");
  EXPECT_EQ(of([](fmu_options& o) { o.step = 0; }), "the internal step of a co-simulation must be positive");
  EXPECT_THAT(of([](fmu_options& o) { o.outputs = {results("velocity")}; }),
              StartsWith("there is no result velocity; "));
  EXPECT_EQ(of([](fmu_options& o) { o.outputs = {results("runge_kutta_4")}; }),
            "runge_kutta_4 is a step and cannot be an output");
  EXPECT_EQ(of([](fmu_options& o) { o.outputs = {expression<q>("")}; }), "an output of an FMU needs a name");
  EXPECT_EQ(of([](fmu_options& o) { o.events = {when<q>("")}; }), "an event of an FMU needs a name");
  EXPECT_EQ(of([](fmu_options& o) {
              o.events = {when<position_of<simple_pendulum::P, simple_pendulum::O>>("fall")};
            }),
            "the expression of event fall must be a scalar");
  EXPECT_EQ(of([](fmu_options& o) { o.events = {when<q>("turn", crossing::either, {set<-u>("m")})}; }),
            "event turn sets m, which is neither a coordinate nor a speed");
  EXPECT_EQ(of([](fmu_options& o) {
              o.bound = {{"m", 1e308}, {"l", 1e308}}, o.start.erase(o.start.begin() + 1, o.start.begin() + 3);
            }),
            "function rhs contains a number that double cannot represent");
  EXPECT_EQ(cause_of_fmu([](fmu_options&) {}, "7 arms"),
            "the name of an exported system must be a C identifier of letters, digits and underscores; \"7 "
            "arms\" is not one");
  EXPECT_EQ(of([](fmu_options& o) { o.compiler = "false"; }),
            "arm does not compile as C; false reports the errors");
}

TEST(WriteFmu, SaysWhyThereIsNoLibrary) {
  const folder to;
  fmu_options chosen = with_starts();
  EXPECT_EQ(write_fmu<simple_pendulum::System>(to.path, "arm", chosen).note(),
            "arm.fmu contains only sources, because no compiler is specified");
  const std::string without = to.text_of("arm.fmu");
  EXPECT_THAT(without, HasSubstr("sources/arm_fmi.c"));
  EXPECT_THAT(without, Not(HasSubstr("binaries/")));
  chosen.compiler = "no-compiler-of-this-name";
  const written_fmu again = write_fmu<simple_pendulum::System>(to.path, "arm", chosen);
  EXPECT_TRUE(again);
  EXPECT_EQ(again.note(),
            "arm.fmu contains only sources, because there is no compiler no-compiler-of-this-name");
  EXPECT_EQ(to.text_of("arm.fmu"), without) << "the same bytes";
}

TEST(WriteFmu, LeavesNothingHalfWritten) {
  const folder to;
  std::filesystem::create_directories(to.path / "arm.fmu"); // a folder in place of the file
  const written_fmu written = write_fmu<simple_pendulum::System>(to.path, "arm", with_starts());
  EXPECT_EQ(written.cause(), (to.path / "arm.fmu").string() + " cannot be written");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(to.path), {}), 1) << "something is left";
  EXPECT_EQ(write_fmu<simple_pendulum::System>("/proc/none/of/these", "arm", with_starts()).cause(),
            "/proc/none/of/these/arm.fmu cannot be written");
}

} // namespace
