# Speed of the mud, and paths of its particles.
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[0.5, 1, 3, 10], box=((0, -0.05), (1, 0.2)),
                  fluid=("magU", (0, 0.2)), solid=None, paths="every 50", width=1600)
