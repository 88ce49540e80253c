# Picture of a run: motion.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set output "motion.png"
set multiplot layout 1,2
set xlabel "time [s]"
set xrange [0:1.6]
set yrange [-1:1]
set key top right

set title "Heave over the first lift (5 mm)"
plot "reference/potential_theory.csv" using 1:2 with lines lw 5 lc rgb "#bbccee" title "potential theory", \
     "< pfemHistory -csv motion barge.dat" using 1:($6/0.005) with lines lw 1.5 lc rgb "black" title "this run"

set title "Roll over the first roll (5 degrees)"
plot "reference/potential_theory.csv" using 1:3 with lines lw 5 lc rgb "#bbccee" title "potential theory", \
     "< pfemHistory -csv motion barge.dat" using 1:(1 + $10/5) with lines lw 1.5 lc rgb "black" title "this run"
unset multiplot
