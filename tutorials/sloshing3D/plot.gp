# Picture of a run: waves.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,900 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xrange [0:6]
set yrange [-8:8]
set samples 800
set ylabel "amplitude [mm]"
set key top right horizontal samplen 3 opaque
H = 0.5
frequency(k) = sqrt(9.81*k*tanh(k*H))
wave(k, t) = 5*cos(frequency(k)*t)
box = "< pfemHistory -csv corners elevation"
set output "waves.png"
set multiplot layout 4,1 title "Sloshing: amplitudes of the modes, from the levels at the walls"
set style line 1 lw 5 lc rgb "#bbccee"
set style line 2 lw 1.6 lc rgb "black"
set title "box, mode (1,0)" offset 0,-0.7
plot wave(pi, x) with lines ls 1 title "linear theory", box using 1:(250*($2 - $3 + $4 - $5)) with lines ls 2 title "this run"
set title "box, mode (0,1)"
plot wave(pi/0.8, x) with lines ls 1 notitle, box using 1:(250*($2 + $3 - $4 - $5)) with lines ls 2 notitle
set title "box, mode (1,1)"
plot wave(pi*sqrt(1 + 1/0.64), x) with lines ls 1 notitle, box using 1:(250*($2 - $3 - $4 + $5)) with lines ls 2 notitle
set title "cylinder, first mode"
set xlabel "time [s]"
plot wave(1.8411838/0.5, x) with lines ls 1 notitle, \
     "< pfemHistory -csv -case study/cylinder corners elevation" using 1:(500*($2 - $3)) with lines ls 2 notitle
unset multiplot
