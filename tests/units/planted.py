#!/usr/bin/env python3
"""planted.py PROJECT FOLDER COMPILER FLAG...: the compiler finds each dimension mistake planted into the examples.

Every mistake is planted into a separate copy of a model. All copies are one file, in which each has a namespace, and the
mistakes of their models are constants of this file. A sentence must name the entity and both units. The models without
a mistake are the control. All parameters and inputs of the examples state their units.
"""
import pathlib
import re
import subprocess
import sys

# example, system, what the model states, what is planted, the entity, the unit found, the unit expected
PLANTED = [
    # offsets
    ("models/simple_pendulum.hpp", "System", "l * A::x", "l * l * A::x", "the offset of point P", "m^2", "m"),
    ("gallery/slider_crank.cpp", "System", "l / 2 * B::x", "l * l * B::x", "the offset of point G", "m^2", "m"),
    ("models/double_pendulum.hpp", "System", "d1 * A::x", "d1 * I1 * A::x", "the offset of point G1", "kg m^3", "m"),
    ("models/n_pendulum_cart.hpp", "System<2>", '"l", i, meter', '"l", i, kilogram', "the offset of point P<1>", "kg", "m"),
    ("models/rattleback.hpp", "System", "sqrt(dot(stretched, N::z))", "dot(stretched, N::z)",
     "the offset of point G", "1", "m"),
    ("models/rolling_disc_constrained.hpp", "System", "r * cos(q2)", "cos(q2)", "the offset of point Dmc", "1", "m"),
    ("models/arm3.hpp", "System", "lx<1> * B1::x", "lx<1> * Ixx<1> * B1::x", "the offset of point J2", "kg m^3", "m"),
    ("gallery/crane.cpp", "System", "-l * A::y", "-l * m2 * A::y", "the offset of point P", "kg m", "m"),
    ("gallery/kapitza.cpp", "System", "y * N::y", "l * y * N::y", "the offset of point Pivot", "m^2", "m"),
    ("motion/bouncing_ball.cpp", "System", "h + R", "h + R * R", "the offset of point Centre", "m", "m^2"),
    # angles and angular velocities
    ("models/bicycle.hpp", "System", "q4 + htangle", "q4 + WRrad", "the angle of frame Frame", "rad", "m"),
    ("models/iiwa.hpp", "System", '"q", i, radian', '"q", i, meter', "the angle of frame Link1", "m", "rad"),
    ("gallery/gyrocompass.cpp", "System", "Omega * t", "Omega", "the angle of frame E", "rad/s", "rad"),
    ("gallery/snakeboard.cpp", "System", "rotated<R, A, -phi", "rotated<R, A, l", "the angle of frame R", "m", "rad"),
    ("models/bicycle.hpp", "System", "u3 * Frame::y", "WRrad * u3 * Frame::y",
     "the angular velocity of frame WR", "m rad/s", "rad/s"),
    ("gallery/turntable.cpp", "System", "w1 * N::x", "r * w1 * N::x",
     "the angular velocity of frame B", "m rad/s", "rad/s"),
    # masses and inertias
    ("models/arm6.hpp", "System", "Link<i>, m<i>", "Link<i>, x<i>", "the mass of Body<1>", "m", "kg"),
    ("gallery/furuta.cpp", "System", "Rod, G, B, m", "Rod, G, B, m * I", "the mass of Rod", "kg^2 m^2", "kg"),
    ("gallery/spherical_pendulum.cpp", "System", "P, m>", "P, m * l>", "the mass of Bob", "kg m", "kg"),
    ("models/four_bar.hpp", "System", "0, 0, I1", "0, 0, m1", "the inertia of Crank", "kg", "kg m^2"),
    ("models/rolling_disc.hpp", "System", "m * r * r / 2", "m * r / 2", "the inertia of Disc", "kg m", "kg m^2"),
    ("models/rolling_torus.hpp", "System", "3 * a * a / 4", "3 * a / 4", "the inertia of Torus", "m^2", "m"),
    ("models/spinning_top.hpp", "System", "F2, A, A, C", "F2, A, A, C * l", "the inertia of Top", "kg m^3", "kg m^2"),
    ("gallery/roller_racer.cpp", "System", "B, 0, 0, I2", "B, 0, 0, m2", "the inertia of Bars", "kg", "kg m^2"),
    ("gallery/differential.cpp", "System", "0, J, 0", "0, cl, 0", "the inertia of Cage", "N m s/rad", "kg m^2"),
    ("gallery/tumbling_racket.cpp", "System", "F, A, B, C", "F, A, B, C * m", "the inertia of Nut", "kg^2 m^2", "kg m^2"),
    ("gallery/turntable.cpp", "System", "2 * m * r * r / 5", "2 * m * r / 5", "the inertia of Ball", "kg m", "kg m^2"),
    # gravity
    ("models/four_bar.hpp", "LagrangeSystem", "gravity<-g", "gravity<-g * l0", "gravity", "m^2/s^2", "m/s^2"),
    # forces
    ("models/n_pendulum_cart.hpp", "LagrangeSystem<2>", "F * N::x", "F * l<0> * N::x", "the force at P<0>", "N m", "N"),
    ("models/rocket.hpp", "System", "m * g", "m", "the force at P", "N", "kg"),
    ("models/rocket.hpp", "LagrangeSystem", "cd * dot(q) * dot(q)", "cd * dot(q)", "the force at P", "N", "N s/m"),
    ("models/rotating_tube.hpp", "System", "q - q0", "q - theta", "the force at P", "m", "rad"),
    ("models/rotating_tube.hpp", "System", "c * u", "k * u", "the force at P", "N", "N/s"),
    ("models/andrews.hpp", "System", "magnitude(spring)", "dot(spring, spring)", "the force at D", "m^2", "m"),
    ("gallery/foucault.cpp", "System", "-2 * m *", "-2 *", "the force at P", "m rad/s^2", "N"),
    ("gallery/stewart.cpp", "System", "F<i> * normalized(position_of<Top<i>, Foot<i>>)",
     "F<i> * position_of<Top<i>, Foot<i>>", "the force between Top<0> and Foot<0>", "N m", "N"),
    ("gallery/tippe_top.cpp", "System", "+ s * s", "+ s", "the force at P", "m^2/s^2", "m/s"),
    ("gallery/wheelset.cpp", "System", "v / V - psi", "v / V - y", "the force at G", "1", "m"),
    ("gallery/wheelset.cpp", "System", "k3 * y * y * y", "k3 * y * y", "the force at G", "N rad", "N/m"),
    ("models/chaplygin_sleigh.hpp", "System", "F * A::x", "F * a * A::x", "the force at P", "N m", "N"),
    ("gallery/quadruped.cpp", "Standing", "stiffness * softplus", "damping * softplus", "the force at LF_Foot",
     "s", "N"),
    # torques and motors
    ("models/simple_pendulum.hpp", "LagrangeSystem", "c * dot(q)", "c * q", "the torque on A", "N m", "kg m^2/s"),
    ("models/double_pendulum.hpp", "System", "c2 * (u2 - u1)", "c2 * (q2 - u1)", "the torque on A", "rad", "rad/s"),
    ("models/pivot_body.hpp", "System", "T1 * B::x", "(T1 + m * g) * B::x", "the torque on B", "N m", "N"),
    ("models/quadruped.hpp", "System", '"T", i, newton * meter', '"T", i, newton', "the torque on LF_Hip", "N", "N m"),
    ("models/puma.hpp", "System", '"T", i, newton * meter', '"T", i, watt', "the torque on Link1", "W", "N m"),
    ("gallery/satellite.cpp", "System", "T1 * B::x", "T1 * w1 * B::x",
     "the torque between W1 and B", "kg m^2 rad/s^3", "N m"),
    ("gallery/gyrocompass.cpp", "System", "-c * u", "-c * alpha", "the torque between F and E", "kg m^2/s", "N m"),
    ("controllers/balanced_bicycle.hpp", "Driven", "D * Frame::y", "D * u3 * Frame::y",
     "the torque between WR and Frame", "kg m^2 rad/s^3", "N m"),
    ("ensembles/identified_friction.cpp", "Rubbing", "-k * tanh", "-c * k * tanh",
     "the torque on A", "kg^2 m^4/(rad s^3)", "N m"),
    ("gallery/differential.cpp", "System", "-cl * left_speed", "-cl", "the torque on Left", "N m s/rad", "N m"),
    # springs and dampers
    ("../docs/guide/forces.md", "System", "spring<C, W, k, 1.0>", "spring<C, W, c, 1.0>",
     "the stiffness of the spring between C and W", "N s/m", "N/m"),
    ("../docs/guide/forces.md", "System", "spring<C, W, k, 1.0>", "spring<C, W, k, l*l>",
     "the natural length of the spring between C and W", "m^2", "m"),
    ("../docs/guide/forces.md", "System", "damper<C, W, c>", "damper<C, W, k>",
     "the damping between C and W", "N/m", "N s/m"),
    ("../docs/guide/forces.md", "System", "force<P, F*N::x>", "force<P, T*N::x>", "the force at P", "N m", "N"),
    ("../README.md", "System", "T - c*u", "T - m*g", "the torque on A", "N m", "N"),
    # flexible bodies
    ("gallery/spin_up.cpp", "System", "O, Hub::x, L", "O, Hub::x, L * L", "the length of beam Arm", "m^2", "m"),
    ("gallery/flexible_manipulator.cpp", "System", "B::x, L, rho", "B::x, L, m",
     "the mass per length of beam Lower", "kg", "kg/m"),
    ("gallery/flexible_manipulator.cpp", "System", "bending<A::y, EI,", "bending<A::y, EI * L,",
     "a stiffness of beam Upper", "N m^3", "N m^2"),
    ("gallery/wind_turbine.cpp", "System", "c*(w -", "c*(c * w -", "the force at Outer<1>", "N", "m/s"),
    # potential energies
    ("gallery/wilberforce.cpp", "System", "k * z * z", "k * z", "potential energy 1", "N", "N m rad"),
    ("gallery/wilberforce.cpp", "System", "epsilon * z * theta", "epsilon * theta", "potential energy 1", "N m", "N"),
    # kinematics and constraints
    ("models/rocket.hpp", "System", "dot(q) == u", "dot(q) == u + q", "a kinematic differential equation", "m/s", "m"),
    ("models/four_bar.hpp", "System", "dot(q2) == u2", "dot(q2) == u2 + q1",
     "a kinematic differential equation", "rad/s", "rad"),
    ("models/pendulum_nonminimal.hpp", "System", "L * L", "L", "a configuration constraint", "m^2", "m"),
    ("gallery/foucault.cpp", "System", "z * z == l * l", "z == l * l", "a configuration constraint", "m^2", "m"),
    ("gallery/constant_speed.cpp", "System", "== c * c", "== c", "a velocity constraint", "m^2/s^2", "m/s"),
    ("gallery/turntable.cpp", "System", "== Omega * x", "== Omega", "a velocity constraint", "m/s", "rad/s"),
]

# A model that extends another one
BASES = {
    "controllers/balanced_bicycle.hpp": ("models/bicycle.hpp", "SteeredSystem"),
    "gallery/quadruped.cpp": ("models/quadruped.hpp", "System"),
    "ensembles/identified_friction.cpp": ("models/simple_pendulum.hpp", "System"),
}


def model(examples, path, system):
    """The text of an example from its first symbol to its system."""
    text = (examples / path).read_text(encoding="utf-8")
    start = re.search(r"^namespace (\w*) ?\{\n", text, re.M)
    text = text[start.end():]
    end = re.search(r"^struct %s\b.*?;\n" % system.partition("<")[0], text, re.M | re.S)
    return start.group(1) or pathlib.Path(path).stem, text[:end.end()]


def namespaces(examples, path, system, stated=None, planted=None):
    """The namespaces of an example and of the model that it extends, with a mistake; and the name of its own."""
    name, text = model(examples, path, system)
    if stated:
        if stated not in text:
            sys.exit(f"{path}: {system} does not contain {stated}")
        text = planted.join(text.rsplit(stated, 1))
    base = namespaces(examples, *BASES[path])[1] if path in BASES else ""
    return name, f"{base}namespace {name} {{\n{text}}}\n"


def without_units(examples):
    """The parameters and inputs of the examples that state no unit."""
    sources = [p for p in sorted(examples.rglob("*.?pp")) if "playground" not in p.parts]
    symbol = re.compile(r'constexpr ((?:parameter|input|prescribed)<"\w+"(?:, i)?>)')
    return [f"{p}: {s} states no unit" for p in sources for s in symbol.findall(p.read_text(encoding="utf-8"))]


HEAD = """#include <kanexpr/beams.hpp>
#include <kanexpr/joints.hpp>
#include <kanexpr/kanexpr.hpp>
#include <cstdio>
#include <numbers>
#include <utility>

template <class System>
constexpr kanexpr::base::sentence mistake_of() {
  kanexpr::derivation::derived_system system(System::record);
  system.check_model();
  return system.mistake();
}
template <class System>
void print() {
  static constexpr kanexpr::base::sentence found = mistake_of<System>();
  std::printf("%.*s\\n", static_cast<int>(found.view().size()), found.view().data());
}
"""


def main():
    project, folder = map(pathlib.Path, sys.argv[1:3])
    examples = project / "examples"
    copies = [(path, system) for path, system in dict.fromkeys((p[0], p[1]) for p in PLANTED)]
    controls = len(copies)
    copies += [p[:4] for p in PLANTED]
    text, prints = HEAD, ""
    for number, copy in enumerate(copies):
        name, written = namespaces(examples, *copy)
        text += f"namespace copy_{number} {{\n{written}}}\n"
        prints += f"  print<copy_{number}::{name}::{copy[1]}>();\n"
    folder.mkdir(parents=True, exist_ok=True)
    source = folder / "planted.cpp"
    source.write_text(f"{text}int main() {{\n{prints}}}\n", encoding="utf-8")
    subprocess.run([*sys.argv[3:], source, "-o", folder / "planted"], check=True)
    found = subprocess.run([folder / "planted"], check=True, capture_output=True, text=True).stdout.splitlines()
    wrong = without_units(examples)
    wrong += [f"{path} {system}: {sentence}" for (path, system, *_), sentence in zip(copies, found[:controls]) if sentence]
    for (path, system, stated, planted, entity, *units), sentence in zip(PLANTED, found[controls:]):
        if not (sentence.startswith(entity + " ") and all(
                re.search(r"(\[| in | by )%s(\]|[,;]|$)" % re.escape(unit), sentence) for unit in units)):
            wrong.append(f"{path} {system}: {stated} -> {planted}: {sentence or 'not found'}")
    print(f"{len(PLANTED)} mistakes in {len(set(p[0] for p in PLANTED))} examples, {controls} models without one")
    sys.exit("\n".join(wrong) or None)


main()
