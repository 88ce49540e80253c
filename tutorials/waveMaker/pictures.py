# Speed of the water, and paths of its particles.
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[3, 5, 7, 9], box=((-0.2, -0.5), (8, 0.7)),
                  fluid=("magU", (0, 0.1)), solid=None, paths="every 100", width=1600)
