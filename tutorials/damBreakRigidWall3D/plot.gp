# Pictures of a run beside the plane one and the experiment: front.png, pressure.png, levels.png. Run in the case:  gnuplot plot.gp
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
H = 0.3
unit = sqrt(9.81/H)       # t* = unit t
pUnit = 997*9.81*H        # p* = p/pUnit
shift = 0.055             # the experiment's clock starts with the gate (see README)
star(t) = t*unit + shift
dry(p) = p < -1e299 ? 0 : p
reference = system("echo ${PFEM_PROJECT_DIR:-../..}")."/tutorials/damBreakRigidWall/reference/"
history(what) = "< pfemHistory -csv ".what
plane(what) = "< pfemHistory -csv -case study/plane ".what

#-- front and residual height
set terminal pngcairo size 1000,520 font "DejaVu Sans,11" enhanced
set output "front.png"
set title "Dam break: front of the water"
set xlabel "t* = t sqrt(g/H)"
set xrange [0:4]
set yrange [0:3.6]
set key top left Left reverse samplen 3
plot reference."front_position_H300.csv" using 1:2 skip 2 with points pt 6 ps 0.7 lc rgb "#cc3311" title "front x/H, Lobovsky et al. 2014", \
     history("front front.dat") using (star($1)):(($2-0.6)/H) with lines lw 2.5 lc rgb "black" title "front, in space", \
     plane("front front.dat") using (star($1)):(($2-0.6)/H) with lines lw 1.5 lc rgb "#4477aa" title "front, in the plane"

#-- pressure at the four sensors
set terminal pngcairo size 1100,900 font "DejaVu Sans,10" enhanced
set output "pressure.png"
set multiplot layout 2,2 title "Pressure at the wall: disc of 4.2 mm, averaged over 5 ms"
set xrange [2:7]
set ylabel "p* = p/(rho g H)"
set key top right samplen 2
array file[4] = ["1_h3mm", "2_h15mm", "3_h30mm", "4_h80mm"]
array place[4] = ["3 mm", "15 mm", "30 mm", "80 mm"]
array top[4] = [4, 3, 2.5, 2]
do for [k=1:4] {
    set title place[k]." above the bottom"
    set yrange [-0.2:top[k]]
    plot reference."pressure_sensor".file[k].".csv" using 1:3:4 skip 2 with filledcurves lc rgb "#f2cfc9" notitle, \
         "" using 1:2 skip 2 with lines lw 1.2 lc rgb "#cc3311" title "Lobovsky et al. 2014", \
         plane("sensors pFiltered") using (star($1)):(column(k+1)/pUnit) with lines lw 1.3 lc rgb "#4477aa" title "in the plane", \
         history("sensors pFiltered") using (star($1)):(column(k+1)/pUnit) with lines lw 1.6 lc rgb "black" title "in space"
}
unset multiplot

#-- water levels
set terminal pngcairo size 1100,800 font "DejaVu Sans,10" enhanced
set output "levels.png"
set multiplot layout 2,2 title "Water levels"
set xrange [0:7]
set yrange [0:1.2]
set ylabel "h/H"
array where[4] = ["0.300", "0.865", "1.114", "1.3625"]
do for [k=1:4] {
    set title "gauge at x = ".where[k]." m"
    plot reference.sprintf("water_level_H%d_run01.csv", k) using 1:2 skip 2 with lines lw 1.5 lc rgb "#cc3311" title "Lobovsky et al. 2014", \
         plane("levels elevation") using (star($1)):(dry(column(k+1))/H) with lines lw 1.3 lc rgb "#4477aa" title "in the plane", \
         history("levels elevation") using (star($1)):(dry(column(k+1))/H) with lines lw 1.8 lc rgb "black" title "in space"
}
unset multiplot
