# The paper's figure 8: pressure of the water.
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[0.175, 0.35, 0.42, 0.525, 0.7, 0.875], box=((-0.05, -0.2), (1.66, 0.7)),
                  fluid=("p", (0, 4000)), solid=None)
