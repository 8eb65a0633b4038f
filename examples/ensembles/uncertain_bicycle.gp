# Draws the fractions that uncertain_bicycle writes: gnuplot -c uncertain_bicycle.gp shares.csv figure.svg
shares = ARG1
set datafile separator comma
set datafile columnheaders

set terminal svg size 880,560 name "uncertain_bicycle" font "sans-serif,14" background "white"
set output ARG2
set encoding utf8
set minussign

grey = "#555555"
set border 3 linecolor rgb grey
set xrange [1:6]
set yrange [0:4]
set xtics 1 nomirror out
set ytics 1 nomirror out
set xlabel "forward speed in m/s"
set ylabel "push: rate of lean in rad/s"
set cbrange [0:100]
set cbtics 25 out
set cblabel "bicycles that stay up, in percent"
set palette defined (0 "#a5402d", 50 "#f6e3d6", 100 "#8fc27d")
set tmargin 3
set key at graph 1, 1.1 horizontal samplen 3

plot shares using "v":"push":(100 * column("share")) with image notitle, \
  "" using "v":"border" with lines linewidth 2 dashtype 2 linecolor rgb "#1f5fa8" \
    title "border of the bicycle that the controller knows"
