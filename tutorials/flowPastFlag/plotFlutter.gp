# Picture of a flag that flutters: flutter.png. Run in its case:  gnuplot ../../plotFlutter.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set autoscale xfix
set output "flutter.png"
fsi = system("pfemDictionary system/benchmark -entry FSI -value") + 0
level = fsi == 3 ? 1.48 : 1.23
swing = fsi == 3 ? 34.38 : 80.6
force = fsi == 3 ? 457.3 : 208.83
width = fsi == 3 ? 22.66 : 73.75
bin = fsi == 3 ? 0.008 : 0.02  # a 25th of the period
means = sprintf("< pfemHistory -csv force force.dat | awk -F, -v w=%g '/^[0-9]/ { k = int($1/w); s[k] += $2; n[k]++; if (k > last) last = k } END { for (k = 0; k <= last; k++) if (n[k]) print (k + 0.5)*w \",\" s[k]/n[k] }'", bin)
set multiplot layout 1,2
set key below left Left reverse
set bmargin 6

set title "Displacement of the flag's tip"
set ylabel "u_y [mm]"
plot level + swing with lines lw 4 lc rgb "#bbccee" title sprintf("Turek and Hron, FSI%d: mean +- amplitude", fsi), \
     level - swing with lines lw 4 lc rgb "#bbccee" notitle, \
     "< pfemHistory -csv tip D" using 1:(1e3*$3) with lines lw 1.2 lc rgb "black" title "this run"

set title "Drag of cylinder and flag"
set ylabel "drag [N/m]"
set yrange [0:2*force]
plot force + width with lines lw 4 lc rgb "#bbccee" title sprintf("Turek and Hron, FSI%d: mean +- amplitude", fsi), \
     force - width with lines lw 4 lc rgb "#bbccee" notitle, \
     means using 1:2 with lines lw 1.2 lc rgb "black" title "this run"
unset multiplot
