#include "animate/disc_on_a_circle.hpp"
#include "animate/swept_shapes.hpp"
#include "animate/wedge_files.hpp"

#include <kanexpr/animate.hpp>

#include <cstdio>

// page DIRECTORY: writes a page with a shape of every kind, and the placements of its shapes at some times; a
// page with two runs; one with files that contain no mesh; and two with sweeps and cables.

namespace {

using namespace rolling_disc;

struct Above : offset<Above, Dmc, 0.5 * N::z> {};
struct Beside : offset<Beside, Dmc, 0.4 * L::y> {};

using shapes = kanexpr::picture<
    System, up<N::z>, ground<>, carried<Dmc>, seen_from<N::x - N::y + N::z / 2>, trace<C, colour<"#2f5d8a">>,
    show_forces<"N">, show_velocities<"m/s">, show_frames, plot_energies<"J">, in_unit<"rad", q1, q2, q3>,
    plot<"height of Dmc", dot(position_of<Dmc, C>, N::z), "m">,
    show<arrow<Dmc, angular_velocity_of<R>>, named<"angular velocity">, unit<"rad/s">,
         layer<"Angular velocities">>,
    show<wheel<R, Dmc, R::y, r, r / 10>>, show<cylinder<R, Dmc, R::y, r / 3, r / 3>>,
    show<ring<R, Beside, R::x, r / 4, r / 15>>, show<cone<R, Above, -N::z, r / 6, r / 2>>,
    show<box<R, Beside, r / 5, r / 6, r / 7>>, show<ellipsoid<R, Above, r / 4, r / 6, r / 8>, opacity<0.6>>,
    show<sphere<Dmc, r / 5>>, show<axes<R, Dmc, r>>, show<rod<Dmc, Beside, r / 20>>,
    show<coil<Dmc, Above, r / 8, 7>>, show<cable<r / 30, C, Dmc, Beside, Above>>,
    show<sweep<tapered<airfoil<r / 3, r / 20>, airfoil<r / 6, r / 30>>, station<R, Dmc, R::z>,
               station<L, Beside, L::y>>>,
    show<mesh<R, Beside, "binary.STL", r / 10>, named<"binary STL">>,
    show<mesh<L, Beside, "text.stl", 0.03, 0.05, -0.04>, named<"mirrored STL">>,
    show<mesh<R, Above, "wedge.obj", 0.04>, named<"OBJ">, colour<"#ffffff">>,
    show<mesh<R, Dmc, "wedge.dae", 0.04>, named<"DAE">, opacity<0.5>>,
    show<mesh<L, Dmc, "wedge.dae", 0.05>, named<"the same DAE">>>;

/// The corners of a mesh, in inertial axes.
nlohmann::json corners_of(const kanexpr::animation::shape& s, std::size_t k) {
  const Eigen::Matrix3d scale = Eigen::Vector3d(s.sizes.data()).asDiagonal();
  nlohmann::json all = nlohmann::json::array();
  for (const wedge::corner& c : wedge::corners) {
    const Eigen::Vector3d at =
        s.placements[k].position + s.placements[k].orientation * scale * Eigen::Vector3d(c[0], c[1], c[2]);
    all.push_back({at(0), at(1), at(2)});
  }
  return all;
}

nlohmann::json poses_at(const kanexpr::animation& a, std::size_t k) {
  nlohmann::json poses = nlohmann::json::array();
  for (const auto& s : a.shapes) {
    if (s.kind == "trace") continue;
    const Eigen::Vector3d& p = s.placement_at(k).position;
    const Eigen::Matrix3d& r = s.placement_at(k).orientation;
    nlohmann::json one{{"name", s.name}, {"position", {p(0), p(1), p(2)}}};
    if (s.placed_by == kanexpr::animate::placement_kind::pose && s.places == 1)
      one["axes"] = {{r(0, 0), r(1, 0), r(2, 0)}, {r(0, 1), r(1, 1), r(2, 1)}, {r(0, 2), r(1, 2), r(2, 2)}};
    if (s.kind == "mesh") one["corners"] = corners_of(s, k);
    if (const Eigen::Vector3d& v = s.placement_at(k).end; s.kind == "arrow")
      one["vector"] = {v(0), v(1), v(2)};
    poses.push_back(one);
  }
  nlohmann::json columns;
  for (const auto& c : a.columns) columns[c.name] = c.values[k];
  return {{"t", a.times[k]}, {"columns", columns}, {"poses", poses}};
}

/// A green wedge among invalid meshes.
kanexpr::outcome write_broken(kanexpr::animation a, const kanexpr::page_options& options,
                              const std::string& directory) {
  std::vector<kanexpr::animation::shape> shown(1 + std::size(wedge::broken), *a.find("DAE"));
  shown[0].file = "green.dae";
  shown[0].opacity = 1;
  for (std::size_t i = 1; i < shown.size(); ++i) shown[i].file = shown[i].name = wedge::broken[i - 1];
  a.shapes = shown;
  a.ground.reset();
  return kanexpr::animate::write_page(directory + "/broken.html", a, options);
}

} // namespace

int main(int, char** arguments) {
  const std::string directory = arguments[1];
  wedge::write(directory);
  const tests::disc_on_a_circle closed_form;
  const tests::known_motion<System, tests::disc_on_a_circle> run(closed_form.parameters(), closed_form, 300,
                                                                 0.02);
  const auto report = kanexpr::write_page<shapes>(directory + "/disc.html", run,
                                                  {.title = "A disc <on a circle> & @motion@</script>",
                                                   .text = "A shape of every kind.",
                                                   .folder = directory});
  if (!report) return std::fprintf(stderr, "%s\n", report.cause().c_str()), 1;

  const tests::disc_on_a_circle other{.lean = -0.2, .turning = -0.5, .spin = 3};
  const tests::known_motion<System, tests::disc_on_a_circle> to_the_right(other.parameters(), other, 200,
                                                                          0.02);
  const kanexpr::animation a = kanexpr::animated<shapes>(run);
  const auto both = kanexpr::write_page(
      directory + "/runs.html",
      {{"leans to the left", a}, {"leans to the right", kanexpr::animated<shapes>(to_the_right)}},
      {.title = "Two discs", .folder = directory});
  if (!both) return std::fprintf(stderr, "%s\n", both.cause().c_str()), 1;

  const auto broken = write_broken(a, {.title = "Broken files", .folder = directory}, directory);
  if (!broken) return std::fprintf(stderr, "%s\n", broken.cause().c_str()), 1;
  const tests::swept_shapes swept;
  const auto bent =
      kanexpr::animate::write_page(directory + "/swept.html", swept.animation, {.title = "Bent shapes"});
  if (!bent) return std::fprintf(stderr, "%s\n", bent.cause().c_str()), 1;
  std::ofstream(directory + "/swept.json") << swept.expected;
  const kanexpr::animation beam = tests::bent_beam();
  const auto turning = kanexpr::animate::write_page(directory + "/beam.html", beam, {.title = "A bent beam"});
  if (!turning) return std::fprintf(stderr, "%s\n", turning.cause().c_str()), 1;
  std::ofstream(directory + "/beam.json")
      << nlohmann::json{poses_at(beam, 0), poses_at(beam, 17), poses_at(beam, 40)};
  std::ofstream(directory + "/disc.json")
      << nlohmann::json{poses_at(a, 0), poses_at(a, 70), poses_at(a, 300)};
}
