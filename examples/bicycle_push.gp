# Draws the motions that the demo writes to a folder: gnuplot -c bicycle_push.gp folder figure.svg
folder = ARG1

set terminal svg size 880,720 name "bicycle_push" font "sans-serif,15" background "white"
set output ARG2
set encoding utf8
set minussign
set datafile separator comma
set datafile columnheaders

grey = "#555555"
blue = "#1f5fa8"
red = "#c0392b"
degree = pi / 180

set border 3 linecolor rgb grey
set xrange [0:10]
set xtics 1 nomirror out format ""
set ytics nomirror out
set arrow from 0, 0 to 10, 0 nohead back linecolor rgb grey linewidth 0.6
set key bottom right horizontal samplen 3
set multiplot layout 3, 1 margins 0.1, 0.97, 0.1, 0.98 spacing 0, 0.05

array speed = ["4.6", "3.5", "3.0"]
array says = ["the swing dies out", "it grows and goes on", "it falls"]
array span = [7.5, 35, 45]
array tics = [2.5, 10, 15]

do for [i = 1:3] {
  file = folder . "/bicycle_at_" . speed[i] . ".csv"
  set yrange [-span[i]:span[i]]
  set ytics tics[i]
  set label 1 speed[i] . " m/s: " . says[i] at graph 0.99, graph 0.92 right textcolor rgb grey
  if (i == 2) { set ylabel "angles in degrees" } else { unset ylabel }
  if (i == 3) { set xtics format "%g"; set xlabel "time in s" }
  plot file using "t":(column("q2") / degree) with lines linewidth 2 linecolor rgb blue \
         title (i == 3 ? "lean" : ""), \
       "" using "t":(column("q5") / degree) with lines linewidth 2 linecolor rgb red \
         title (i == 3 ? "steer" : "")
}
