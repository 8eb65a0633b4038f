#!/usr/bin/env python3
"""Draws the joints of docs/guide/joints.md: draw.py writes one SVG for each beside itself.

The parent is grey, the child blue, axes are dashed, and arrows show what is free.
"""
import math
import pathlib

PARENT, CHILD, FREE, AXIS = "#8a8f98", "#3b7dd8", "#d1495b", "#777777"


def project(x, y, z):
    """An axonometric view: x to the lower left, y to the right, z up."""
    return 80 + 30 * (0.92 * y - 0.55 * x), 66 + 30 * (0.42 * x + 0.18 * y - 0.95 * z)


class Drawing:
    def __init__(self):
        self.parts = []

    def path(self, points, color, width=2, close=False, fill="none", dash=None, head=False):
        where = " L".join(f"{u:.1f} {v:.1f}" for u, v in (project(*p) for p in points))
        self.parts.append(
            f'<path d="M{where}{" Z" if close else ""}" stroke="{color}" stroke-width="{width}" fill="{fill}"'
            + (f' stroke-dasharray="{dash}"' if dash else "")
            + (f' marker-end="url(#head)"' if head else "")
            + ' stroke-linejoin="round" stroke-linecap="round"/>')

    def axis(self, a, b):
        self.path([a, b], AXIS, 1, dash="7 3 1.5 3")

    def arrow(self, a, b):
        self.path([a, b], FREE, 1.8, head=True)

    def turn(self, center, normal, radius, start=-150, end=110):
        """An arrow round an axis, x, y or z."""
        ring = []
        for i in range(41):
            t = math.radians(start + (end - start) * i / 40)
            c, s = radius * math.cos(t), radius * math.sin(t)
            offset = {"x": (0, c, s), "y": (s, 0, c), "z": (c, s, 0)}[normal]
            ring.append(tuple(p + q for p, q in zip(center, offset)))
        self.path(ring, FREE, 1.8, head=True)

    def box(self, low, high, color):
        (a, b, c), (d, e, f) = low, high
        for face in ([(d, b, c), (d, e, c), (d, e, f), (d, b, f)], [(a, e, c), (d, e, c), (d, e, f), (a, e, f)],
                     [(a, b, f), (d, b, f), (d, e, f), (a, e, f)]):
            self.path(face, color, 1.4, close=True, fill=color + "55")

    def disc(self, center, normal, radius, color):
        ring = []
        for i in range(48):
            c, s = radius * math.cos(i * math.pi / 24), radius * math.sin(i * math.pi / 24)
            offset = {"x": (0, c, s), "y": (s, 0, c), "z": (c, s, 0)}[normal]
            ring.append(tuple(p + q for p, q in zip(center, offset)))
        self.path(ring, color, 1.6, close=True, fill=color + "55")

    def ball(self, center, radius, color):
        u, v = project(*center)
        self.parts.append(f'<circle cx="{u:.1f}" cy="{v:.1f}" r="{30 * radius:.1f}" stroke="{color}" '
                          f'stroke-width="1.6" fill="{color}55"/>')

    def text(self, title):
        return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 160 130" width="160" height="130" role="img">'
                f'<title>{title}</title><defs><marker id="head" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="5.5" '
                f'markerHeight="5.5" orient="auto"><path d="M0 0 L8 4 L0 8 Z" fill="{FREE}"/></marker></defs>\n'
                + "\n".join(self.parts) + "\n</svg>\n")


def pin(d):
    d.box((-0.3, -1.9, -0.3), (0.3, -0.5, 0.3), PARENT)
    d.axis((0, 0, -1.5), (0, 0, 1.6))
    d.disc((0, 0, -0.3), "z", 0.5, PARENT)
    d.disc((0, 0, 0.3), "z", 0.5, CHILD)
    d.box((-0.25, 0.4, -0.25), (0.25, 2.1, 0.25), CHILD)
    d.turn((0, 0, 1.0), "z", 0.55)


def prismatic(d):
    d.axis((0, -2.3, 0), (0, 2.5, 0))
    d.box((-0.5, -1.6, -0.5), (0.5, 0.1, 0.5), PARENT)
    d.box((-0.25, 0.1, -0.25), (0.25, 1.8, 0.25), CHILD)
    d.arrow((0, 0.7, 0.8), (0, 2.0, 0.8))


def cylindrical(d):
    d.axis((0, -2.3, 0), (0, 2.5, 0))
    d.disc((0, -1.6, 0), "y", 0.55, PARENT)
    d.path([(0, -1.6, 0.55), (0, 0, 0.55)], PARENT)
    d.path([(0, -1.6, -0.55), (0, 0, -0.55)], PARENT)
    d.disc((0, 0, 0), "y", 0.55, PARENT)
    d.path([(0, 0, 0.28), (0, 1.8, 0.28)], CHILD)
    d.path([(0, 0, -0.28), (0, 1.8, -0.28)], CHILD)
    d.disc((0, 1.8, 0), "y", 0.28, CHILD)
    d.turn((0, 1.1, 0), "y", 0.75)
    d.arrow((0, 0.9, 1.1), (0, 2.1, 1.1))


def screw(d):
    d.axis((0, -2.3, 0), (0, 2.5, 0))
    d.box((-0.6, -1.2, -0.6), (0.6, -0.1, 0.6), PARENT)
    helix = []
    for i in range(160):
        t = i / 159 * 5 * 2 * math.pi
        helix.append((0.32 * math.sin(t), -0.1 + 2.0 * i / 159, 0.32 * math.cos(t)))
    d.path(helix, CHILD, 1.6)
    d.turn((0, 1.2, 0), "y", 0.75)
    d.arrow((0, 0.9, 1.1), (0, 2.0, 1.1))


def universal(d):
    d.axis((0, -2.4, 0), (0, -0.2, 0))
    d.box((-0.2, -2.1, -0.2), (0.2, -0.9, 0.2), PARENT)
    d.path([(0, -0.9, 0.6), (0, 0, 0.6)], PARENT, 4)
    d.path([(0, -0.9, -0.6), (0, 0, -0.6)], PARENT, 4)
    d.path([(0, -0.9, 0.6), (0, -0.9, -0.6)], PARENT, 4)
    d.path([(0, 0, 0.6), (0, 0, -0.6)], "#555555", 3)
    d.path([(0.6, 0, 0), (-0.6, 0, 0)], "#555555", 3)
    d.path([(0.6, 0, 0), (0.6, 0.9, 0.25), (-0.6, 0.9, 0.25), (-0.6, 0, 0)], CHILD, 4)
    d.path([(0, 0.9, 0.25), (0, 2.1, 0.6)], CHILD, 7)
    d.turn((0, 0, 1.05), "z", 0.4)
    d.turn((1.15, 0, 0), "x", 0.4)


def planar(d):
    d.path([(-1.6, -2.0, 0), (-1.6, 2.0, 0), (1.6, 2.0, 0), (1.6, -2.0, 0)], PARENT, 1.4, close=True, fill=PARENT + "44")
    d.box((-0.5, -0.6, 0), (0.5, 0.6, 0.5), CHILD)
    d.arrow((0, 0.75, 0), (0, 1.8, 0))
    d.arrow((0.7, 0, 0), (1.55, 0, 0))
    d.turn((0, 0, 1.0), "z", 0.5)


def spherical(d):
    d.box((-0.3, -2.1, -0.3), (0.3, -0.7, 0.3), PARENT)
    d.ball((0, -0.3, 0), 0.62, PARENT)
    d.ball((0, -0.3, 0), 0.45, CHILD)
    d.path([(0, 0.1, 0.1), (0, 2.0, 0.5)], CHILD, 7)
    d.turn((0, 0, 1.05), "z", 0.42)
    d.turn((0, 1.2, 0.3), "y", 0.55)
    d.turn((1.1, -0.3, 0), "x", 0.42)


def weld(d):
    d.box((-0.4, -1.9, -0.4), (0.4, 0, 0.4), PARENT)
    d.box((-0.4, 0, -0.4), (0.4, 1.6, 0.4), CHILD)
    d.path([(0.4, 0, -0.4), (0.4, 0, 0.4), (-0.4, 0, 0.4)], "#444444", 4)


def floating(d):
    d.path([(0, -1.9, -0.9), (0.9, -1.9, -0.9)], PARENT)
    d.path([(0, -1.9, -0.9), (0, -1.0, -0.9)], PARENT)
    d.path([(0, -1.9, -0.9), (0, -1.9, 0)], PARENT)
    d.box((-0.4, 0.1, 0.1), (0.4, 1.2, 0.8), CHILD)
    d.path([(0, -1.9, -0.9), (0, 0.1, 0.1)], AXIS, 1, dash="4 3")
    d.arrow((0, 1.3, 0.4), (0, 2.2, 0.4))
    d.arrow((0, 0.6, 0.9), (0, 0.6, 1.7))
    d.arrow((0.5, 0.6, 0.4), (1.5, 0.6, 0.4))
    d.turn((0, 0.6, 1.35), "z", 0.4)


if __name__ == "__main__":
    here = pathlib.Path(__file__).parent
    for draw in (pin, prismatic, cylindrical, screw, universal, planar, spherical, weld, floating):
        drawing = Drawing()
        draw(drawing)
        (here / f"{draw.__name__}.svg").write_text(drawing.text(f"{draw.__name__} joint"))
