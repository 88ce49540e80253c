# Pictures of the study: tip.png, convergence.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,640 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2

sizes = system("cut -d, -f2 study/peaks.csv | sort -gru | tr '\n' ' '")
history(scheme, h) = sprintf("< pfemHistory -csv -case study/%s-%s tip D", scheme, h)
colour(k) = word("#bbccee #99ddff #44bb99 #ee8866 #aa3377 #222222", k + 6 - words(sizes))

#-- the tip's displacement in time
set output "tip.png"
set title "Cantilever under a sudden end load: vertical displacement of the top right corner"
set xlabel "time [s]"
set ylabel "u_y"
set xrange [0:5.85]
set yrange [0:*]
set key top left samplen 3 spacing 1.15
plot for [k=1:words(sizes)] history("nodal", word(sizes, k)) using 1:3 with lines lw 2 lc rgb colour(k) title "nodal, h = ".word(sizes, k), \
     for [k=1:words(sizes)] history("elemental", word(sizes, k)) using 1:3 with lines lw 2 dt 2 lc rgb colour(k) title "elemental, h = ".word(sizes, k), \
     "reference/tip_uy_q9_hencky.csv" using 1:2 skip 3 every 12 with points pt 6 ps 0.8 lc rgb "black" title "quadratic elements (Q9), Hencky", \
     "reference/published_peak.csv" using 2:1 skip 2 with points pt 2 ps 2 lw 2 lc rgb "red" title "Belytschko and Bindeman 1993: 6.88"

#-- convergence: the peak, and its distance to the limit
set output "convergence.png"
set multiplot layout 1,2 title "First maximum of u_y and mesh size"
unset title
set logscale x 2
set xlabel "h"
set xrange [0.1:5]
set ylabel "first maximum of u_y"
set yrange [2:10]
set key bottom left
peaks(scheme) = sprintf("< grep ^%s study/peaks.csv", scheme)
plot 6.88 lw 1.5 dt 2 lc rgb "red" title "6.88", \
     peaks("nodal") using 2:3 with linespoints pt 5 lw 2 lc rgb "#4477aa" title "nodal: from above", \
     peaks("elemental") using 2:3 with linespoints pt 7 lw 2 lc rgb "#ee6677" title "elemental: from below", \
     peaks("mixed") using 2:3 with linespoints pt 9 lw 2 lc rgb "#ccbb44" title "mixed (nodal pressure): from below"
set ylabel "|1 - u_y / 6.88|"
set logscale y 10
set format y "10^{%L}"
set yrange [1e-4:1]
set key bottom right
plot 0.06 * x ** 2 lw 1.5 dt 2 lc rgb "#888888" title "second order", \
     peaks("nodal") using 2:(abs(1 - $3 / 6.88)) with linespoints pt 5 lw 2 lc rgb "#4477aa" title "nodal", \
     peaks("elemental") using 2:(abs(1 - $3 / 6.88)) with linespoints pt 7 lw 2 lc rgb "#ee6677" title "elemental", \
     peaks("mixed") using 2:(abs(1 - $3 / 6.88)) with linespoints pt 9 lw 2 lc rgb "#ccbb44" title "mixed"
unset multiplot
