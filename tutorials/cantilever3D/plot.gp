# Picture of the study: convergence.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,520 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set output "convergence.png"
set multiplot layout 1,2 title "A square bar at rest: nodal integration from above, elemental from below"
set xlabel "tetrahedra across the bar"
set logscale x 2
set xrange [1.6:10]
set ylabel "over theory"
set yrange [0:*]
set key bottom right samplen 2
one(load, scheme) = sprintf("< grep %s,%s study/bars.csv", load, scheme)
do for [load in "bend twist"] {
    set title load eq "bend" ? "deflection of the end" : "twist per length"
    plot 1 with lines lw 5 lc rgb "#bbccee" title "theory", \
         one(load, "nodal") using 3:($4/$5) with linespoints pt 7 lw 1.6 lc rgb "#cc3311" title "nodal", \
         one(load, "elemental") using 3:($4/$5) with linespoints pt 6 lw 1.6 lc rgb "black" title "elemental"
}
unset multiplot
