# Draws times beside kanexpr's: gnuplot -c peers.gp data figure.svg
data = ARG1

set terminal svg size 980,900 name "peers" font "sans-serif,14" background "white"
set output ARG2
set encoding utf8
set minussign

grey = "#555555"
set border 3 linecolor rgb grey
set logscale y
set format y "%g"
set datafile columnheaders
set xrange [-0.5:4.5]
set yrange [0.1:*]
set ytics nomirror
set grid ytics linecolor rgb "#dddddd"
set xtics ("pendulum" 0, "Puma" 1, "iiwa" 2, "quadruped" 3, "bicycle" 4) nomirror out
set arrow from -0.5, 1 to 4.5, 1 nohead back linecolor rgb grey linewidth 0.8

stats data using 0 nooutput
peers = STATS_blocks
array colour = ["#1f5fa8", "#6fa8dc", "#17becf", "#9edae5", "#0b7a75", "#7fcdbb", "#e377c2", "#7a4fa3", "#c0392b", "#e59866", "#7b241c", "#2e7d4f", "#d08a1d", "#555555", "#aaaaaa"]
array result = ["M + f", "u̇", "∂u̇"]
group = (peers + 2) / 3 # beside each of the three plots a third of the names
set key at graph 1.03, 0.98 left top reverse Left samplen 1 noenhanced
set multiplot layout 3, 1 margins 0.09, 0.72, 0.05, 0.97 spacing 0.06, 0.06
do for [r = 0:2] {
  set label 1 result[r + 1] at graph 0.01, 0.93 textcolor rgb grey
  set ylabel (r == 1 ? "time of a call, kanexpr by g++ = 1" : "") offset 1
  last = group * (r + 1) > peers ? peers : group * (r + 1)
  plot for [k = 0:(peers - 1)] data index k \
       using ($2 == r ? $1 + 0.06 * (k - 0.5 * (peers - 1)) : NaN):3:4:5 with yerrorbars \
       pointtype 7 pointsize 0.5 linecolor rgb colour[k + 1] notitle, \
       for [k = (group * r):(last - 1)] data index k using (NaN):3:4:5 with yerrorbars \
       pointtype 7 pointsize 0.5 linecolor rgb colour[k + 1] title columnheader(1)
}
