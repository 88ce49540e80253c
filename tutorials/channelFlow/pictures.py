# Speed of the oil and paths of its particles, from the inlet to the outlet.
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[1, 2], box=((-0.02, -0.02), (0.32, 0.12)), fluid=("magU", (0, 0.15)), solid=None,
                  paths="every 20")
