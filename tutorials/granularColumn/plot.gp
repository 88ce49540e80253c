# Picture of the runs: runout.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 900,520 font "DejaVu Sans,11" enhanced
set output "runout.png"
set grid lc rgb "#dddddd"
set logscale xy
set xlabel "aspect ratio a = H/L"
set ylabel "run-out (x_{end} - L)/L"
set xrange [0.4:5]
set yrange [0.4:12]
set key top left Left reverse
end(a) = system(sprintf("pfemHistory -case study/a%s front front.dat | awk '/^ *[0-9]/ { x = $2 } END { print (x - 0.1)/0.1 }'", a)) + 0
set print $runs
do for [a in "0.5 1 2 4"] { print sprintf("%s %g", a, end(a)) }
unset print
plot 2.2*x with lines lw 2 dt 2 lc rgb "#7799cc" title "discs (Lagree et al. 2011), 2.2 a", \
     (x < 1.8 ? 1.2*x : x > 2.8 ? 1.9*x**(2.0/3) : 1/0) with lines lw 2 lc rgb "#7799cc" title "sand and grit (Lube et al. 2005), 1.2 a and 1.9 a^{2/3}", \
     $runs using 1:2 with linespoints pt 7 lw 1.6 lc rgb "black" title "libpfem"
