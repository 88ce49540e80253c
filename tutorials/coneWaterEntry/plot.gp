# Picture of the study: force.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,520 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set output "force.png"
set title "A cone of 30 degrees enters water at 4 m/s"
set xlabel "time after contact [ms]"
set xrange [0:25]
set ylabel "force [kN]"
set yrange [0:*]
set key top left Left reverse samplen 3
sizes = system("ls -r study")
k(c, t) = c*1000*4**4*(1e-3*t)**2/tan(pi/6)**3/1000
plot k(256/pi**3, x) with lines lw 4 lc rgb "#bbccee" title "Wagner", \
     k(4.75, x) with lines lw 2 lc rgb "#555555" title "potential flow", \
     k(4, x) with lines lw 4 lc rgb "#ccddaa" title "von Karman", \
     for [size in sizes] "< pfemHistory -csv -case study/".size." force force.dat | tr -d '()'" using (1e3*$1 - 1.25):(1e-3*$4) with lines lw 1.3 title size." mm"
