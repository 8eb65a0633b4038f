"""The models as kanexpr writes them."""

from dataclasses import dataclass, field


@dataclass
class Link:
    parent: int  # -1: the ground
    axis: int  # 0, 1, 2; -1: it floats
    mass: float
    centre: list  # of mass, in the link's axes
    inertia: list  # rows, about the mass centre, in the link's axes
    home: list  # rows of the direction cosines from where the joint is at zero to the parent
    joint: list  # in the parent's axes


@dataclass
class Model:
    """A tree of links, or, of the bicycle, values by name."""
    name: str
    gravity: list = field(default_factory=list)
    inputs: int = 0  # torques of the last joints
    coordinates: int = 0
    speeds: int = 0
    links: list = field(default_factory=list)
    values: dict = field(default_factory=dict)
    operations: dict = field(default_factory=dict)  # of kanexpr, by result

    @property
    def is_tree(self):
        return bool(self.links)

    @property
    def floats(self):
        return self.is_tree and self.links[0].axis < 0


def read_link(words):
    v = [float(w) for w in words[2:]]
    xx, yy, zz, xy, yz, zx = v[4:10]
    return Link(parent=int(words[0]), axis=int(words[1]), mass=v[0], centre=v[1:4],
                inertia=[[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]],
                home=[v[10:13], v[13:16], v[16:19]], joint=v[19:22])


def read_model(path):
    model = Model(path.stem)
    for line in path.read_text().splitlines():
        what, *words = line.split()
        if what == "gravity":
            model.gravity = [float(w) for w in words]
        elif what == "link":
            model.links.append(read_link(words))
        elif what == "value":
            model.values[words[0]] = float(words[1])
        elif what in ("inputs", "coordinates", "speeds"):
            setattr(model, what, int(words[0]))
        else:
            raise ValueError(f"{path}: what is {what}?")
    for line in path.with_suffix(".operations").read_text().splitlines():
        result, count = line.split()
        model.operations[result] = int(count)
    return model


def read_states(path):
    return [[float(w) for w in line.split()] for line in path.read_text().splitlines()]
