# SPDX-License-Identifier: MIT
"""Writes completions for bash, zsh and fish from the help of a program: make_completions.py PROGRAM FOLDER.

`PROGRAM --help` lists the options, and the commands below "Commands:". `PROGRAM COMMAND --help` lists the options of a
command.
"""
import os
import re
import subprocess
import sys

OPTION = re.compile(r"^ +(?:-\S, )*--([a-z][a-z-]*)(?: <?(\S+?)>?)?(?:  +(.*))?$")
COMMAND = re.compile(r"^  ([a-z][a-z-]*)(?: [A-Z .\[\]]+)?  +(.+)$")
PATHS = ("FILE", "FOLDER")  # values that are completed as paths


def help_of(*words):
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", LC_ALL="C.UTF-8")
    return subprocess.run([*words, "--help"], capture_output=True, text=True, check=True, env=environment).stdout


def options_of(text):
    """For each option, the name of its value or None, and the first sentence of its help."""
    found = {}
    words = []
    for line in text.splitlines():
        match = OPTION.match(line)
        if match:
            words = [match[3]] if match[3] else []
            found[match[1]] = (match[2] and match[2].upper(), words)
        elif line.startswith(" " * 20):
            words.append(line.strip())
        else:
            words = []
    return {name: (value, " ".join(words).partition(". ")[0].removesuffix(".")) for name, (value, words) in found.items()}


def commands_of(text):
    part = text.partition("Commands:\n")[2].partition("\n\n")[0]
    return {match[1]: match[2].strip() for match in map(COMMAND.match, part.splitlines()) if match}


def quoted(text):
    return "'" + text.replace("'", "’") + "'"


def bash(program, options, commands):
    function = "_" + program.replace("-", "_")
    cases = "".join(f"        {name}) words=\"{' '.join('--' + option for option in own)}\" ;;\n"
                    for name, (_, own) in commands.items())
    # An option can need a value in one command and not in another.
    contexts = [(f"{name} ", own) for name, (_, own) in commands.items()] or [("", options)]
    previous = '"${COMP_WORDS[1]} ${COMP_WORDS[COMP_CWORD-1]}"' if commands else '"${COMP_WORDS[COMP_CWORD-1]}"'

    def patterns(wanted):
        return "|".join(f'"{context}--{name}"' for context, of in contexts for name, (value, _) in of.items()
                        if value and (value in PATHS) == wanted)
    first = " ".join([*commands, *("--" + name for name in options)])
    text = f"# Completion of {program} for bash.\n{function}() {{\n    local word=${{COMP_WORDS[COMP_CWORD]}} words=\n"
    text += f"    COMPREPLY=()\n    case {previous} in\n"
    for found, action in ((patterns(True), "compopt -o default; return"), (patterns(False), "return")):
        text += f"        {found}) {action} ;;\n" if found else ""
    text += "    esac\n"
    if commands:
        text += f"    if [ \"$COMP_CWORD\" -eq 1 ]; then\n        words=\"{first}\"\n    else case ${{COMP_WORDS[1]}} in\n{cases}    esac; fi\n"
    else:
        text += f"    words=\"{first}\"\n"
    text += "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\")\n"
    if not commands:
        text += "    [ ${#COMPREPLY[@]} -gt 0 ] || compopt -o default\n"
    return text + f"}}\ncomplete -F {function} {program}\n"


def zsh(program, options, commands):
    def specs(of):
        for name, (value, words) in of.items():
            what = re.sub(r"[\[\]:]", " ", words).strip()
            action = (":value:_files" if value in PATHS else ":value: ") if value else ""
            yield "    " + quoted(f"*--{name}[{what}]{action}")
    text = f"#compdef {program}\n# Completion of {program} for zsh.\n"
    if not commands:
        return text + "_arguments \\\n" + " \\\n".join([*specs(options), "    '*:file:_files'"]) + "\n"
    text += "if (( CURRENT == 2 )); then\n    local -a commands=(\n"
    text += "".join("        " + quoted(f"{name}:{words}") + "\n" for name, (words, _) in commands.items())
    text += "    )\n    _describe command commands\n    _arguments \\\n" + " \\\n".join(specs(options)) + "\n    return\nfi\n"
    text += "case $words[2] in\n"
    for name, (_, own) in commands.items():
        text += f"{name})\n    _arguments \\\n" + " \\\n".join([*specs(own), "    '*:: :_files'"]) + "\n    ;;\n"
    return text + "esac\n"


def fish(program, options, commands):
    text = f"# Completion of {program} for fish.\n" + (f"complete -c {program} -f\n" if commands else "")

    def lines(of, condition):
        out = ""
        for name, (value, words) in of.items():
            takes = (" -rF" if value in PATHS else " -x") if value else ""
            out += f"complete -c {program}{condition} -l {name}{takes} -d {quoted(words)}\n"
        return out
    if not commands:
        return text + lines(options, "")
    for name, (words, own) in commands.items():
        text += f"complete -c {program} -n __fish_use_subcommand -a {name} -d {quoted(words)}\n"
        text += lines(own, f" -n '__fish_seen_subcommand_from {name}'")
    return text + lines(options, " -n __fish_use_subcommand")


def main(path, folder):
    program = os.path.basename(path)
    text = help_of(path)
    options = options_of(text)
    commands = {name: (words, options_of(help_of(path, name))) for name, words in commands_of(text).items()}
    if not options:
        sys.exit(f"{program} --help names no options")
    os.makedirs(folder, exist_ok=True)
    for name, content in ((f"{program}.bash", bash(program, options, commands)), (f"_{program}", zsh(program, options, commands)),
                          (f"{program}.fish", fish(program, options, commands))):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(content)


if __name__ == "__main__":
    main(*sys.argv[1:])
