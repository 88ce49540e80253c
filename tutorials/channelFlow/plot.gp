# Picture of a run: flow.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set output "flow.png"
set multiplot layout 1,2
mu = 0.5; U = 0.1; H = 0.1

#-- the last row: nine probes, three components each
set title "Velocity across the channel at x = 0.2 m"
set xlabel "u [m/s]"
set ylabel "y [m]"
set xrange [0:0.16]
set yrange [0:H]
set key left center
set parametric
set trange [0:H]
plot 6*U*t*(H - t)/H**2,t with lines lw 5 lc rgb "#bbccee" title "6 U y (H - y)/H^2", \
     "< pfemHistory -csv profile U | tail -n 1 | awk -F, '{ for (k = 1; k <= 9; k++) print $(3*k - 1) \",\" k/100 }'" \
     using 1:2 with points pt 7 ps 1.2 lc rgb "black" title "this run, at the end"
unset parametric

set title "Pressure along the axis"
set xlabel "time [s]"
set ylabel "p [Pa]"
set autoscale
set key off
plot for [k=1:5] "< pfemHistory -csv axis p" using 1:(column(k + 1)) with lines lw 1.5, \
     for [k=1:5] 60*(0.3 - 0.05*k) with lines dt 2 lc rgb "black"
unset multiplot
