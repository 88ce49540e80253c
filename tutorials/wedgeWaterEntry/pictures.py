# The paper's figure 12: pressure of the water around the wedge.
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[0.51, 0.52, 0.525, 0.53, 0.545, 0.56], box=((-1.25, -0.8), (1.25, 0.6)),
                  fluid=("p", (0, 60000)), solid=("magU", None))
