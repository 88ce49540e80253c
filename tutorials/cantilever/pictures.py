# The paper's figure 5: bending stress over the deformed shape at the first maximum (study/nodal-1).
#     pvbatch pictures.py          (after a run; writes paraview_<time>.png)
# or in ParaView, started after ". <libpfem>/etc/bashrc" in this folder: File > Run Script
import os
import sys

sys.path.insert(0, os.path.join(os.environ.get("PFEM_PROJECT_DIR", "../.."), "etc", "paraview"))
import pfemPictures

pfemPictures.show(times=[4.55], case="study/nodal-1", box=((-1, -3), (27, 13)),
                  fluid=None, solid=("sigma:XX", None))
