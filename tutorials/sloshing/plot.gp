# Pictures of a run: wave.png, mass.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,520 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set xrange [0:6]
k = pi
omega = sqrt(9.81*k*tanh(k*0.5))

#-- the water's edge at the left wall
set output "wave.png"
set title "First sloshing mode: elevation of the water at the left wall"
set ylabel "elevation [mm]"
set yrange [-12:14]
set samples 600
set key top right horizontal samplen 3
plot 10*cos(omega*x) with lines lw 5 lc rgb "#bbccee" title "linear theory, T = 1.1818 s", \
     "< pfemHistory -csv gauge D" using 1:(10 + 1e3*$3) with lines lw 1.8 lc rgb "black" title "this run"

#-- the fluid's mass; without the correction: relativeChange - correction/V0, with V0 = volume/(1 + relativeChange)
ledger = "< pfemHistory -csv -columns 'Time relativeChange surface volume' mass fluidVolume.dat"
set output "mass.png"
set title "Fluid mass: change since the start"
set ylabel "change [%]"
set autoscale y
set key bottom left Left reverse
plot ledger using 1:(100*$2) with lines lw 2.5 lc rgb "black" title "total", \
     ledger using 1:(100*($2 - $3*(1 + $2)/$4)) with lines lw 1.5 lc rgb "#cc3311" title "total without the surface's shift"
