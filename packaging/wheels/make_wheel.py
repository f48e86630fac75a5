# SPDX-License-Identifier: MIT
"""Packs the Python modules into a wheel: make_wheel.py FOLDER_OF_MODULES OUTPUT_FOLDER VERSION.

A wheel is a zip archive with a list of its files; nothing has to be installed to make one. The modules use the
system's Qt libraries, so the wheel is for systems like the one it was made on.
"""
import base64
import hashlib
import os
import sys
import sysconfig
import zipfile

NAME = "tiller_ur_rtde"
MODULES = ("rtde_control", "rtde_receive", "rtde_io", "dashboard_client", "script_client", "robotiq_gripper")


def main(folder, output, version):
    tag = "cp{0}{1}-cp{0}{1}-{2}".format(*sys.version_info[:2], sysconfig.get_platform().replace("-", "_"))
    info = f"{NAME}-{version}.dist-info"
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    files = {}
    for module in MODULES:
        for ending in (suffix, ".pyi"):
            with open(os.path.join(folder, module + ending), "rb") as file:
                files[module + ending] = file.read()
        # Where type checkers look for the stubs of a module that is not a package.
        files[f"{module}-stubs/__init__.pyi"] = files[module + ".pyi"]
    for name in sorted(os.listdir(os.path.join(folder, "tiller"))):
        if name.endswith((".py", ".pyi", suffix)) or name == "py.typed":
            with open(os.path.join(folder, "tiller", name), "rb") as file:
                files["tiller/" + name] = file.read()
    files[f"{info}/entry_points.txt"] = b"[pytest11]\ntiller = tiller.pytest_plugin\n"
    files[f"{info}/METADATA"] = (
        f"Metadata-Version: 2.1\nName: {NAME.replace('_', '-')}\nVersion: {version}\n"
        "Summary: Control, monitor and simulate Universal Robots arms; with the Python interface of ur_rtde\n"
        "License: MIT\nRequires-Python: >=3.9\nRequires-Dist: numpy\n").encode()
    files[f"{info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: tiller\nRoot-Is-Purelib: false\nTag: {tag}\n").encode()
    files[f"{info}/top_level.txt"] = "".join(module + "\n" for module in (*MODULES, "tiller")).encode()
    record = ""
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(content)}\n"
    files[f"{info}/RECORD"] = (record + f"{info}/RECORD,,\n").encode()
    os.makedirs(output, exist_ok=True)
    with zipfile.ZipFile(os.path.join(output, f"{NAME}-{version}-{tag}.whl"), "w", zipfile.ZIP_DEFLATED) as wheel:
        for name, content in files.items():
            wheel.writestr(name, content)


if __name__ == "__main__":
    main(*sys.argv[1:])
