# The paper's figures 20 and 21: speed of the water, stress in the wall.
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[0.14, 0.2, 0.26, 0.4, 0.6, 0.8], box=((-0.02, -0.06), (0.604, 0.4)),
                  fluid=("magU", (0, 2.5)), solid=("vonMises", (0, 2e5)))
