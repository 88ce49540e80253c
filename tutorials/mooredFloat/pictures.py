# Speed of the water around the barge.
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[6.25, 6.875], box=((-1.2, -0.32), (1.2, 0.2)), fluid=("magU", (0, 0.1)), solid=None)
