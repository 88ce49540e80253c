# Pictures of the study: deflection.png, convergence.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,560 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
thin = -6.849e-5
shear = -7.099e-5

#-- the middle of the plate in time
set output "deflection.png"
set title "Water on an elastic plate: deflection of the middle (4 triangles across)"
set xlabel "time [s]"
set ylabel "u_y [10^{-5} m]"
set xrange [0:0.07]
set yrange [-24:1]
set key bottom right samplen 3 spacing 1.15
history(name) = sprintf("< pfemHistory -csv -case study/%s mid D", name)
plot "reference/uy_mid_ng2020.csv" using 1:(10*$2) skip 2 with lines lw 1.2 lc rgb "#999999" title "Ng et al. 2020, SPH-VCPM", \
     history("swinging-4") using 1:(1e5*$3) with lines lw 1.2 lc rgb "#66ccee" title "nodal, trapezoidal rule: no damping", \
     history("nodal-4") using 1:(1e5*$3) with lines lw 2.5 lc rgb "#4477aa" title "nodal, backward Euler", \
     history("elemental-4") using 1:(1e5*$3) with lines lw 2.5 lc rgb "#ee6677" title "elemental, backward Euler", \
     1e5*thin lw 1.5 dt 2 lc rgb "black" title "thin-plate theory", \
     1e5*shear lw 1.5 dt 3 lc rgb "black" title "theory with shear"

#-- at rest, against the mesh
set output "convergence.png"
set title "Deflection at rest and triangles across the plate"
set logscale x 2
set xlabel "triangles across"
set xrange [1.6:20]
set yrange [*:*]
set key top right
deflections(scheme) = sprintf("< grep ^%s study/deflections.csv", scheme)
plot deflections("nodal") using 2:(1e5*$3) with linespoints pt 5 ps 1.3 lw 2 lc rgb "#4477aa" title "nodal: too soft", \
     deflections("elemental") using 2:(1e5*$3) with linespoints pt 7 ps 1.3 lw 2 lc rgb "#ee6677" title "elemental: too stiff", \
     1e5*thin lw 1.5 dt 2 lc rgb "black" title "thin-plate theory", \
     1e5*shear lw 1.5 dt 3 lc rgb "black" title "theory with shear"
