# SPDX-License-Identifier: MIT
"""Finds the libraries loaded by programs and their licences, for the wheels and the portable archive."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

TOP = pathlib.Path(__file__).resolve().parents[2]
COMMON = pathlib.Path("/usr/share/common-licenses")
# Every newer Linux has these libraries. A second copy in the same process would cause errors.
SYSTEM = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|util|pthread|resolv|gcc_s|stdc\+\+)\.so\.\d+)$")


def want_tools(*programs):
    """Exits with a hint if one of these programs is missing."""
    missing = [program for program in programs if not shutil.which(program)]
    if missing:
        sys.exit(f"{os.path.basename(sys.argv[0])} needs {', '.join(missing)}: apt-get install patchelf binutils")


def said(*command):
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


def libraries_of(paths):
    """The path of each library that the files load, directly or indirectly, by name."""
    found = {}
    for path in paths:
        loaded = said("ldd", str(path))
        for name, place in re.findall(r"^\s*(\S+) => (\S+) \(", loaded, re.MULTILINE):
            if not SYSTEM.match(name):
                found[name] = os.path.realpath(place)
        missing = re.findall(r"^\s*(\S+) => not found", loaded, re.MULTILINE)
        if missing:
            sys.exit(f"{path} requires {', '.join(missing)}, which is not installed")
    return found


def newest_symbols(prefix, paths):
    """The newest version of these symbols that any of the files requires, e.g. (2, 36) for newest_symbols("GLIBC", ...)."""
    newest = (0,)
    for path in paths:
        for version in re.findall(rf"\b{prefix}_(\d+(?:\.\d+)+)\b", said("objdump", "-T", str(path))):
            newest = max(newest, tuple(int(part) for part in version.split(".")))
    return newest


def packages_of(places):
    """The Debian package and its version for each of these files."""
    owner = {}
    # Search by name, because a library may be recorded under /lib and found under /usr/lib, which are the same
    # folder. Read each of dpkg's lists once, because dpkg-query would search all of them for each name.
    names = {os.path.basename(place) for place in places}
    for listed in sorted(pathlib.Path("/var/lib/dpkg/info").glob("*.list")):
        for path in listed.read_text(encoding="utf-8", errors="replace").splitlines():
            if path.rpartition("/")[2] in names:
                owner.setdefault(os.path.realpath(path), listed.stem.partition(":")[0])
    lost = [place for place in places if place not in owner]
    if lost:
        sys.exit(f"No installed package contains {', '.join(lost)}, so the licence is unknown")
    version = dict(line.split("\t") for line in
                   said("dpkg-query", "-W", "-f", "${Package}\t${Version}\n", *sorted(set(owner.values()))).splitlines())
    return {place: (owner[place], version[owner[place]]) for place in places}


def take_common_licences(folder):
    """Copies the common licence texts that files in the folder only refer to, because every Debian system has them."""
    named = {"GPL-3"}  # the LGPL 3 refers to the GPL 3
    for path in folder.iterdir():
        text = path.read_text(encoding="utf-8", errors="replace")
        named.update(re.findall(rf"{COMMON}/([\w.+-]*\w)", text))
    (folder / COMMON.name).mkdir()
    for name in sorted(name for name in named if (COMMON / name).is_file()):
        shutil.copy(COMMON / name, folder / COMMON.name / name)


def take_own_licences(folder):
    """Copies Tiller's licences to the folder, with the paths stated in LICENSE."""
    for name in ("LICENSE", "robot/LICENSE", "app/LICENSE"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(TOP / name, folder / name)


def take_licences(places, folder):
    """Copies the licence of each of these files to the folder, with a list of files and packages.

    places  path of each file on this system, by its name in the archive
    """
    folder.mkdir(parents=True)
    # Tiller's own shared libraries do not have a licence of another project.
    places = {name: place for name, place in places.items() if not pathlib.Path(place).is_relative_to(TOP)}
    packages = packages_of(sorted(set(places.values())))
    lines = []
    for name, place in sorted(places.items()):
        package, version = packages[place]
        shutil.copy(f"/usr/share/doc/{package}/copyright", folder / f"{package}.txt")
        lines.append(f"{name}  {package} {version}\n")
    take_common_licences(folder)
    (folder / "LIST").write_text(
        "From Debian, which has their sources: apt-get source PACKAGE, or https://snapshot.debian.org\n"
        f"The texts named as {COMMON}/... are in {COMMON.name}.\n\n" +
        "".join(lines), encoding="utf-8")
