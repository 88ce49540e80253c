# Picture of the study: convergence.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 800,500 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set output "convergence.png"
set title "A clamped square plate under water, nodal and elemental"
set xlabel "tetrahedra across the plate"
set xrange [1.6:4.4]
set xtics 1
set ylabel "deflection over theory"
set yrange [0:*]
set key bottom right samplen 2
one(scheme) = sprintf("< grep ^%s, study/plates.csv", scheme)
plot 1 with lines lw 5 lc rgb "#bbccee" title "theory", \
     one("nodal") using 2:($3/$4) with linespoints pt 7 lw 1.6 lc rgb "#cc3311" title "nodal", \
     one("elemental") using 2:($3/$4) with linespoints pt 6 lw 1.6 lc rgb "black" title "elemental"
