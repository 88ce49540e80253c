# Speed of the water in the first quarter of the period, and paths of its particles.
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[0.1, 0.3, 0.6, 0.9], box=((-0.05, -0.1), (1.05, 0.6)),
                  fluid=("magU", (0, 0.06)), solid=None, paths="every 50")
