# Picture of a run: sea.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set output "sea.png"
set title "The sea at the first gauge, H_{m0} = 40 mm, T_p = 1.4 s"
set ylabel "elevation [mm]"
set xrange [20:60]
set yrange [-40:40]
set key off
plot "< pfemHistory -csv gauges elevation" using 1:(1e3*($2 - 0.4)) with lines lw 1.6 lc rgb "black"
