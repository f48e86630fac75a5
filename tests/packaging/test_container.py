# SPDX-License-Identifier: MIT
"""Requirements of the container file. Its entry point runs as process 1 of a PID namespace and exits cleanly on SIGTERM,
and its health check detects whether the controller is serving."""
import json
import os
import re
import signal
import subprocess
import unittest

PROGRAM = os.environ["TILLER_CLI"]


def containerfile():
    with open(os.path.join(os.environ["TILLER_SOURCE"], "packaging/linux/Containerfile"), encoding="utf-8") as file:
        return file.read()


def address():
    pid = os.getpid()
    return f"127.{10 + pid % 200}.{pid // 200 % 250}.9"


class TestContainer(unittest.TestCase):
    def start(self, *before):
        entry = json.loads(re.search(r"^ENTRYPOINT (.*)$", containerfile(), re.MULTILINE)[1])
        self.assertEqual(entry[0], "tiller-cli")
        # Do not listen on all addresses of this computer, because other users may also run the suite.
        command = [PROGRAM if word == "tiller-cli" else word for word in entry]
        command[command.index("0.0.0.0")] = address()
        process = subprocess.Popen([*before, *command], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.communicate)
        self.addCleanup(process.kill)
        return process

    def healthy(self):
        check = json.loads(re.search(r"CMD (\[.*\])$", containerfile(), re.MULTILINE)[1])
        check[-1] = check[-1].replace("127.0.0.1", address())
        return subprocess.run(check, stderr=subprocess.DEVNULL, check=False).returncode == 0

    def test_health_follows_the_controller(self):
        self.assertFalse(self.healthy())
        process = self.start()
        self.assertTrue(process.stdout.readline().startswith("ready "))
        self.assertTrue(self.healthy())
        process.terminate()
        self.assertEqual(process.wait(timeout=60), 0)
        self.assertFalse(self.healthy())

    def test_as_process_1_it_ends_on_sigterm(self):
        namespace = ["unshare", "--user", "--map-root-user", "--pid", "--fork", "--kill-child"]
        if subprocess.run([*namespace, "true"], capture_output=True, check=False).returncode != 0:
            namespace = ["unshare", "--pid", "--fork", "--kill-child"]
            if subprocess.run([*namespace, "true"], capture_output=True, check=False).returncode != 0:
                self.skipTest("this system permits no PID namespaces")
        process = self.start(*namespace)
        self.assertTrue(process.stdout.readline().startswith("ready "))
        with open(f"/proc/{process.pid}/task/{process.pid}/children", encoding="ascii") as file:
            inner = int(file.read().split()[0])
        with open(f"/proc/{inner}/status", encoding="ascii") as file:
            self.assertRegex(file.read(), r"NSpid:\s+\d+\s+1\n")
        os.kill(inner, signal.SIGTERM)
        self.assertEqual(process.wait(timeout=60), 0)


if __name__ == "__main__":
    unittest.main()
