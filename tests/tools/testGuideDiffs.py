#!/usr/bin/env python3
"""The diffs of doc/developerGuide.md still fit: lines that a diff keeps or removes are in its file, in this order; lines that it adds
to the example project are in that project, and those of a diff that begins with a new file (it tells how a part came into the
library) in its files. Argument: the project's folder."""

import pathlib
import re
import sys

project = pathlib.Path(sys.argv[1])
guide = (project / 'doc/developerGuide.md').read_text()
example = '\n'.join(f.read_text() for f in sorted((project / 'examples/ownSolver').iterdir()) if f.is_file())


def plain(line):
    """Without comment and layout."""
    return ' '.join(re.sub(r'\s*(//|# ).*', '', line).split())


def missing(lines, text):
    """The first of `lines` that does not come in `text` after those before it."""
    there, at = [plain(t) for t in text.splitlines()], 0
    for line in lines:
        try:
            at = there.index(line, at) + 1
        except ValueError:
            return line
    return None


failures, found = 0, 0
for diff in re.findall(r'^```diff\n(.*?)^```', guide, re.S | re.M):
    if '--- /dev/null' in diff:
        for name, body in re.findall(r'^\+\+\+ b/(\S+)\n(.*?)(?=^--- |\Z)', diff, re.S | re.M):
            added = [plain(line[1:]) for line in body.splitlines() if line[:1] == '+' and plain(line[1:])]
            lost = missing(added, (project / name).read_text())
            found += len(added)
            if lost:
                print(f'{name}: the guide shows what is not there: "{lost}"')
                failures += 1
    elif '--- a/' in diff:
        for name, body in re.findall(r'^--- a/(\S+)\n(.*?)(?=^--- a/|\Z)', diff, re.S | re.M):
            kept = [plain(line[1:]) for line in body.splitlines() if line[:1] in (' ', '-') and plain(line[1:])]
            heads = [plain(line[2:]) for line in body.splitlines() if line.startswith('@@')]
            lost = missing(kept, (project / name).read_text())
            lost = lost or next((h for h in heads if h not in (project / name).read_text()), None)
            found += len(kept) + len(heads)
            if lost:
                print(f'{name}: the guide\'s diff does not fit: "{lost}"')
                failures += 1
    else:
        words = ' '.join(plain(line) for line in example.splitlines())
        for line in (plain(line[1:]) for line in diff.splitlines() if line.startswith('+')):
            found += 1
            if line not in ('', '...') and not line.endswith('...);') and line not in words:
                print(f'examples/ownSolver: the guide shows what is not there: "{line}"')
                failures += 1
if found < 30:
    print(f'only {found} lines of diffs found')
sys.exit(failures > 0 or found < 30)
