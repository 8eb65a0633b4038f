# Draws what the programs of work_precision print: gnuplot -c work_precision.gp data figure.svg
data = ARG1

set terminal svg size 980,820 name "work_precision" font "sans-serif,14" background "white"
set output ARG2
set encoding utf8
set minussign

grey = "#555555"
set border 3 linecolor rgb grey
set logscale xy
set format x "10^{%L}"
set format y "10^{%L}"
set xtics nomirror out
set ytics 1e2 nomirror out
set multiplot layout 2, 2 margins 0.1, 0.98, 0.09, 0.95 spacing 0.1, 0.12

array motion = ["a chaotic double pendulum, 10 s", "the bicycle after a push, 10 s", \
                "Andrews' squeezing mechanism, 30 ms", "a pendulum that a stiff controller leads, 10 s"]
array least = [1e-8, 1e-14, 1e-12, 1e-15]
array most = [100, 100, 1, 1e-4]
array from = [1e3, 1e2, 3e2, 1e2]
array to = [1e6, 1e5, 3e5, 1.2e6]
array method = ["adams", "explicit_runge_kutta", "bdf", "implicit_runge_kutta", "differential_algebraic"]
array colour = ["#1f5fa8", "#c0392b", "#2e7d4f", "#d08a1d", "#7a4fa3"]

do for [i = 1:4] {
  set title motion[i] textcolor rgb grey
  set xrange [from[i]:to[i]]
  set yrange [least[i]:most[i]]
  if (i > 2) { set xlabel "evaluations" } else { unset xlabel }
  if (i % 2 == 1) { set ylabel "error of the coordinates at the end" } else { unset ylabel }
  if (i == 2) { set key top right reverse Left samplen 2 noenhanced } else { unset key }
  plot for [k = 1:5] data index (motion[i] . ", " . method[k]) using 2:3 with linespoints pointtype 7 \
       pointsize 0.4 linewidth 1.6 linecolor rgb colour[k] title method[k]
}
