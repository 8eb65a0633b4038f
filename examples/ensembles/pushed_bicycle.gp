# Draws the map that pushed_bicycle writes: gnuplot -c pushed_bicycle.gp points.csv figure.png
points = ARG1
set datafile separator comma
stats points . ".speeds" using 1 every ::1 name "weave" nooutput
stats points . ".speeds" using 2 every ::1 name "capsize" nooutput
set datafile columnheaders

set terminal pngcairo size 980,640 font "sans-serif,14" background "white"
set output ARG2
set encoding utf8
set minussign

grey = "#555555"
set border 3 linecolor rgb grey
set xrange [2:8]
set yrange [0:1.2]
set xtics 1 nomirror out
set ytics 0.2 nomirror out
set xlabel "forward speed in m/s"
set ylabel "push: rate of lean in rad/s"
unset key
unset colorbox
set tmargin 3

# 1: upright again; 2: stays upright, but swings or leans; 3 to 4: falls, darker if sooner
settles(row) = column("late_lean") < 0.01 ? 1 : 2
kind(row) = column("end") < 1 ? settles(0) : 3 + 1 / (1 + column("t_end") / 5)
set cbrange [1:4]
set palette defined (1 "#8fc27d", 1.49 "#8fc27d", 1.5 "#dcebc9", 2.5 "#dcebc9", 2.5 "#f9ede4", 3 "#f6e3d6", 4 "#a5402d")
set arrow from weave_min, 0 to weave_min, 1.2 nohead front linecolor rgb "#1f5fa8" linewidth 2 dashtype 2
set arrow from capsize_min, 0 to capsize_min, 1.2 nohead front linecolor rgb "#1f5fa8" linewidth 2 dashtype 2
set label sprintf("weave speed %.2f m/s ", weave_min) at weave_min, 1.23 right textcolor rgb "#1f5fa8" front
set label sprintf(" capsize speed %.2f m/s", capsize_min) at capsize_min, 1.23 left textcolor rgb "#1f5fa8" front
set label "upright again" at 5.2, 0.3 center front
set label "stays up,\nbut swings" at 3.85, 0.2 center front
set label "falls" at 2.5, 0.7 center textcolor rgb "white" front
set label "falls after a while" at 7.3, 0.3 center front
set label "still leans\nafter 60 s" at 6.6, 0.95 center front
set arrow from 6.3, 0.9 to 6.1, 0.75 front linecolor rgb grey

plot points using (0.3 * column("u3")):"u2":(kind(0)) with image
