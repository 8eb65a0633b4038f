"""MuJoCo, by the parts of its forward dynamics that concern trees without contacts."""

from pathlib import Path

from build import contents, fingerprint
from peer import CXX, HERE, RESULTS, Offer, Without, symbol

AXES = ["1 0 0", "0 1 0", "0 0 1"]


def words(numbers):
    return " ".join(f"{n:.17g}" for n in numbers)


def body(model, i):
    """A link and those on it. Their inertias follow: MJCF takes only those of real bodies, and robots have others."""
    link = model.links[i]
    x, y = ([row[column] for row in link.home] for column in (0, 1))
    joint = '<freejoint/>' if link.axis < 0 else f'<joint name="j{i}" type="hinge" axis="{AXES[link.axis]}"/>'
    inside = "".join(body(model, k) for k, other in enumerate(model.links) if other.parent == i)
    return (f'<body name="b{i}" pos="{words(link.joint)}" xyaxes="{words(x)} {words(y)}">{joint}'
            f'<inertial pos="{words(link.centre)}" mass="{link.mass:.17g}" diaginertia="1 1 1"/>{inside}</body>')


def write(model, path):
    import mujoco
    import numpy

    motors = "".join(f'<motor joint="j{i}"/>' for i in range(len(model.links) - model.inputs, len(model.links)))
    roots = "".join(body(model, i) for i, link in enumerate(model.links) if link.parent < 0)
    compiled = mujoco.MjModel.from_xml_string(
        f'<mujoco><option gravity="{words(model.gravity)}"/><compiler angle="radian"/>'
        f'<worldbody>{roots}</worldbody><actuator>{motors}</actuator></mujoco>')
    for i, link in enumerate(model.links):
        moments, axes = numpy.linalg.eigh(numpy.array(link.inertia))
        axes *= numpy.sign(numpy.linalg.det(axes))
        compiled.body_inertia[i + 1] = moments
        mujoco.mju_mat2Quat(compiled.body_iquat[i + 1], axes.flatten())
    compiled.body_sameframe[:] = 0
    compiled.body_simple[:] = 0
    compiled.dof_simplenum[:] = 0
    mujoco.mj_setConst(compiled, mujoco.MjData(compiled))
    mujoco.mj_saveModel(compiled, str(path))


def free_state(x):
    """The base's quaternion begins with e0, and its velocity is along the axes of the ground."""
    from agreement import rotation, times
    return [*x[0:3], x[6], *x[3:6], *x[7:19], *times(rotation(x), x[19:22]), *x[22:]]


class Algorithms:
    name = "MuJoCo"

    def offers(self, model, shop, models):
        if not model.is_tree:
            return Without("its constraints are soft")
        import mujoco
        folder = Path(mujoco.__file__).parent
        library = next(folder.glob("libmujoco.so.*"))
        built = shop.build("g++", HERE / "mujoco/algorithms.cpp", [*CXX, "-isystem", f"{folder}/include"],
                           [HERE / "requirements.txt"], link=["-shared", str(library), f"-Wl,-rpath,{folder}"])
        path = models / f"{model.name}.mjb"
        write(model, path)
        return {result: Offer(symbol(built.path, result, load=path), state_of=free_state if model.floats else None,
                              form="ground" if model.floats else "kanexpr")
                for result in RESULTS if result != "udot_derivatives"}
