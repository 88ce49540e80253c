# Picture of a run: flow.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set output "flow.png"
set title "What flows through the slot"
set ylabel "contraction [-]"
set yrange [0.4:0.8]
set key bottom right
plot pi/(pi + 2) with lines lw 5 lc rgb "#bbccee" title "{/Symbol p}/({/Symbol p} + 2)", \
     "< pfemHistory -csv flow volumeFlow.dat" using 1:($2/(0.04*sqrt(2*9.81*0.3))) with lines lw 1.6 lc rgb "black" title "this run"
