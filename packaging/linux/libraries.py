# SPDX-License-Identifier: MIT
"""What programs load, and what it takes to carry it along: for the wheels and for the portable archive."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

# Every Linux that is not older has these, and a second copy of them in a process would be a fault.
SYSTEM = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|util|pthread|resolv|gcc_s|stdc\+\+)\.so\.\d+)$")


def want_tools(*programs):
    """Ends with a hint where one is missing."""
    missing = [program for program in programs if not shutil.which(program)]
    if missing:
        sys.exit(f"{os.path.basename(sys.argv[0])} needs {', '.join(missing)}: apt-get install patchelf binutils")


def said(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def libraries_of(paths):
    """Everything they load, directly or not, by name: where it is."""
    found = {}
    for path in paths:
        loaded = said("ldd", str(path))
        for name, place in re.findall(r"^\s*(\S+) => (\S+) \(", loaded, re.MULTILINE):
            if not SYSTEM.match(name):
                found[name] = os.path.realpath(place)
        missing = re.findall(r"^\s*(\S+) => not found", loaded, re.MULTILINE)
        if missing:
            sys.exit(f"{path} wants {', '.join(missing)}, which this system has not")
    return found


def newest_symbols(prefix, paths):
    """The newest version of these symbols that any of them wants: newest_symbols("GLIBC", ...) is (2, 36)."""
    newest = (0,)
    for path in paths:
        for version in re.findall(rf"\b{prefix}_(\d+(?:\.\d+)+)\b", said("objdump", "-T", str(path))):
            newest = max(newest, tuple(int(part) for part in version.split(".")))
    return newest


def packages_of(places):
    """The Debian package each of these files is of, and its version."""
    owner = {}
    # By name: a library may be recorded under /lib and be found under /usr/lib, which are one folder. Out of dpkg's
    # lists, each read once: dpkg-query goes through all of them for each name.
    names = {os.path.basename(place) for place in places}
    for listed in sorted(pathlib.Path("/var/lib/dpkg/info").glob("*.list")):
        for path in listed.read_text(encoding="utf-8", errors="replace").splitlines():
            if path.rpartition("/")[2] in names:
                owner.setdefault(os.path.realpath(path), listed.stem.partition(":")[0])
    lost = [place for place in places if place not in owner]
    if lost:
        sys.exit(f"No package has {', '.join(lost)}: whose licence it is under cannot be told")
    version = dict(line.split("\t") for line in
                   said("dpkg-query", "-W", "-f", "${Package}\t${Version}\n", *sorted(set(owner.values()))).splitlines())
    return {place: (owner[place], version[owner[place]]) for place in places}


def take_licences(places, folder):
    """Copies into the folder what the licence of each of these files is, and a list of what is from which package.

    places  by the name they are given: where they are on this system
    """
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True)
    packages = packages_of(sorted(set(places.values())))
    lines = []
    for name, place in sorted(places.items()):
        package, version = packages[place]
        shutil.copy(f"/usr/share/doc/{package}/copyright", folder / f"{package}.txt")
        lines.append(f"{name}  {package} {version}\n")
    (folder / "LIST").write_text(
        "From Debian, which has their sources: apt-get source PACKAGE, or https://snapshot.debian.org\n\n" +
        "".join(lines), encoding="utf-8")
