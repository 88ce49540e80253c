# Pictures of a run: shape.png, mass.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,520 font "DejaVu Sans,11" enhanced
set grid lc rgb "#dddddd"
set border lw 1.2
set samples 900

# shapes at rest; X from the volume A by bisection (see checkShape)
B = 50/(1000*9.81)
A = 0.4*0.165
a = pi*B/2
area(X) = a*X + ((a*a + 2*B*X)**1.5 - a**3)/(3*B)
low = 0.0
high = 2.0
do for [i=1:60] { X = (low + high)/2; if (area(X) > A) { high = X } else { low = X } }
Xthin = (1.5*A/sqrt(2*B))**(2.0/3)

#-- the depth at the gauges at some times over the closed forms
set output "shape.png"
set title "A column of mud, 0.4 m x 0.165 m, yield stress 50 Pa"
set xlabel "x [m]"
set ylabel "depth [mm]"
set xrange [0:1.02]
set yrange [0:175]
set key top right samplen 3
gauges(case, t) = sprintf("< pfemHistory -case %s depth elevation | awk '!/^#/ && !done && $1 >= %g - 1e-6 { for (s = 2; s <= 10; s++) if ($s > -1) print s == 2 ? 0 : 0.1*(s - 2), 1e3*$s; done = 1 }'", case, t)
other = "study/herschelBulkley"
hasOther = system("test -d " . other . "/postProcessing && echo 1 || echo 0") + 0
plot (x < X ? 1e3*(a + sqrt(a*a + 2*B*(X - x))) : 1/0) with lines lw 5 lc rgb "#bbccee" title "at rest, with the mud's own strength", \
     (x < Xthin ? 1e3*sqrt(2*B*(Xthin - x)) : 1/0) with lines lw 2 dt 2 lc rgb "#7799cc" title "at rest, thin layer (Liu and Mei)", \
     (x < 0.4 ? 165 : 1/0) with lines lw 1 lc rgb "#999999" title "at the start", \
     gauges(".", 0.5) using 1:2 with linespoints pt 6 lw 1 lc rgb "#ee7733" title "0.5 s", \
     gauges(".", 1) using 1:2 with linespoints pt 4 lw 1 lc rgb "#cc3311" title "1 s", \
     gauges(".", 10) using 1:2 with linespoints pt 7 lw 1.6 lc rgb "black" title "10 s", \
     gauges(hasOther ? other : ".", 10) using 1:(hasOther ? $2 : 1/0) with points pt 2 ps 1.3 lc rgb "#009988" title (hasOther ? "10 s, Herschel-Bulkley" : "")

#-- the fluid's mass
ledger = "< pfemHistory -csv -columns 'Time relativeChange surface volume' mass fluidVolume.dat"
set datafile separator ","
set output "mass.png"
set title "Fluid mass: change since the start"
set xlabel "time [s]"
set ylabel "change [%]"
set xrange [0:10]
set autoscale y
set key bottom left Left reverse
plot ledger using 1:(100*$2) with lines lw 2.5 lc rgb "black" title "total", \
     ledger using 1:(100*($2 - $3*(1 + $2)/$4)) with lines lw 1.5 lc rgb "#cc3311" title "total without the surface's shift"
