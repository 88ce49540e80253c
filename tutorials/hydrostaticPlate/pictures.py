# Pressure of the water, stress in the plate (study/nodal-4).
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[0.2], case="study/nodal-4", box=((-0.3, -0.5), (1.3, 2.2)),
                  fluid=("p", None), solid=("vonMises", None), width=700)
