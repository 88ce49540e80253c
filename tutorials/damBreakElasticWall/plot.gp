# Pictures of a run: tip.png, mass.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,640 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set key top right samplen 2 spacing 1.15
set xlabel "time [s]"
set xrange [0:1]

#-- the tip's displacement over eight published curves
set output "tip.png"
set title "Dam break against an elastic wall: horizontal displacement of the wall's top left corner"
set ylabel "u_x [m]"
set yrange [-0.03:0.055]
published(name) = sprintf("reference/tip_ux_%s.csv", name)
plot 0 notitle lc rgb "#888888" lw 0.8, \
     published("idelsohn2008_pfem") skip 2 with lines lw 1.3 lc rgb "#4477aa" title "Idelsohn et al. 2008, PFEM (from Sun et al. 2019)", \
     published("ryzhakov2010")      skip 2 with lines lw 1.3 lc rgb "#66ccee" title "Ryzhakov et al. 2010, PFEM (from solids4foam)", \
     published("liu2013_sph")       skip 2 with lines lw 1.3 lc rgb "#228833" title "Liu et al. 2013, SPH (from Sun et al. 2019)", \
     published("bogaers2016_qnls")  skip 2 with lines lw 1.3 lc rgb "#ccbb44" title "Bogaers 2016, QN-LS (from Sun et al. 2019)", \
     published("meduri2018")        skip 2 with lines lw 1.3 lc rgb "#ee6677" title "Meduri et al. 2018, PFEM (from solids4foam)", \
     published("cerquaglia2019")    skip 2 with points pt 7 ps 0.5 lc rgb "#aa3377" title "Cerquaglia et al. 2019, PFEM-FEM (from Kratos' figure)", \
     published("sun2019_mpsdem")    skip 2 with lines lw 1.3 lc rgb "#ee8833" title "Sun et al. 2019, MPS-DEM", \
     published("kratos_pfem_2021")  skip 2 with lines lw 1.3 lc rgb "#999999" title "Kratos Multiphysics 2021, PFEM-FEM", \
     "< pfemHistory -csv tip D" using 1:2 with lines lw 3 lc rgb "black" title "this run"

#-- the fluid's mass: what is there, and what it would be without the correction
# Without the correction: relativeChange - correction/V0, with V0 = volume/(1 + relativeChange).
ledger = "< pfemHistory -csv -columns 'Time relativeChange surface volume' mass fluidVolume.dat"
set output "mass.png"
set title "Fluid mass: change since the start"
set ylabel "change [%]"
set autoscale y
set key bottom left Left reverse opaque
plot 1.5 with lines dt 2 lc rgb "#888888" title "±1.5 %", -1.5 with lines dt 2 lc rgb "#888888" notitle, \
     0 with lines lc rgb "#888888" lw 0.8 notitle, \
     ledger using 1:(100*$2) with lines lw 2.5 lc rgb "black" title "total", \
     ledger using 1:(100*($2 - $3*(1 + $2)/$4)) with lines lw 1.5 lc rgb "#cc3311" title "total without the surface's shift"
