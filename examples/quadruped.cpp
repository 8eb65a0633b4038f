// A quadruped on a floating base; the reference is RBDL, which expresses the base's velocity in ground axes.
#include "print.hpp"

#include <models/quadruped.hpp>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

int main() {
  using namespace quadruped;
  using eom = kanexpr::equations_of_motion<System>;
  using vector = Eigen::Vector<double, 18>;

  eom::state x;
  x[px] = -0.7174568735924263;
  x[py] = -0.8898136829921139;
  x[pz] = 0.6650459610628916;
  x[e1] = 0.5206792542564865;
  x[e2] = -0.5082871887879222;
  x[e3] = 0.5969225562178881;
  x[e0] = 0.33796554525466405;
  x.q().tail<12>() << 2.517738178124571, -1.5258208543091696, 1.3691417961375265, 1.6068934446631091,
      0.6043719341025695, -0.6443692139995397, -1.2030495544330748, 2.0870754368210696, -1.2314718711627841,
      3.1118218332226255, 3.101711568755657, 2.303054519164141;
  const Eigen::Matrix3d R = Eigen::Quaterniond(x[e0], x[e1], x[e2], x[e3]).toRotationMatrix();
  x.u().head<3>() =
      R.transpose() * Eigen::Vector3d(-0.9295545463277721, -1.827115098690923, -1.3251036898270434);
  x[w1] = 0.6678589286861074;
  x[w2] = -1.9287503124690268;
  x[w3] = -0.2642819108755661;
  x.u().tail<12>() << -0.8812734457018523, -1.424485190057887, -0.6035148508406605, -0.6774013055201693,
      1.862333913162331, 0.24761649080168802, -1.8847494843870443, -0.8754707419343639, 1.158165532931286,
      -1.1283790590761023, -1.4927414550439089, 0.7746321343040856;

  // A force on the base in ground axes, a torque on it in its own axes, and the motors.
  const Eigen::Vector3d force =
      R.transpose() * Eigen::Vector3d(-4.1536102078199875, -7.5263821324586715, -3.3813444387841574);
  const Eigen::Vector3d torque(0.0013042583539979447, 4.061801993969412, 3.387307415330214);
  const eom::inputs motors{{5.696326026741401, 1.8955518400348637, 1.400915936984597, 3.091221828990036,
                            0.9838417537688793, -4.064540842506956, -8.273926585144013, -8.078894187256898,
                            -3.9836701520778153, 3.4110042550157593, -8.35675690093429, 2.3944561787093654}};

  const auto [M, f] = eom::together(eom::mass_matrix, eom::forcing)(x, eom::parameters(), motors);
  vector all = f;
  all.head<3>() += force;
  all.segment<3>(3) += torque;
  vector udot = M.ldlt().solve(all);
  udot.head<3>() = R * (udot.head<3>() + x.u().segment<3>(3).cross(x.u().head<3>()));

  print("udot", udot);
}
