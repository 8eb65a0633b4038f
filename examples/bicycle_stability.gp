# Draws the data that bicycle_stability writes: gnuplot -c bicycle_stability.gp data figure.svg
data = ARG1
stats data index 1 using 1 name "weave" nooutput
stats data index 1 using 2 name "capsize" nooutput
from = weave_min
to = capsize_min

set terminal svg size 880,600 name "bicycle_stability" font "sans-serif,15" background "white"
set output ARG2
set encoding utf8
set minussign

grey = "#555555"
blue = "#1f5fa8"
red = "#c0392b"
green = "#2e7d4f"

set border 3 linecolor rgb grey
set xrange [0:10]
set yrange [-10:11]
set xtics 1 nomirror out
set ytics 2 nomirror out
set xlabel "forward speed in m/s"
set ylabel "real and imaginary parts of the eigenvalues in 1/s"
set key bottom right Left reverse samplen 3 spacing 1.2

set object rectangle from from, graph 0 to to, graph 1 behind fillcolor rgb "#e6f1df" fillstyle solid noborder
set arrow from from, graph 0 to from, graph 1 nohead back linecolor rgb grey dashtype 3
set arrow from to, graph 0 to to, graph 1 nohead back linecolor rgb grey dashtype 3
set arrow from 0, 0 to 10, 0 nohead back linecolor rgb grey linewidth 0.6

set label sprintf("weave speed\n%.2f m/s", from) at from - 0.12, 10.2 right textcolor rgb grey
set label sprintf("capsize speed\n%.2f m/s", to) at to + 0.12, 10.2 left textcolor rgb grey
set label "the weave\ngrows" at 3.2, -5.5 center textcolor rgb grey
set label "stays up\nby itself" at (from + to) / 2, -5.5 center textcolor rgb grey
set label "falls slowly\nto one side" at 8, -5.5 center textcolor rgb grey
set label "weave" at 1.35, 3.9 textcolor rgb blue
set label "weave" at 7.1, 6.7 textcolor rgb blue
set label "capsize" at 8, 0.8 center textcolor rgb red
set label "castering" at 1.45, -7.2 textcolor rgb green

# Above 0.7 m/s the weave oscillates, and one line shows both real parts.
plot data index 0 using 1:2 with lines linewidth 2 linecolor rgb blue notitle, \
  "" index 0 using 1:($1 > 0.7 ? NaN : $4) with lines linewidth 2 linecolor rgb blue notitle, \
  "" index 0 using 1:3 with lines linewidth 2 dashtype (10, 6) linecolor rgb blue notitle, \
  "" index 0 using 1:6 with lines linewidth 2 linecolor rgb red notitle, \
  "" index 0 using 1:7 with lines linewidth 2 linecolor rgb green notitle, \
  keyentry with lines linewidth 2 linecolor rgb grey title "real part", \
  keyentry with lines linewidth 2 dashtype (10, 6) linecolor rgb grey title "imaginary part"
