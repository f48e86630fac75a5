# SPDX-License-Identifier: MIT
"""Every class and method of the modules is documented: help(), inspect.signature() and repr(), with the same units as in
the headers."""
import importlib
import inspect
import os
import re
import unittest

MODULES = {"rtde_receive": "rtde_receive_interface.h", "rtde_control": "rtde_control_interface.h",
           "rtde_io": "rtde_io_interface.h", "dashboard_client": "dashboard_client.h", "script_client": "script_client.h",
           "robotiq_gripper": "robotiq_gripper.h"}


def public(module):
    """Yields (class, name, method) for every public method."""
    for cls in vars(module).values():
        if isinstance(cls, type) and not hasattr(cls, "__members__"):
            for name, member in vars(cls).items():
                if callable(member) and not isinstance(member, type) and (name == "__init__" or not name.startswith("_")):
                    yield cls, name, getattr(cls, name)


class TestDocs(unittest.TestCase):
    def test_every_class_and_method_has_a_docstring(self):
        count = 0
        for module in map(importlib.import_module, MODULES):
            self.assertRegex(module.__version__, r"^\d+\.\d+\.\d+$")
            self.assertTrue(module.__doc__)
            for cls, name, method in public(module):
                with self.subTest(f"{cls.__name__}.{name}"):
                    self.assertGreater(len(cls.__doc__ or ""), 10)
                    text = method.__doc__ or ""
                    self.assertGreater(len(text), 5)
                    self.assertNotIn("self:", text)  # pybind11's own signature
                    self.assertNotIn("Overloaded function", text)
                    count += 1
        self.assertGreater(count, 200)

    def test_every_signature_can_be_inspected_and_names_its_arguments(self):
        for module in map(importlib.import_module, MODULES):
            for cls, name, method in public(module):
                with self.subTest(f"{cls.__name__}.{name}"):
                    parameters = list(inspect.signature(method).parameters.values())
                    self.assertEqual(parameters[0].name, "self")
                    for parameter in parameters:
                        self.assertNotRegex(parameter.name, r"^arg\d")

    def test_bound_methods_omit_the_bound_arguments(self):
        from rtde_control import Path, RTDEControlInterface

        self.assertEqual(str(inspect.signature(RTDEControlInterface.moveL)),
                         "(self, pose, speed=0.25, acceleration=1.2, asynchronous=False)")
        self.assertEqual(str(inspect.signature(Path().addEntry)), "(entry)")
        self.assertIn("Also: moveJ(self, path, asynchronous=False)", RTDEControlInterface.moveJ.__doc__)

    def test_units_are_those_of_the_headers(self):
        folder = os.path.join(os.environ["TILLER_SOURCE"], "robot", "ur_rtde")
        checked = 0
        for name, header in MODULES.items():
            methods = {method: function.__doc__ for _, method, function in public(importlib.import_module(name))}
            with open(os.path.join(folder, header), encoding="utf-8") as file:
                for line in file:
                    found = re.match(r"\s+[\w:<>]+ (\w+)\(.*\);\s*///< (.*)$", line)
                    for unit in re.findall(r"\[([^\]]+)\]", found[2]) if found and found[1] in methods else ():
                        with self.subTest(found[1]):
                            self.assertIn(f"[{unit}]", methods[found[1]])
                            checked += 1
        self.assertGreater(checked, 25)

    def test_enumerations_are_python_enums(self):
        import enum

        from rtde_control import RTDEControlInterface

        self.assertTrue(issubclass(RTDEControlInterface.Flags, enum.IntFlag))
        self.assertTrue(issubclass(RTDEControlInterface.Feature, enum.IntEnum))
        self.assertEqual(RTDEControlInterface.FLAG_UPLOAD_SCRIPT | RTDEControlInterface.FLAG_NO_WAIT, 0x11)


if __name__ == "__main__":
    unittest.main()
