#!/usr/bin/env python3
"""clang-tidy over many sources, those of a folder as one: most of its time goes into the headers of third parties, which
are then read once. Sources that do not compile together (two helpers of one name) are halved until they do.

    tidyTogether.py <project> <folder with compile_commands.json> <processes> <sources...>

Prints what is found; exit code 1 where anything is."""

import concurrent.futures
import itertools
import json
import os
import shlex
import subprocess
import sys
import tempfile

MOST = 14  # sources at a time: more take too much memory


def compile_flags(entry):
    """Of a compile command: all but the compiler, the source and what is written."""
    flags, words = [], iter(shlex.split(entry["command"])[1:])
    for word in words:
        if word in ("-o", "-MF", "-MT"):
            next(words)
        elif word not in ("-c", "-MD") and not word.endswith(".cpp"):
            flags.append(word)
    return flags


def tidy(project, entries):
    """What clang-tidy says of these sources."""
    with tempfile.NamedTemporaryFile("w", suffix=".cpp") as together:
        together.writelines(f'#include "{entry["file"]}"\n' for entry in entries)
        together.flush()
        source = entries[0]["file"] if len(entries) == 1 else together.name
        words = ["clang-tidy", "--quiet", f"--config-file={project}/.clang-tidy", "--checks=-bugprone-suspicious-include"]
        words += [source, "--", *compile_flags(entries[0])]
        said = subprocess.run(words, cwd=entries[0]["directory"], capture_output=True, text=True, check=False).stdout
    if "clang-diagnostic-error" in said and len(entries) > 1:
        half = len(entries) // 2
        return tidy(project, entries[:half]) + tidy(project, entries[half:])
    return said


def main():
    project, build, processes, *sources = sys.argv[1:]
    with open(f"{build}/compile_commands.json", encoding="utf-8") as file:
        known = {entry["file"]: entry for entry in json.load(file)}
    paths = sorted(f"{project}/{source}" for source in sources)
    wanted = [known[path] for path in paths if path in known]
    parts = []
    for _, group in itertools.groupby(wanted, lambda entry: (os.path.dirname(entry["file"]), tuple(compile_flags(entry)))):
        entries = list(group)
        parts += [entries[i:i + MOST] for i in range(0, len(entries), MOST)]
    found = False
    with concurrent.futures.ThreadPoolExecutor(int(processes)) as pool:
        for said in pool.map(lambda part: tidy(project, part), parts):
            if said.strip():
                found = True
                print(said, flush=True)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
