"""Writes what was measured: a table in docs/measured.md, between two marks, and a figure."""

import math
import platform
import subprocess
from pathlib import Path

from peer import RESULTS, ROOT

BEGIN, END = "<!-- peers: written by ./dev bench peers -->", "<!-- end of peers -->"
MODELS = {"pendulum6": "planar six-link pendulum", "puma": "Puma 560", "iiwa": "KUKA iiwa",
          "quadruped": "quadruped, 18 speeds", "bicycle": "bicycle"}
TOLERANCE = 1e-9


def with_units(value, digits=3):
    """A number as people read it: 0.123, 1.23, 12.3, 123, 1230."""
    if value == 0:
        return "0"
    places = max(0, digits - 1 - math.floor(math.log10(abs(value))))
    return f"{round(value, places):.{places}f}"


def time(cell):
    return f"{with_units(cell['ratio'])} ({with_units(cell['lower'])}–{with_units(cell['upper'])})"


def pair(cells, result):
    """Operations and time."""
    if result not in cells:
        return ["–", "–"]
    count = cells[result]["operations"]
    return ["–" if count is None else str(count), time(cells[result])]


def taken(cells):
    """Seconds and megabytes of compilers and kilobytes of code, of all results together."""
    built = [cell for cell in cells.values() if "seconds" in cell]
    if not built:
        return ["–", "–", "–"]
    return [f"{sum(c['seconds'] for c in built):.1f}", f"{max(c['megabytes'] for c in built):.0f}",
            f"{sum(c['code'] for c in built) / 1000:.1f}"]


def apart(cells):
    most = max(cell["apart"] for cell in cells.values())
    return f"{most:.0e}" if most else "0"


def as_text(model, peer, cells):
    """For those who wait."""
    words = [f"{result} {' operations, '.join(pair(cells, result))} × {cells[result]['reference']:.0f} ns"
             for result in RESULTS if result in cells]
    return f"{model}\t{peer}\t{'; '.join(words)}; {'; '.join(taken(cells))}; apart {apart(cells)}"


def table(measured):
    lines = ["| | M + f: operations | time | u̇: operations | time | ∂u̇: operations | time | compiler, s | MB | code, kB "
             "| difference |", "|---|---|---|---|---|---|---|---|---|---|---|"]
    for model, by_peer in measured.items():
        reference = next(iter(by_peer.values()))
        times = ", ".join(f"{reference[result]['reference']:.0f}" for result in RESULTS)
        lines.append(f"| **{MODELS[model]}** ({times} ns) |" + " |" * 10)
        for peer, cells in by_peer.items():
            if isinstance(cells, str):
                lines.append(f"| {peer} | {cells} |" + " |" * 9)
                continue
            entries = [entry for result in RESULTS for entry in pair(cells, result)]
            lines.append(f"| {' | '.join([peer, *entries, *taken(cells), apart(cells)])} |")
    return "\n".join(lines)


def processor():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return platform.machine()


def section(measured, tools, tracer):
    return f"""{BEGIN}
{processor()}; {'; '.join(tools)}. CppADCodeGen's tracer takes {tracer.seconds:.0f} s and {tracer.megabytes:.0f} MB
once, which is not included in the table.

{table(measured)}
{END}"""


def replaced(page, text):
    before, rest = page.split(BEGIN)
    return before + text + rest.split(END)[1]


def points(measured):
    """For the figure: a block for each peer, with lines of model, result, ratio and quartiles."""
    peers = list(dict.fromkeys(peer for by_peer in measured.values() for peer in by_peer))
    blocks = []
    for peer in peers:
        lines = [f'"{peer}"']
        for i, by_peer in enumerate(measured.values()):
            cells = by_peer.get(peer)
            if isinstance(cells, dict):
                lines += [f"{i} {RESULTS.index(result)} {cell['ratio']:.6g} {cell['lower']:.6g} {cell['upper']:.6g}"
                          for result, cell in cells.items()]
        blocks.append("\n".join(lines))
    return "\n\n\n".join(blocks) + "\n"


def packages():
    """Names and versions of the peers."""
    return [line.replace("==", " ") for line in (ROOT / "bench/peers/requirements.txt").read_text().split()]


def write(measured, tools, tracer, folder):
    """`tools`: compilers, flags and packages as people read them."""
    page = ROOT / "docs/measured.md"
    page.write_text(replaced(page.read_text(), section(measured, tools, tracer)))
    (folder / "peers.dat").write_text(points(measured))
    subprocess.run(["gnuplot", "-c", ROOT / "bench/peers/peers.gp", folder / "peers.dat", ROOT / "docs/peers.svg"],
                   check=True)


def worst(measured):
    """1 where results do not agree."""
    wrong = [(model, peer, result) for model, by_peer in measured.items() for peer, cells in by_peer.items()
             if isinstance(cells, dict) for result, cell in cells.items() if not cell["apart"] <= TOLERANCE]
    for words in wrong:
        print(f"not the same: {', '.join(words)}", flush=True)
    return 1 if wrong else 0
