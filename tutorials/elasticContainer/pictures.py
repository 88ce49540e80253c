# The paper's figure 16: pressure of the syrup, stress in the container.
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[0.9, 1.1, 1.3, 1.6, 2.5, 10], box=((-3.2, -8), (3.2, 2.8)),
                  fluid=("p", (0, 70000)), solid=("vonMises", None), width=900)
