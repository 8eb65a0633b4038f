"""Compiles, measures what that takes, and does not do it twice."""

import hashlib
import json
import os
import shlex
import subprocess
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path


@dataclass
class Built:
    path: str
    seconds: float  # of user time
    megabytes: float  # that the compiler had at most
    code: int  # bytes of machine code and constants


def fingerprint(*parts):
    found = hashlib.sha256()
    for part in parts:
        found.update(str(part).encode() + b"\0")
    return found.hexdigest()[:20]


def contents(files):
    return fingerprint(*(Path(file).read_text() for file in files))


def run_measured(command):
    """Seconds of user time and megabytes. What compilers say of the peers' headers is shown where they fail only."""
    with tempfile.TemporaryFile("w+") as told:
        child = subprocess.Popen(command, stdout=told, stderr=told)
        _, status, used = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
        if child.returncode != 0:
            told.seek(0)
            raise RuntimeError(f"{told.read()}\nthis failed: {shlex.join(map(str, command))}")
    return used.ru_utime, used.ru_maxrss / 1024


def code_size(path):
    line = subprocess.run(["size", path], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()[1]
    return int(line.split()[0])


class Shop:
    """Where things are built: a folder, in which each thing has a name that comes from all that it is made of."""

    def __init__(self, folder, nice=()):
        self.folder = Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.nice = list(nice)
        self.versions = {}

    def version(self, compiler):
        if compiler not in self.versions:
            told = subprocess.run([compiler, "--version"], check=True, stdout=subprocess.PIPE, text=True).stdout
            self.versions[compiler] = told.splitlines()[0]
        return self.versions[compiler]

    def build(self, compiler, source, flags, uses=(), link=None):
        """`link`: None makes a library for timing of the one source; else what a program is linked with. `uses` are
        files that the source includes."""
        key = fingerprint(self.version(compiler), *flags, *(link or ["library"]), contents([source, *uses]))
        path = self.folder / f"{Path(source).stem}-{key}{'.so' if link is None else ''}"
        record = path.with_suffix(".json")
        if record.exists():
            return Built(**json.loads(record.read_text()) | {"path": str(path)})  # the folder may have moved
        object_file = path.with_suffix(".o")
        seconds, megabytes = run_measured(
            [*self.nice, compiler, *flags, "-fPIC", "-c", source, "-o", object_file])
        end = ["-shared"] if link is None else link
        run_measured([*self.nice, compiler, object_file, "-o", path, *end])
        built = Built(str(path), seconds, megabytes, code_size(object_file))
        object_file.unlink()
        record.write_text(json.dumps(asdict(built)))
        return built
