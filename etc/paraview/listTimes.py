# The times that ParaView's own reader finds in a case, one a line:
#
#     pvbatch etc/paraview/listTimes.py case.pvd
#
# With the word `sizes` after it: also the number of cells of each part at each time, which reads every file.
# (pvbatch keeps words with a dash for itself.)

import sys

from paraview import servermanager
from paraview.simple import PVDReader

arguments = [word for word in sys.argv[1:] if word != "sizes"]
if len(arguments) != 1:
    sys.exit("Usage: pvbatch listTimes.py case.pvd [sizes]")

reader = PVDReader(FileName=arguments[0])
reader.UpdatePipelineInformation()
times = reader.TimestepValues
try:
    times = list(times)
except TypeError:  # one time only
    times = [times]

for time in times:
    text = "%.12g" % time
    if "sizes" in sys.argv:
        reader.UpdatePipeline(time)
        data = servermanager.Fetch(reader)
        parts = [data.GetBlock(i) for i in range(data.GetNumberOfBlocks())] if data.IsA("vtkMultiBlockDataSet") else [data]
        text += " " + " ".join("%d" % part.GetNumberOfCells() for part in parts if part)
    print(text)
