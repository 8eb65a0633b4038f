# Draws the results that identified_friction writes: gnuplot -c identified_friction.gp estimates.csv figure.svg
estimates = ARG1
set datafile separator comma
bound = estimates . ".bound"
stats bound using 1 every ::1 name "c" nooutput
stats bound using 2 every ::1 name "k" nooutput
stats bound using 3 every ::1 name "cc" nooutput
stats bound using 4 every ::1 name "ck" nooutput
stats bound using 5 every ::1 name "kk" nooutput
set datafile columnheaders

set terminal svg size 980,460 name "identified_friction" font "sans-serif,14" background "white"
set output ARG2
set encoding utf8
set minussign

grey = "#555555"
blue = "#1f5fa8"
red = "#c0392b"
set border 3 linecolor rgb grey
set multiplot layout 1, 2
set xtics nomirror out
set ytics nomirror out

set xlabel "time in s"
set ylabel "angle in rad"
set key top right samplen 2
set xrange [0:10]
plot estimates . ".record" using "t":"measured" with points pointtype 7 pointsize 0.3 linecolor rgb grey \
       title "measured", \
     "" using "t":"fitted" with lines linewidth 1.5 linecolor rgb red title "with the friction found"

# The ellipses that should contain given fractions of all estimates: L (cos t, sin t), where L L' is the bound.
a = sqrt(cc_min)
b = ck_min / a
d = sqrt(kk_min - b * b)
within(part) = sqrt(-2 * log(1 - part))
set xlabel "viscous friction in N m s"
set ylabel "dry friction in N m"
set parametric
set trange [0:2 * pi]
set xrange [c_min - 4 * a:c_min + 4 * a]
set yrange [k_min - 4 * sqrt(kk_min):k_min + 4 * sqrt(kk_min)]
set xtics 0.001
set format x "%.3f"
set format y "%.3f"
plot estimates using "c":"k" with points pointtype 7 pointsize 0.3 linecolor rgb grey title "of each record", \
     c_min + within(0.5) * a * cos(t), k_min + within(0.5) * (b * cos(t) + d * sin(t)) with lines linewidth 1.5 \
       linecolor rgb blue title "bound: 50 %", \
     c_min + within(0.95) * a * cos(t), k_min + within(0.95) * (b * cos(t) + d * sin(t)) with lines linewidth 1.5 \
       linecolor rgb blue dashtype 2 title "bound: 95 %"
