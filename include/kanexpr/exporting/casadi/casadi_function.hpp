#pragma once

#include <kanexpr/exporting/casadi/sparsity.hpp>
#include <kanexpr/exporting/text/fill_template.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace kanexpr::exporting {

/// An input or output of a function.
struct casadi_port {
  std::string name{};
  casadi_sparsity shape{};
};

/// A function in a shared library with the names and shapes that CasADi queries.
struct casadi_function {
  std::string name{};
  std::vector<casadi_port> in{}, out{};
  int scratch = 0;    ///< number of entries of `w`
  std::string body{}; ///< code in terms of `arg`, `res` and `w`; returns nonzero if there is no result

  /// `library` is the prefix of the names that all functions share.
  std::string text(const std::string& library) const {
    return fill_template(R"(
static int @name@_found(const double **arg, double **res, double *w) {
@body@}
int @name@(const double **arg, double **res, long long *iw, double *w, int mem) {
  static const int entries[] = {@entries@};
  (void)iw;
  (void)mem;
  return @name@_found(arg, res, w) || !@library@_are_finite(res, @n_out@, entries);
}
long long @name@_n_in(void) { return @n_in@; }
long long @name@_n_out(void) { return @n_out@; }
const char *@name@_name_in(long long i) {
  static const char *const names[] = {@names_in@};
  return 0 <= i && i < @n_in@ ? names[i] : 0;
}
const char *@name@_name_out(long long i) {
  static const char *const names[] = {@names_out@};
  return 0 <= i && i < @n_out@ ? names[i] : 0;
}
const long long *@name@_sparsity_in(long long i) {
@shapes_in@
  return 0 <= i && i < @n_in@ ? shapes + begin[i] : 0;
}
const long long *@name@_sparsity_out(long long i) {
@shapes_out@
  return 0 <= i && i < @n_out@ ? shapes + begin[i] : 0;
}
int @name@_work(long long *arg, long long *res, long long *iw, long long *w) {
  if (arg) *arg = @n_in@;
  if (res) *res = @n_out@;
  if (iw) *iw = 0;
  if (w) *w = @scratch@;
  return 0;
}
)",
                         {{"name", name},
                          {"library", library},
                          {"body", body},
                          {"entries", listed(entries())},
                          {"n_in", std::to_string(in.size())},
                          {"n_out", std::to_string(out.size())},
                          {"names_in", names(in)},
                          {"names_out", names(out)},
                          {"shapes_in", shapes(in)},
                          {"shapes_out", shapes(out)},
                          {"scratch", std::to_string(scratch)}});
  }

  static std::string listed(const std::vector<int>& numbers) {
    std::string all;
    for (int each : numbers) all += (all.empty() ? "" : ", ") + std::to_string(each);
    return all;
  }

private:
  std::vector<int> entries() const {
    std::vector<int> counts;
    counts.reserve(out.size());
    for (const casadi_port& each : out) counts.push_back(each.shape.entries());
    return counts;
  }

  static std::string names(const std::vector<casadi_port>& ports) {
    std::string all;
    for (const casadi_port& each : ports) all += (all.empty() ? "\"" : ", \"") + each.name + '"';
    return all;
  }

  static std::string shapes(const std::vector<casadi_port>& ports) {
    std::string begins, numbers;
    int begin = 0;
    for (const casadi_port& each : ports) {
      begins += (begins.empty() ? "" : ", ") + std::to_string(begin);
      numbers += (numbers.empty() ? "" : ",\n    ") + listed(each.shape.numbers());
      begin += static_cast<int>(each.shape.numbers().size());
    }
    return "  static const int begin[] = {" + begins + "};\n  static const long long shapes[] = {\n    " +
           numbers + "};";
  }
};

} // namespace kanexpr::exporting
