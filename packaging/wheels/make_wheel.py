# SPDX-License-Identifier: MIT
"""Builds two wheels that only need glibc and the C++ runtime of the system.

    tiller            the Python modules and tiller-cli, for the Python they were built for
    tiller-simulator  the simulated controller alone, as a program with a fixture for pytest, for any Python

A wheel is a zip archive with a list of its files. It includes the libraries used by the programs (Qt Core, Qt Network
and their dependencies) under changed names, so that they are not confused with another Qt in the same process. The tag
contains the oldest supported version of glibc, which is determined from the symbols.
"""
import argparse
import base64
import hashlib
import os
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import zipfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "linux"))
import libraries  # noqa: E402: needs the path set above

MODULES = ("rtde_control", "rtde_receive", "rtde_io", "dashboard_client", "script_client", "robotiq_gripper")
LICENCES = "MIT AND GPL-3.0-or-later AND LGPL-3.0-only"


def needed(path):
    return [name for name in libraries.said("patchelf", "--print-needed", str(path)).split() if not libraries.SYSTEM.match(name)]


def own_name(name):
    """Returns the changed name of a library, e.g. libQt6Core-tiller.so.6 for libQt6Core.so.6."""
    return name.replace(".so", "-tiller.so", 1)


def bundle(folder, programs, libs):
    """Copies the loaded libraries to folder/libs and sets the search path. Returns the source of each copy."""
    (folder / libs).mkdir()
    copies = {folder / libs / own_name(name): place for name, place in libraries.libraries_of(programs).items()}
    for copy, place in copies.items():
        copy_program(place, copy)
    for path in [*programs, *copies]:
        # Change one name at a time, because some releases of patchelf leave half of several names unchanged.
        names = needed(path)
        if path in copies:
            subprocess.run(["patchelf", "--set-soname", path.name, str(path)], check=True)
        way = os.path.relpath(folder / libs, path.parent)
        subprocess.run(["patchelf", "--set-rpath", "$ORIGIN" if way == "." else f"$ORIGIN/{way}", str(path)], check=True)
        for name in names:
            subprocess.run(["patchelf", "--replace-needed", name, own_name(name), str(path)], check=True)
    return copies


def platform_of(paths):
    """The tag of the oldest glibc that has all symbols required by these files, e.g. manylinux_2_36_x86_64."""
    major, minor = max((2, 17), libraries.newest_symbols("GLIBC", paths)[:2])
    return f"manylinux_{major}_{minor}_{os.uname().machine}"


def pack(folder, output, name, version, tag, pure, metadata, entry_points, top_level, copies):
    info = f"{name.replace('-', '_')}-{version}.dist-info"
    (folder / info).mkdir()
    (folder / info / "METADATA").write_text(
        f"Metadata-Version: 2.1\nName: {name}\nVersion: {version}\nLicense: {LICENCES}\n{metadata}")
    (folder / info / "WHEEL").write_text(f"Wheel-Version: 1.0\nGenerator: tiller\nRoot-Is-Purelib: {pure}\nTag: {tag}\n")
    (folder / info / "entry_points.txt").write_text(entry_points)
    (folder / info / "top_level.txt").write_text("".join(module + "\n" for module in top_level))
    libraries.take_own_licences(folder / info / "licenses")
    libraries.take_licences({copy.name: place for copy, place in copies.items()}, folder / info / "licenses/libraries")
    record = ""
    files = sorted(path for path in folder.rglob("*") if path.is_file())
    for path in files:
        digest = base64.urlsafe_b64encode(hashlib.sha256(path.read_bytes()).digest()).rstrip(b"=").decode()
        record += f"{path.relative_to(folder)},sha256={digest},{path.stat().st_size}\n"
    (folder / info / "RECORD").write_text(record + f"{info}/RECORD,,\n")
    wheel = output / f"{name.replace('-', '_')}-{version}-{tag}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in [*files, folder / info / "RECORD"]:
            # For a reproducible archive, store no date and only the relevant mode bits.
            entry = zipfile.ZipInfo(str(path.relative_to(folder)))
            entry.external_attr = (0o100755 if os.access(path, os.X_OK) else 0o100644) << 16
            entry.compress_type = zipfile.ZIP_DEFLATED
            archive.writestr(entry, path.read_bytes())


def copy_program(source, target):
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(source, target)
    os.chmod(target, 0o755)
    return target


def tiller(options, folder):
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    programs = []
    for module in MODULES:
        programs.append(copy_program(options.modules / (module + suffix), folder / (module + suffix)))
        shutil.copy(options.modules / (module + ".pyi"), folder)
        # The location where type checkers search for the stubs of a module that is not a package.
        (folder / f"{module}-stubs").mkdir()
        shutil.copy(options.modules / (module + ".pyi"), folder / f"{module}-stubs" / "__init__.pyi")
    (folder / "tiller").mkdir()
    for path in (options.modules / "tiller").iterdir():
        if path.name.endswith((".py", ".pyi")) or path.name == "py.typed":
            shutil.copy(path, folder / "tiller")
    programs.append(copy_program(options.modules / "tiller" / ("_native" + suffix), folder / "tiller" / ("_native" + suffix)))
    programs.append(copy_program(options.cli, folder / "tiller" / "bin" / "tiller-cli"))
    copies = bundle(folder, programs, "tiller.libs")
    python = "cp{0}{1}-cp{0}{1}".format(*sys.version_info[:2])
    pack(folder, options.output, "tiller", options.version, f"{python}-{platform_of([*programs, *copies])}", "false",
         "Summary: Control, monitor and simulate Universal Robots arms; with the Python interface of ur_rtde\n"
         "Requires-Python: >=3.9\nRequires-Dist: numpy\n",
         "[console_scripts]\ntiller-cli = tiller.__main__:main\n\n[pytest11]\ntiller = tiller.pytest_plugin\n",
         (*MODULES, "tiller"), copies)


def simulator(options, folder):
    shutil.copytree(pathlib.Path(__file__).parent / "tiller_simulator", folder / "tiller_simulator",
                    ignore=shutil.ignore_patterns("__pycache__"))
    program = copy_program(options.cli, folder / "tiller_simulator" / "bin" / "tiller-cli")
    copies = bundle(folder, [program], "tiller_simulator.libs")
    pack(folder, options.output, "tiller-simulator", options.version, f"py3-none-{platform_of([program, *copies])}", "false",
         "Summary: A simulated Universal Robots controller for tests: real protocols, real URScript, no container\n"
         "Requires-Python: >=3.8\n",
         "[console_scripts]\ntiller-simulate = tiller_simulator.__main__:main\n\n"
         "[pytest11]\ntiller_simulator = tiller_simulator.pytest_plugin\n",
         ("tiller_simulator",), copies)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--modules", type=pathlib.Path, required=True, help="folder of the Python modules")
    parser.add_argument("--cli", type=pathlib.Path, required=True, help="the program tiller-cli")
    parser.add_argument("--output", type=pathlib.Path, required=True)
    parser.add_argument("--version", required=True)
    options = parser.parse_args()
    libraries.want_tools("patchelf", "ldd", "objdump", "dpkg-query")
    shutil.rmtree(options.output, ignore_errors=True)
    options.output.mkdir(parents=True)
    for make in (tiller, simulator):
        with tempfile.TemporaryDirectory() as folder:
            make(options, pathlib.Path(folder))


if __name__ == "__main__":
    main()
