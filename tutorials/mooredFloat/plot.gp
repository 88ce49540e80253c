# Picture of a run: motion.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set output "motion.png"
set multiplot layout 1,2
set xlabel "time [s]"
set xrange [0:7.5]
set yrange [-16:16]
set key top left

set title "Sway [mm]"
plot "reference/potential_theory.csv" using 1:2 with lines lw 5 lc rgb "#bbccee" title "potential theory", \
     "< pfemHistory -csv motion barge.dat" using 1:(1e3*$5) with lines lw 1.5 lc rgb "black" title "this run"

set title "Heave [mm]"
plot "reference/potential_theory.csv" using 1:3 with lines lw 5 lc rgb "#bbccee" title "potential theory", \
     "< pfemHistory -csv motion barge.dat" using 1:(1e3*$6) with lines lw 1.5 lc rgb "black" title "this run"
unset multiplot
