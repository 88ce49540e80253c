# Picture of a run: wall.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,760 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set output "wall.png"
set multiplot layout 2,1 title "Dam break on an elastic wall, half as wide as its tank"
set ylabel "u_x of the wall's tip [m]"
set key bottom right
plot "< pfemHistory -csv -case study/plane tips D" using 1:2 with lines lw 5 lc rgb "#bbccee" title "as wide as the tank (plane)", \
     "< pfemHistory -csv tips D" using 1:2 with lines lw 1.5 lc rgb "black" title "in the middle of the tank", \
     "" using 1:5 with lines lw 1.5 lc rgb "#cc3311" title "at the wall's own side"
set ylabel "water behind the wall [% of all]"
set key top left
plot "< pfemHistory -csv -case study/plane -columns 'Time volume' behind volumeFlow.dat" using 1:(100*$2/(0.146*0.292)) with lines lw 5 lc rgb "#bbccee" title "as wide as the tank (plane)", \
     "< pfemHistory -csv -columns 'Time volume' behind volumeFlow.dat" using 1:(100*$2/(0.146*0.292*0.06)) with lines lw 1.5 lc rgb "black" title "half as wide"
unset multiplot
