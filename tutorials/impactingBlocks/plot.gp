# Picture of a run: motion.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set output "motion.png"
set xlabel "time [s]"
set ylabel "velocity [m/s]"
set xrange [0:0.8]
set yrange [-0.1:3.1]
set key top right
mu = 0.2; g = 9.81; d = 0.3
v1 = sqrt(9 - 2*mu*g*d); t1 = (3 - v1)/(mu*g)
v2 = sqrt(v1**2/4 - 2*mu*g*d); t2 = t1 + (v1/2 - v2)/(mu*g)
t3 = t2 + 2*v2/3/(mu*g)
theory(t) = t < t1 ? 3 - mu*g*t : t < t2 ? v1/2 - mu*g*(t - t1) : t < t3 ? 2*v2/3 - mu*g*(t - t2) : 0
set samples 1000
plot theory(x) with lines lw 5 lc rgb "#bbccee" title "closed form: all that move", \
     "< pfemHistory -csv motion first.dat" using 1:11 with lines lw 1.5 lc rgb "black" title "first block", \
     "< pfemHistory -csv motion second.dat" using 1:11 with lines lw 1.5 dt 2 lc rgb "#aa3333" title "second", \
     "< pfemHistory -csv motion third.dat" using 1:11 with lines lw 1.5 dt 3 lc rgb "#2266aa" title "third"
