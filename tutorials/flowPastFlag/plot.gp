# Picture of a run: tip.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set output "tip.png"
set multiplot layout 1,2
set key bottom right

set title "Displacement of the flag's tip"
set xrange [0:10]
set ylabel "u_y [mm]"
set yrange [-0.6:1.4]
plot 0.8209 with lines lw 5 lc rgb "#bbccee" title "Turek and Hron, FSI1", \
     "< pfemHistory -csv tip D" using 1:(1e3*$3) with lines lw 1.2 lc rgb "black" title "this run"

#-- means over 0.25 s: the flag rings along its length since its sudden start, and nothing damps that
set title "Drag of cylinder and flag"
set ylabel "drag [N/m]"
set yrange [10:20]
plot 14.295 with lines lw 5 lc rgb "#bbccee" title "Turek and Hron, FSI1", \
     "< pfemHistory -csv force force.dat | awk -F, '/^[0-9]/ { k = int(4*$1); s[k] += $2; n[k]++ } END { for (k = 0; n[k] > 1; k++) print (k + 0.5)/4 \",\" s[k]/n[k] }'" \
     using 1:2 with linespoints pt 7 ps 0.5 lw 1.2 lc rgb "black" title "this run"
unset multiplot
