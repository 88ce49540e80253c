# Pictures of a run: bottom.png, reaction.png, mass.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,520 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set xrange [0:10]
history(what) = "< pfemHistory -csv ".what

set output "bottom.png"
set title "Filling of an elastic container: displacement of the outer bottom point"
set ylabel "u_y [m]"
set yrange [-1.2:0.2]
set key bottom right
plot 0 with lines lc rgb "#888888" lw 0.8 notitle, \
     history("bottom D") using 1:3 with lines lw 2.5 lc rgb "black" title "this run"

set output "reaction.png"
set title "Vertical reaction of the container's ends"
set ylabel "reaction [kN/m]"
set yrange [-50:300]
set key top right
weight = 9.81e-3*(7714.25 + 20*2.97654)
plot weight with lines lw 2 dt 2 lc rgb "#cc3311" title "weight of syrup and container, 76.26 kN/m", \
     history("supports reaction.dat") using 1:($3/1e3) with lines lw 1.2 lc rgb "black" title "this run"

# without the correction: relativeChange - correction/V0, with V0 = volume/(1 + relativeChange)
ledger = "< pfemHistory -csv -columns 'Time relativeChange surface volume' mass fluidVolume.dat"
set output "mass.png"
set title "Fluid mass: change since the start"
set ylabel "change [%]"
set yrange [-2:2]
set key top right
plot 1.5 with lines dt 2 lc rgb "#888888" title "±1.5 %", -1.5 with lines dt 2 lc rgb "#888888" notitle, \
     ledger using 1:(100*$2) with lines lw 2.5 lc rgb "black" title "total", \
     ledger using 1:(100*($2 - $3*(1 + $2)/$4)) with lines lw 1.5 lc rgb "#cc3311" title "total without the surface's shift"
