# Speed of the grains (study/a1), and paths of some.
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[0.1, 0.2, 0.3, 0.8], case="study/a1", box=((0, -0.02), (0.35, 0.12)),
                  fluid=("magU", (0, 0.8)), solid=None, paths="every 30", width=1600)
