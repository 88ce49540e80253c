# Picture of a run: tips.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,520 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set ylabel "u_x of the wall's tip [m]"
set key top right
set output "tips.png"
set title "Dam break on an elastic wall: in the plane and in space, a strip between slippery sides"
runs = system("ls -d study/plane-*")
plot for [run in runs] "< pfemHistory -csv -case ".run." tips D" using 1:2 with lines lw 3 lc rgb "#bbccee" title (run eq word(runs, 1) ? "plane, five runs" : ""), \
     "< pfemHistory -csv tips D" using 1:2 with lines lw 1.5 lc rgb "#cc3311" title "space, at one side", \
     "" using 1:5 with lines lw 1.5 lc rgb "black" title "in the middle", \
     "" using 1:8 with lines lw 1.5 lc rgb "#009988" title "at the other side"
