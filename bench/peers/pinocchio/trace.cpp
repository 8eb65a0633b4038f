// Traces Pinocchio's algorithms with CppADCodeGen and writes them as C: trace MODEL DIRECTORY.
//
// Each result is traced in every way that its algorithm comes in; whoever reads the files takes the shortest.
#include <pinocchio/codegen/cppadcg.hpp>

#include "read_model.hpp"

#include <pinocchio/algorithm/aba-derivatives.hpp>
#include <pinocchio/algorithm/aba.hpp>
#include <pinocchio/algorithm/crba.hpp>
#include <pinocchio/algorithm/rnea.hpp>

#include <algorithm>
#include <iostream>
#include <sstream>

namespace {

using generated = CppAD::cg::CG<double>;
using traced = CppAD::AD<generated>;
using vector = Eigen::Matrix<traced, Eigen::Dynamic, 1>;
using matrix = Eigen::Matrix<traced, Eigen::Dynamic, Eigen::Dynamic>;
using model = pinocchio::ModelTpl<traced, 0>;
using data = pinocchio::DataTpl<traced, 0>;
using pinocchio::Convention;

class tracer {
public:
  tracer(const peers::robot& of, std::string folder)
      : model_(of.model.cast<traced>()), inputs_(of.inputs), folder_(std::move(folder)) {}

  void write_all() {
    for (const auto& [way, convention] :
         {std::pair("local", Convention::LOCAL), std::pair("world", Convention::WORLD)}) {
      write("mass_matrix_and_forcing", way,
            [&](data& d, const vector& q, const vector& v, const vector& torque) {
              return mass_matrix_and_forcing(d, q, v, torque, convention);
            });
      write("udot", way, [&](data& d, const vector& q, const vector& v, const vector& torque) {
        return vector(pinocchio::aba(model_, d, q, v, torque, convention));
      });
    }
    write("udot_derivatives", "analytical",
          [&](data& d, const vector& q, const vector& v, const vector& torque) {
            return udot_derivatives(d, q, v, torque);
          });
    // The derivatives that CppAD makes of the trace are by the coordinates, of which a link that floats has
    // more than speeds.
    if (model_.nq == model_.nv) write_differentiated();
  }

private:
  vector mass_matrix_and_forcing(data& d, const vector& q, const vector& v, const vector& torque,
                                 Convention convention) const {
    const int n = model_.nv;
    vector result(n * n + n);
    pinocchio::crba(model_, d, q, convention);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) result(i * n + j) = d.M(std::min(i, j), std::max(i, j));
    result.tail(n) = torque - pinocchio::nonLinearEffects(model_, d, q, v);
    return result;
  }

  vector udot_derivatives(data& d, const vector& q, const vector& v, const vector& torque) const {
    const int n = model_.nv, columns = 2 * n + inputs_;
    matrix by_q = matrix::Zero(n, n), by_v = by_q, by_torque = by_q;
    pinocchio::computeABADerivatives(model_, d, q, v, torque, by_q, by_v, by_torque);
    matrix all(n, columns);
    all << by_q, by_v, by_torque.rightCols(inputs_);
    return Eigen::Map<vector>(all.data(), n * columns);
  }

  template <class Function>
  CppAD::ADFun<generated> trace(const Function& function) const {
    vector x = vector::Constant(model_.nq + model_.nv + inputs_, traced(generated(0.1)));
    CppAD::Independent(x);
    vector torque = vector::Zero(model_.nv);
    torque.tail(inputs_) = x.tail(inputs_);
    data d(model_);
    vector result = function(d, vector(x.head(model_.nq)), vector(x.segment(model_.nq, model_.nv)), torque);
    CppAD::ADFun<generated> done(x, result);
    done.optimize("no_compare_op");
    return done;
  }

  template <class Function>
  void write(const std::string& result, const std::string& way, const Function& function) const {
    CppAD::ADFun<generated> traced_function = trace(function);
    CppAD::cg::CodeHandler<double> handler;
    std::vector<generated> x(traced_function.Domain());
    handler.makeVariables(x);
    write_code(result, way, handler, traced_function.Forward(0, x));
  }

  /// By one reverse pass for each speed.
  void write_differentiated() const {
    CppAD::ADFun<generated> udot =
        trace([&](data& d, const vector& q, const vector& v, const vector& torque) {
          return vector(pinocchio::aba(model_, d, q, v, torque, Convention::LOCAL));
        });
    CppAD::cg::CodeHandler<double> handler;
    std::vector<generated> x(udot.Domain());
    handler.makeVariables(x);
    udot.Forward(0, x);
    std::vector<generated> all(udot.Range() * udot.Domain());
    for (std::size_t i = 0; i < udot.Range(); ++i) {
      std::vector<generated> weight(udot.Range(), generated(0));
      weight[i] = 1;
      const std::vector<generated> row = udot.Reverse(1, weight);
      for (std::size_t j = 0; j < row.size(); ++j) all[j * udot.Range() + i] = row[j];
    }
    write_code("udot_derivatives", "reverse", handler, all);
  }

  void write_code(const std::string& result, const std::string& way, CppAD::cg::CodeHandler<double>& handler,
                  std::vector<generated> entries) const {
    CppAD::cg::LanguageC<double> c("double");
    c.setParameterPrecision(17);
    CppAD::cg::LangCDefaultVariableNameGenerator<double> names;
    std::ostringstream body;
    handler.generateCode(body, c, entries, names);
    std::ofstream(folder_ + "/" + result + "." + way + ".c")
        << "#include <math.h>\n\nvoid " << result << "(const double* x, double* y) {\n   double v["
        << std::max<std::size_t>(1, handler.getTemporaryVariableCount()) << "];\n"
        << body.str() << "}\n";
  }

  model model_;
  int inputs_;
  std::string folder_;
};

} // namespace

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  tracer(peers::read_model(argv[1]), argv[2]).write_all();
}
