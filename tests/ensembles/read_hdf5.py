"""Runs the guide's code for reading and plotting: read_hdf5.py SNIPPETS FILE, with a file written by hdf5_test.cpp."""

import os
import pathlib
import sys
import tempfile

import h5py
import numpy

snippets, path = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    os.symlink(path, "study.h5")
    shown = {}
    exec((snippets / "read_files.python").read_text(), shown)
    try:
        import matplotlib
    except ImportError:
        print("there is no matplotlib to plot with")
    else:
        matplotlib.use("Agg")
        exec((snippets / "plot_files.python").read_text(), shown)
        assert pathlib.Path("study.png").stat().st_size > 1000
    os.chdir("/")

runs, units = shown["runs"], shown["units"]
assert runs.dtype.names == ("run", "end", "t_end", "push", "q", 'u/ω "fast"')
assert (runs["run"] == numpy.arange(1000)).all() and (runs["push"] == 0.25 * runs["run"]).all()
assert units["push"] == "N s" and units['u/ω "fast"'] == "°/s"
assert (numpy.isnan(runs["q"]) == (runs["end"] == 2)).all() and len(shown["ended"]) == 857
with h5py.File(path, "r") as file:
    assert file["failures"][2]["cause"].decode() == "run 17 fell"
    assert file["failures"][1]["cause"].decode().endswith("xxx…")
    assert list(file["events"].attrs["names"]) == ["falls over", 'touches/ground, "hard" ü']
    assert file["samples"].dtype.names == ("run_", "t", "q", "run")
    assert file.attrs["constants"].dtype.names == ("m", 'g"') and file.attrs["constants"].tolist() == (2.5, -9.81)
    assert list(file.attrs["units_of_constants"]) == ["kg", ""]
