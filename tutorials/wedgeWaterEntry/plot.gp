# Pictures of a run: velocity.png, pressure.png, force.png. Run in the case:  gnuplot plot.gp
set terminal pngcairo size 1000,560 font "DejaVu Sans,11" enhanced
set datafile separator ","
set grid lc rgb "#dddddd"
set border lw 1.2
set xlabel "time after the impact [ms]"
g = 9.81
impact = sqrt(2*1.3/g)
ms(t) = 1e3*(t - impact)
history(what) = "< pfemHistory -csv ".what

#-- velocity
set output "velocity.png"
set title "Wedge entering water: velocity"
set ylabel "downward velocity [m/s]"
set xrange [-5:45]
set yrange [1:5.6]
set key top right samplen 3
plot "reference/velocity_experiment_yettou.csv" using 1:2 skip 2 with points pt 6 ps 0.9 lc rgb "#cc3311" title "experiment, Yettou et al. 2006", \
     "reference/velocity_bem_zhao_faltinsen_in_sun2015.csv" using 1:2 skip 2 with lines lw 1.5 lc rgb "#228833" title "boundary elements, Zhao and Faltinsen 1993", \
     "reference/velocity_sph_sun2015_dx2p5mm.csv" using 1:2 skip 2 with lines lw 1.5 lc rgb "#66ccee" title "SPH, Sun et al. 2015", \
     [-5:0] g*(impact + x/1e3) with lines dt 2 lc rgb "#888888" title "free fall", \
     history("apex U") using (ms($1)):(-$3) with lines lw 2.5 lc rgb "black" title "this run"

#-- vertical force per metre of span; the published one is of 1.2 m
set output "force.png"
set title "Wedge entering water: vertical force of the water"
set ylabel "force [kN/m]"
set xrange [-2:45]
set yrange [-5:*]
plot "reference/force_sph_sun2015_dx2p5mm.csv" using 1:($2/1.2e3) skip 2 with lines lw 1.5 lc rgb "#66ccee" title "SPH, Sun et al. 2015", \
     history("force force.dat") using (ms($1)):($3/1e3) with lines lw 2 lc rgb "black" title "this run"

#-- pressure at the face
set output "pressure.png"
set title "Pressure on the wedge's face, segments of 30 mm, averaged over 2 ms"
set ylabel "p [kPa]"
set yrange [-20:160]
set key top right
wagner = (pi/2/tan(25*pi/180))**2
peak(v) = wagner*0.5*v*v  # kPa
array place[5] = ["0.06", "0.12", "0.24", "0.36", "0.48"]
array sensor[5] = [1, 2, 4, 6, 8]
array colour[5] = ["#332288", "#4477aa", "#44aa99", "#ddaa33", "#cc6677"]
plot history("apex U") using (ms($1)):($1 > impact ? peak(-$3) : NaN) with lines lw 1.5 dt 2 lc rgb "#888888" title "Wagner's peak at the wedge's velocity", \
     for [k=1:5] history("face pFiltered") using (ms($1)):(column(sensor[k]+1)/1e3) with lines lw 1.8 lc rgb colour[k] title place[k]." m from the middle"
