# Pictures of a run: waves.png, piston.png, mass.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,520 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set xrange [0:9]
set samples 900

# linear theory: w^2 = g k tanh kH; wave height over stroke 2 (cosh 2kH - 1)/(sinh 2kH + 2kH)
w = 2*pi
H = 0.3
s = 0.01
k = w**2/9.81
do for [i=1:200] { k = 0.5*k + 0.5*w**2/(9.81*tanh(k*H)) }
a = s*2*(cosh(2*k*H) - 1)/(sinh(2*k*H) + 2*k*H)

#-- the surface at two gauges; theory: a cos(kx - w t) far from the piston, once the waves are steady
set output "waves.png"
set title "Waves of a piston, stroke 20 mm, period 1 s, depth 0.3 m"
set ylabel "elevation [mm]"
set yrange [-24:60]
set ytics ("-10" -10, "0" 0, "10" 10, "-10" 30, "0" 40, "10" 50)
set label 1 "at 1.5 m" at 0.2,5
set label 2 "at 2.5 m" at 0.2,45
set key top right horizontal samplen 3
plot [0:9] (x > 6 ? 1e3*a*cos(k*1.5 - w*x) : 1/0) with lines lw 5 lc rgb "#bbccee" title "linear theory", \
     (x > 6 ? 40 + 1e3*a*cos(k*2.5 - w*x) : 1/0) with lines lw 5 lc rgb "#bbccee" notitle, \
     "< pfemHistory -csv gauges elevation" using 1:(1e3*($2 - H)) with lines lw 1.6 lc rgb "black" title "this run", \
     "" using 1:(40 + 1e3*($4 - H)) with lines lw 1.6 lc rgb "black" notitle
unset label
set ytics auto
set autoscale y

#-- what moves the water, and what it costs
set output "piston.png"
set title "The piston"
set ylabel "displacement [mm]"
set y2label "horizontal force of the water on the piston [N/m]"
set y2tics
set yrange [-11:14]
set y2range [-475:-405]
set ytics nomirror
plot 1e3*s*(x < 2 ? x/2 : 1)*sin(w*x) with lines lw 2 lc rgb "#0077bb" title "displacement", \
     "< pfemHistory -csv force force.dat" using 1:2 axes x1y2 with lines lw 1.2 lc rgb "#cc3311" title "force"
unset y2tics
unset y2label

#-- the fluid's mass; without the correction: relativeChange - correction/V0, with V0 = volume/(1 + relativeChange)
ledger = "< pfemHistory -csv -columns 'Time relativeChange surface volume' mass fluidVolume.dat"
set output "mass.png"
set title "Fluid mass: change since the start"
set ylabel "change [%]"
set key bottom left Left reverse
plot ledger using 1:(100*$2) with lines lw 2.5 lc rgb "black" title "total", \
     ledger using 1:(100*($2 - $3*(1 + $2)/$4)) with lines lw 1.5 lc rgb "#cc3311" title "total without the surface's shift"
