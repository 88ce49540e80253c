# Picture of a run: forces.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,420 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time [s]"
set output "forces.png"
both = system("test -d study/Re100/postProcessing && echo 1 || echo 0") + 0
set multiplot layout 1,2
set key bottom right

# means over w seconds: from step to step the triangles beside the cylinder change
means(case, column, factor, w) = sprintf("< pfemHistory -case %s -csv reaction reaction.dat | awk -F, '/^[0-9]/ { k = int($1/%g); s[k] += %g*$%d; n[k]++; if (k > m) m = k } END { for (k = 0; k < m; k++) if (n[k]) print (k + 0.5)*%g \",\" s[k]/n[k] }'", case, w, factor, column, w)

set title "Drag, Re 20"
set xrange [0:6]
set ylabel "c_D"
set yrange [4.5:7]
plot 5.5795 with lines lw 5 lc rgb "#bbccee" title "Schäfer and Turek", \
     means(".", 2, -500, 0.1) using 1:2 with lines lw 1.2 lc rgb "black" title "this run"

if (both) {
    set title "Lift and drag, Re 100"
    set ylabel "c_L, c_D"
    set yrange [-1.5:4]
    set key right top at 5.9, 2.85
    plot 3.23 with lines lw 5 lc rgb "#bbccee" title "Schäfer and Turek: largest c_D", \
         1 with lines lw 5 lc rgb "#eeccbb" title "and c_L", \
         means("study/Re100", 2, -20, 0.02) using 1:2 with lines lw 1.2 lc rgb "black" title "c_D of this run", \
         means("study/Re100", 3, -20, 0.02) using 1:2 with lines lw 1.2 lc rgb "#aa3300" title "c_L"
} else {
    set title "Lift, Re 20"
    set ylabel "c_L"
    set yrange [-0.2:0.2]
    plot 0.0106 with lines lw 5 lc rgb "#bbccee" title "Schäfer and Turek", \
         means(".", 3, -500, 0.1) using 1:2 with lines lw 1.2 lc rgb "black" title "this run"
}
unset multiplot
