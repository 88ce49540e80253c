# Picture of a run: head.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set output "head.png"
set title "Head of a sharp-crested weir"
set ylabel "level above the crest [m]"
set yrange [0.08:0.12]
set key top right
plot 0.1 with lines lw 5 lc rgb "#bbccee" title "Rehbock", \
     "< pfemHistory -csv head elevation" using 1:2 with lines lw 1.6 lc rgb "black" title "0.5 m in front of it", \
     "" using 1:4 with lines lw 1.6 lc rgb "#0077bb" title "0.3 m"
