# Draws the points that flip_times writes: gnuplot -c flip_times.gp points.csv figure.png
points = ARG1

set terminal pngcairo size 1080,900 font "sans-serif,14" background "white"
set output ARG2
set encoding utf8
set minussign
set datafile separator comma
set datafile columnheaders

grey = "#555555"
degree = pi / 180
first(row) = column("q1") / degree + 90
second(row) = first(row) + column("q2") / degree
# Time of the flip in seconds, on a logarithmic scale
flip(row) = column("end") > 0 ? log10(column("t_end")) : NaN

# Two pixels of the figure for each of 400 points
set lmargin at screen 115. / 1080
set rmargin at screen 915. / 1080
set bmargin at screen 80. / 900
set tmargin at screen 880. / 900
set border linecolor rgb grey
set xrange [-180:180]
set yrange [-180:180]
set xtics 60 out nomirror
set ytics 60 out nomirror
set xlabel "angle of the first bar in degrees"
set ylabel "angle of the second bar in degrees"
set cbrange [log10(0.4):log10(32)]
set cbtics out ("0.5 s" log10(0.5), "1 s" 0, "2 s" log10(2), "5 s" log10(5), "10 s" 1, "20 s" log10(20))
set palette defined (0 "#f7f3d7", 0.3 "#f0b35a", 0.55 "#c0392b", 0.8 "#4b2a7b", 1 "#10243f")
set label "too little energy\nfor a flip" at 0, 0 center textcolor rgb grey front
unset key

# 3 cos(first) + cos(second) = 2
set parametric
set trange [-acos(1. / 3):acos(1. / 3)]
edge(t) = acos((2 - 3 * cos(t)) < -1 ? -1 : 2 - 3 * cos(t)) / degree

# Points with the first bar to the left are mirror images of the others.
plot points using (first(0)):(second(0)):(flip(0)) with image, \
  "" using (-first(0)):(-second(0)):(flip(0)) with image, \
  t / degree, edge(t) with lines linewidth 1.5 linecolor rgb "#2e7d4f", \
  t / degree, -edge(t) with lines linewidth 1.5 linecolor rgb "#2e7d4f"
