# SPDX-License-Identifier: MIT
"""Compiles every header of a folder as if it were the first and only one a file includes.

Headers are compiled in chains: behind a header comes one that includes it anyway, directly or through others, so
what is there before it is nothing it has not asked for. That proves the same as one compilation for each header,
with half of them.
"""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile


def included(headers, top):
    """Of each header: the others of ours that it includes, directly or through others."""
    direct = {}
    for header in headers:
        names = re.findall(r'^\s*#\s*include\s+"([^"]+)"', (top / header).read_text(), re.MULTILINE)
        direct[header] = [name for name in names if name in headers]
    whole = {}

    def visit(header):
        if header not in whole:
            whole[header] = set()
            for other in direct[header]:
                whole[header] |= {other} | visit(other)
        return whole[header]

    for header in headers:
        visit(header)
    return whole


def chains(headers, whole):
    """As few chains as possible that hold each header once (a bipartite matching: who comes behind whom)."""
    users = {header: [user for user in headers if header in whole[user]] for header in headers}
    before = {}

    def place(header, tried):
        for user in users[header]:
            if user not in tried:
                tried.add(user)
                if user not in before or place(before[user], tried):
                    before[user] = header
                    return True
        return False

    for header in headers:
        place(header, set())
    behind = {header: user for user, header in before.items()}
    for header in headers:
        if header not in before:
            chain = [header]
            while chain[-1] in behind:
                chain.append(behind[chain[-1]])
            yield chain


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--top", type=pathlib.Path, required=True, help="what the headers' names begin behind")
    parser.add_argument("--folder", required=True, help="of the headers, from the top")
    parser.add_argument("--leave", default="^$", help="names not to look at, a regular expression")
    parser.add_argument("command", nargs="+", help="the compiler and its options")
    options = parser.parse_args()
    headers = sorted(str(path.relative_to(options.top)) for path in (options.top / options.folder).rglob("*.h"))
    headers = [header for header in headers if not re.search(options.leave, header)]
    together = list(chains(headers, included(headers, options.top)))
    if not headers or sorted(sum(together, [])) != headers:
        sys.exit("not every header is looked at")

    with tempfile.TemporaryDirectory() as folder:
        def compiled(number):
            source = pathlib.Path(folder) / f"chain_{number}.cpp"
            source.write_text("".join(f'#include "{header}"\n' for header in together[number]))
            # Other tests measure time meanwhile.
            run = subprocess.run([*options.command, "-fsyntax-only", str(source)], capture_output=True, text=True,
                                 preexec_fn=lambda: os.nice(10))
            return "" if run.returncode == 0 else f"{' -> '.join(together[number])}:\n{run.stderr}"

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            complaints = [text for text in pool.map(compiled, range(len(together))) if text]
    print("\n".join(complaints))
    print(f"{len(headers)} headers in {len(together)} compilations, {len(complaints)} of them failed")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
