#!/usr/bin/env python3
"""What doc/developerGuide.md shows of the example project is in that project. (tests/guide applies the guide's diffs of the
library.) Argument: the project's folder."""

import pathlib
import re
import sys

project = pathlib.Path(sys.argv[1])
guide = (project / 'doc/developerGuide.md').read_text()
example = '\n'.join(f.read_text() for f in sorted((project / 'examples/ownSolver').iterdir()) if f.is_file())


def plain(line):
    """Without comment and layout."""
    return ' '.join(re.sub(r'\s*(//|# ).*', '', line).split())


words = ' '.join(plain(line) for line in example.splitlines())
diffs = [diff for diff in re.findall(r'^```diff\n(.*?)^```', guide, re.S | re.M) if '--- ' not in diff]
shown = [plain(line[1:]).removesuffix(' ...);') for diff in diffs for line in diff.splitlines() if line.startswith('+')]
lost = [line for line in shown if line not in words]
for line in lost:
    print(f'examples/ownSolver: the guide shows what is not there: "{line}"')
if len(shown) < 20:
    print(f'only {len(shown)} lines of diffs found')
sys.exit(len(lost) > 0 or len(shown) < 20)
