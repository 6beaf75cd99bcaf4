# Draws error against time of rotation methods: gnuplot -e "csv='rotation.csv'; folder='tests/bench/plots'" tests/bench/rotation.gnuplot
methods = "none explicit implicit rk4 lie_midpoint splitting splitting_4 splitting_6 rk4_integrator"
# Rows: ns per body and simulated second, angle, energy. Columns of the benchmark: counters by name, last and quoted.
rows(method) = sprintf("< awk -F, '/^name/ {for (i = 1; i <= NF; ++i) {gsub(/\"/, \"\", $i); at[$i] = i}} " . \
  "{n = split($1, part, \"/\")} part[2] == \"%s\" {print $at[\"ns\"] * part[3], $at[\"angle\"], $at[\"energy\"], part[3]}' %s", \
  method, csv)
colour(i) = word("#999999 #d55e00 #e69f00 #56b4e9 #cc79a7 #0072b2 #009e73 #000000 #bbbbbb", i)

set terminal svg size 1120,520 font "sans-serif,11" background "white"
set output folder . "/rotation.svg"
set logscale xy
unset mxtics
unset mytics
set format y "10^{%T}"
set grid lc "#dddddd"
set border 31 lc "#666666"
set xlabel "microseconds a body and simulated second; dots: 30, 60, ... 960 Hz"
set multiplot layout 1,2 title "A box 1 x 2 x 3 m, left spinning for a minute" font ",14"
do for [picture in "angle energy"] {
  if (picture eq "angle") {
    set ylabel "orientation, rad"; set yrange [1e-12:10]; set key bottom left samplen 2
  } else {
    set ylabel "energy, relative"; set yrange [1e-16:1e2]; unset key
  }
  column = picture eq "angle" ? 2 : 3
  plot for [i = 1:words(methods)] rows(word(methods, i)) using ($1 / 1000):(column(column)) with linespoints pt 7 ps 0.5 \
    lw 2 lc rgb colour(i) title word(methods, i) noenhanced
}
unset multiplot
