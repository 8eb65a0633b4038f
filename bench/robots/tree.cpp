// A robot as the peers read it (bench/peers/pinocchio/read_model.hpp): tree FILE fixed|floating prints its
// links. A joint about a negative axis is counted the other way round. Prismatic joints and odd axes are not
// known there.
#include <kanexpr/robots/articulation.hpp>
#include <kanexpr/robots/read_urdf.hpp>

#include <iostream>
#include <string>

namespace {

using namespace kanexpr::robots;

int axis_of(const joint& j) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(j.axis[static_cast<std::size_t>(i)]) == 1) return i;
  return -2;
}

void print(const vector3& v) { std::cout << ' ' << v[0] << ' ' << v[1] << ' ' << v[2]; }

void print_link(const moving_body& b, int parent, int axis) {
  const inertia_matrix& i = b.inertia;
  std::cout << "link " << parent << ' ' << axis << ' ' << b.mass;
  print(b.center), print({i.xx, i.yy, i.zz}), print({i.xy, i.yz, i.zx});
  for (const vector3& row : b.origin.orientation) print(row);
  print(b.origin.position);
  std::cout << '\n';
}

} // namespace

int main(int count, char** arguments) {
  if (count != 3) return std::cerr << "tree FILE fixed|floating\n", 2;
  const read_robot read = read_urdf(arguments[1]);
  if (!read) return std::cerr << read.cause() << '\n', 1;
  const articulation a = articulation_of(read.robot);
  const int floats = std::string(arguments[2]) == "floating", joints = static_cast<int>(a.joints.size());
  std::cout.precision(17);
  std::cout << "gravity 0 0 -9.81\ninputs " << joints << "\ncoordinates " << joints + 7 * floats
            << "\nspeeds " << joints + 6 * floats << '\n';
  if (floats) print_link(a.bodies[0], -1, -1);
  for (const moving_body& b : a.bodies) {
    if (b.joint < 0) continue;
    const joint& j = read.robot.joints[static_cast<std::size_t>(b.joint)];
    const int axis = axis_of(j);
    if (axis < 0 || j.mimic || (j.kind != joint_kind::revolute && j.kind != joint_kind::continuous))
      return std::cerr << "joint " << j.name << " is not known to the peers\n", 1;
    print_link(b, b.parent - 1 + floats, axis);
  }
}
