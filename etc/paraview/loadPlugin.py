"""Loads the plugin beside this file, also in ParaView 5.11 of Debian 12, whose own loader fails with Python 3.11 (it asks for
inspect.getargspec, which is no more). In ParaView: File > Run Script. In scripts: loadPlugin.load(globals())."""

import inspect
import os

if not hasattr(inspect, "getargspec"):
    inspect.getargspec = inspect.getfullargspec


def load(names):
    """Makes pfemJoinParts and pfemParticlePaths known to ParaView, and puts them into `names`."""
    from paraview import simple

    simple.LoadPlugin(os.path.join(os.path.dirname(os.path.realpath(__file__)), "pfemPlugin.py"), remote=False, ns=names)


if __name__ in ("__main__", "__vtkconsole__"):
    load(globals())
