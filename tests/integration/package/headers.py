# SPDX-License-Identifier: MIT
"""Compiles every installed header of a folder as the first and only header that a file includes.

Two optimizations give the same result with less work. Headers are compiled in chains. Each header in a chain follows a
header that it includes anyway, directly or indirectly, so that the chain provides nothing that the header does not
include itself. Third-party headers (Eigen, Qt, the standard library) are read from a few precompiled headers. A chain
uses a precompiled header only if its first header includes all of the contents before its first declaration.
"""
import argparse
import collections
import concurrent.futures
import itertools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PRECOMPILED = 6  # number of precompiled headers; each takes as much time as two chains
LEAST_USERS = 4


def includes(text):
    """The includes of a header that do not depend on the system: own headers, third-party headers, and whether all of
    them come before the first declaration."""
    ours, others = [], []
    depth = 0
    at_top = True
    declared = False
    for line in text.splitlines():
        directive = re.match(r"\s*#\s*(\w+)\s*(.*)", line)
        if not directive:
            declared = declared or re.match(r"\s*(namespace|class|struct|enum|using|template|inline|constexpr)\b",
                                            line) is not None
            continue
        word, rest = directive.groups()
        if word in ("if", "ifdef", "ifndef"):
            depth += 1
        elif word == "endif":
            depth -= 1
        elif word == "include":
            at_top = at_top and not declared
            name = re.match(r'"([^"]+)"|<([^>]+)>', rest)
            if name and depth == 0:
                (ours if name[1] else others).append(name[1] or name[2])
    return ours, others, at_top


class Headers:
    """Direct and indirect includes of each header."""

    def __init__(self, names, top):
        self.names = names
        known = set(names)
        read = {name: includes((top / name).read_text()) for name in names}
        self.ours = {}
        self.others = {}

        def visit(name):
            if name not in self.ours:
                ours, others, _ = read[name]
                self.ours[name] = set()
                self.others[name] = set(others)
                for other in (other for other in ours if other in known):
                    visit(other)
                    self.ours[name] |= {other} | self.ours[other]
                    self.others[name] |= self.others[other]

        for name in names:
            visit(name)
        self.at_top = {name: all(read[each][2] for each in self.ours[name] | {name}) for name in names}

    def preludes(self):
        """The sets of third-party headers that are worth precompiling."""
        closures = collections.Counter(frozenset(self.others[name]) for name in self.names if self.at_top[name])
        candidates = set(closures) | {a & b for a, b in itertools.combinations(closures, 2)}
        chosen = []

        def gain(prelude):
            return sum(count * max(0, weight(prelude) - max((weight(p) for p in chosen if p <= closure), default=0))
                       for closure, count in closures.items() if prelude <= closure)

        while candidates and len(chosen) < PRECOMPILED:
            best = max(candidates, key=lambda prelude: (gain(prelude), sorted(prelude)))
            if gain(best) < LEAST_USERS * weight(best):
                break
            chosen.append(best)
            candidates.discard(best)
        return chosen

    def fitting(self, name, preludes):
        """Index of the largest precompiled set with only headers that this header includes; None if there is none."""
        fits = [i for i, prelude in enumerate(preludes) if self.at_top[name] and prelude <= self.others[name]]
        return max(fits, key=lambda i: weight(preludes[i]), default=None)

    def chains(self, kinds):
        """The minimum number of chains of one kind that contain each header once (a bipartite matching of
        predecessors)."""
        users = {header: [user for user in self.names if header in self.ours[user] and kinds[user] == kinds[header]]
                 for header in self.names}
        before = {}

        def place(header, tried):
            for user in users[header]:
                if user not in tried:
                    tried.add(user)
                    if user not in before or place(before[user], tried):
                        before[user] = header
                        return True
            return False

        for header in self.names:
            place(header, set())
        behind = {header: user for user, header in before.items()}
        for header in self.names:
            if header not in before:
                chain = [header]
                while chain[-1] in behind:
                    chain.append(behind[chain[-1]])
                yield chain


def weight(prelude):
    """Approximate time that the compiler needs to read the header."""
    return sum(9 if name.startswith("Eigen") else 4 if name.startswith("Q") else 1 for name in prelude)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--top", type=pathlib.Path, required=True, help="what the headers' names begin behind")
    parser.add_argument("--installed", type=pathlib.Path, required=True, help="folder with the installed headers")
    parser.add_argument("--folder", required=True, help="of the headers, from the top")
    parser.add_argument("command", nargs="+", help="the compiler and its options")
    options = parser.parse_args()
    names = sorted(str(path.relative_to(options.installed))
                   for path in (options.installed / options.folder).rglob("*.h"))
    headers = Headers(names, options.top)
    preludes = headers.preludes()
    kinds = {name: headers.fitting(name, preludes) for name in names}
    together = list(headers.chains(kinds))
    if not names or sorted(sum(together, [])) != names:
        sys.exit("not every header is looked at")

    def run(*arguments):
        # Low priority, because other tests run in parallel.
        return subprocess.run([*options.command, *arguments], capture_output=True, text=True,
                              preexec_fn=lambda: os.nice(10))

    with tempfile.TemporaryDirectory() as folder, concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        folder = pathlib.Path(folder)

        def precompile(number):
            header = folder / f"prelude_{number}.h"
            header.write_text("".join(f"#include <{name}>\n" for name in sorted(preludes[number])))
            # If this fails, a chain reads the header itself and reports the error.
            run("-x", "c++-header", str(header), "-o", f"{header}.gch")
            return header

        def compiled(number):
            chain = together[number]
            source = folder / f"chain_{number}.cpp"
            source.write_text("".join(f'#include "{header}"\n' for header in chain))
            kind = kinds[chain[0]]
            prelude = [] if kind is None else ["-include", str(precompiled[kind])]
            done = run("-fsyntax-only", *prelude, str(source))
            return "" if done.returncode == 0 else f"{' -> '.join(chain)}:\n{done.stderr}"

        precompiled = list(pool.map(precompile, range(len(preludes))))
        complaints = [text for text in pool.map(compiled, range(len(together))) if text]
    print("\n".join(complaints))
    print(f"{len(names)} headers in {len(together)} compilations and {len(preludes)} precompiled headers, "
          f"{len(complaints)} of them failed")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
