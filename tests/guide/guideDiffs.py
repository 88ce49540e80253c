#!/usr/bin/env python3
"""A stranger's hour: the diffs of doc/developerGuide.md are applied to a copy of the sources, what they change is
compiled, and the new parts run. Arguments: the project's folder, a built build folder (Ninja), a folder to work in."""

import pathlib
import re
import shutil
import subprocess
import sys

from build import Build

project, built, work = (pathlib.Path(a).resolve() for a in sys.argv[1:4])
here = pathlib.Path(__file__).parent

# Heading in the guide: most files that one of its diffs may touch in src (lists of files for CMake not counted)
limits = {'Adding a material': 3, 'Adding a function object': 3, 'Adding a type of wall': 3, 'Adding a nodal field': 2,
          'Adding a remeshing rule': 2}


def run(*command, **options):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True, **options)
    if done.returncode != 0:
        sys.exit(' '.join(map(str, command)) + '\n' + done.stdout + done.stderr)
    return done.stdout


def guideDiffs():
    """(heading, diff, the files that it touches)"""
    guide = (project / 'doc/developerGuide.md').read_text()
    for heading, text in re.findall(r'^## (.*?)\n(.*?)(?=^## |\Z)', guide, re.S | re.M):
        for diff in re.findall(r'^```diff\n(--- .*?)^```', text, re.S | re.M):
            yield heading, diff, re.findall(r'^\+\+\+ b/(\S+)', diff, re.M)


def patched(name, headings):
    """A copy of src with the diffs of these headings; the copy and what they touch."""
    copy, touched = work / name, []
    shutil.rmtree(copy, ignore_errors=True)
    shutil.copytree(project / 'src', copy / 'src')
    for heading, diff, files in guideDiffs():
        if heading not in headings:
            continue
        if len(files) > limits[heading]:
            sys.exit(f'{heading}: {len(files)} files: {files}')
        run('patch', '-p1', '--no-backup-if-mismatch', '-d', copy, input=diff)
        touched += files
    return copy, touched


counted = [heading for heading, _, _ in guideDiffs()]
if sorted(set(counted)) != sorted(limits) or counted.count('Adding a material') != 2:
    sys.exit(f'diffs are missing: {counted}')

# Laws, function object and wall: the solver with them, and a case that takes them all.
parts = ['Adding a material', 'Adding a function object', 'Adding a type of wall']
build = Build(project, built, *patched('parts', parts))
solver = build.program('pfemFsiFoam', project / 'applications/pfemFsiFoam/pfemFsiFoam.cpp')
run(build.program('checkParts', here / 'checkParts.cpp'))
run('sh', here / 'runParts.sh', project, built / 'applications', solver, work / 'case')

# A nodal field goes through files and remeshing's means.
build = Build(project, built, *patched('field', ['Adding a nodal field']))
run(build.program('checkField', here / 'checkField.cpp'), work / 'fieldTime')

# Rules of remeshing: what they touch compiles.
build = Build(project, built, *patched('rules', ['Adding a remeshing rule']))
for source in build.changedSources():
    build.object(source, ['-fsyntax-only'])
