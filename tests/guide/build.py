"""Programs of changed sources, without compiling the library once more: what the change does not reach is taken from a
build folder, object by object."""

import collections
import pathlib
import re
import shutil
import subprocess
import sys


class Build:
    def __init__(self, project, built, copy, touched):
        """project: whose build folder `built` is; copy: with the changed src; touched: the files that differ."""
        self.copy, self.touched = copy, touched
        self.flags = self.commandOf(built, 'src/CMakeFiles/pfem.dir/material/lawTable.cpp.o').split()
        self.flags = [f.replace(f'{project}/src', f'{copy}/src') for f in self.flags[:self.flags.index('-o')]]
        self.flags = self.flags[next(i for i, f in enumerate(self.flags) if f.startswith('-')):]
        link = self.commandOf(built, 'applications/pfemFsiFoam').split(' && ')[1].split()
        self.libraries = [f for f in link[link.index('-o') + 2:] if not f.endswith('libpfem.a')]
        objects = built / 'src/CMakeFiles/pfem.dir'
        found = {p.relative_to(objects).with_suffix(''): p for p in objects.rglob('*.cpp.o')}
        self.unit = self.unitsOf(project, objects)
        self.objects = {f: p for f, p in found.items()  # no leftovers of older trees
                        if (project / 'src' / f).exists() and f not in self.unit}
        self.objects |= {unit: objects / f'{unit}.o' for unit in set(self.unit.values())}
        self.built = built
        self.changed = {self.unit.get(f, f) for f in self.reached()}

    def unitsOf(self, project, objects):
        """Sources that are compiled together -> what they are compiled as, which the copy gets as well."""
        units = {}
        for unit in (objects / 'Unity').glob('*.cxx'):
            if not pathlib.Path(f'{unit}.o').exists():
                continue
            text, target = unit.read_text(), self.copy / 'src' / unit.relative_to(objects)
            target.parent.mkdir(parents=True, exist_ok=True)
            target.write_text(text.replace(f'{project}/src', f'{self.copy}/src'))
            for source in re.findall(r'^#include "(.*?[.]cpp)"', text, re.M):
                units[pathlib.Path(source).relative_to(project / 'src')] = unit.relative_to(objects)
        return units

    @staticmethod
    def commandOf(built, target):
        """The command that makes a target: the last of Ninja's."""
        commands = subprocess.run(['ninja', '-C', built, '-t', 'commands', '-s', target], capture_output=True, text=True)
        return commands.stdout.strip().split('\n')[-1]

    def reached(self):
        """The sources that read a file that differs, and those that are new."""
        src = self.copy / 'src'
        users = collections.defaultdict(set)
        files = [p.relative_to(src) for p in src.rglob('*.?pp')]
        for file in files:
            for used in re.findall(r'^#include "(.*?)"', (src / file).read_text(), re.M):
                users[pathlib.Path(used)].add(file)
        found, new = set(), {pathlib.Path(f).relative_to('src') for f in self.touched}
        while new:
            found |= new
            new = set().union(*(users[f] for f in new)) - found
        return {f for f in found if f.suffix == '.cpp'}

    def changedSources(self):
        sources = [pathlib.Path(f).relative_to('src') for f in self.touched if f.endswith('.cpp')]
        return [self.copy / 'src' / self.unit.get(f, f) for f in sources]

    def object(self, source, extra=()):
        """Compile a source; returns the object."""
        result = self.copy / 'objects' / (source.relative_to(self.copy / 'src') if self.copy in source.parents
                                          else pathlib.Path(source.name)).with_suffix('.o')
        result.parent.mkdir(parents=True, exist_ok=True)
        launcher = [shutil.which('ccache')] if shutil.which('ccache') else []
        done = subprocess.run([*launcher, 'c++', *self.flags, *extra, '-o', result, '-c', source], cwd=self.built,
                              capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f'{source} does not compile:\n{done.stderr}')
        return result

    def program(self, name, main):
        """Compile and link a program: its own source, changed sources that it needs, objects of the build folder."""
        made = {f: self.object(self.copy / 'src' / f) for f in self.changed if f not in self.objects or
                self.copy / 'src' / f in self.changedSources()}
        objects = {**self.objects, **made}
        first = self.object(main)
        for file in self.needed(first, objects):
            if file in self.changed and file not in made:
                objects[file] = self.object(self.copy / 'src' / file)
        target = self.copy / name
        done = subprocess.run(['c++', '-o', target, first, *(objects[f] for f in self.needed(first, objects)),
                               *self.libraries], cwd=self.built, capture_output=True, text=True)
        if done.returncode != 0:
            sys.exit(f'{name} does not link:\n{done.stderr}')
        return target

    def needed(self, first, objects):
        """The sources whose objects a program needs, as a linker finds them in a library."""
        listed = subprocess.run(['nm', '-A', '-P', '-g', first, *objects.values()], capture_output=True, text=True).stdout
        definer, wanted = {}, collections.defaultdict(set)
        of = {str(path): file for file, path in objects.items()}
        for line in listed.split('\n'):
            path, _, rest = line.partition(': ')
            symbol, kind = (rest.split() + ['', ''])[:2]
            if kind == 'U':
                wanted[path].add(symbol)
            elif kind in ('T', 'B', 'D', 'R', 'W', 'V', 'i'):
                strong = kind not in ('W', 'V')
                if strong or symbol not in definer:
                    definer[symbol] = path
        found, new = set(), {str(first)}
        while new:
            found |= new
            new = {definer[s] for path in new for s in wanted[path] if s in definer} - found
        return [of[path] for path in sorted(found) if path in of]
