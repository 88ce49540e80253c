# Picture of a run: depth.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set output "depth.png"
Fr = real(system("pfemDictionary system/flow -entry Fr -value"))
y1 = real(system("pfemDictionary system/flow -entry y1 -value"))
set title sprintf("Hydraulic jump, Fr = %g", Fr)
set ylabel "depth [m]"
set yrange [0:*]
set key bottom right
plot y1/2*(sqrt(1 + 8*Fr**2) - 1) with lines lw 5 lc rgb "#bbccee" title "conjugate depth", \
     "< pfemHistory -csv depth depth" using 1:2 with lines lw 1.6 lc rgb "black" title "before the jump", \
     "" using 1:4 with lines lw 1.6 lc rgb "#0077bb" title "behind it"
