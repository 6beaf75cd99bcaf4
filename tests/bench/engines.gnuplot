# Draws Carom beside other engines:
#   gnuplot -e "csv='engines.csv'; steps='engine_steps.csv'; folder='tests/bench/plots'" tests/bench/engines.gnuplot
set datafile separator ","
set border 3 lc "#666666"
set grid lc "#dddddd"
set style line 1 lc rgb "#e69f00" lw 1 pt 5 ps 0.7
set style line 2 lc rgb "#009e73" lw 1 pt 9 ps 0.8
set style line 3 lc rgb "#d55e00" lw 1 pt 11 ps 0.8
set style line 4 lc rgb "#cc79a7" lw 1 pt 13 ps 0.9
set style line 5 lc rgb "#0072b2" lw 2 pt 7 ps 1.1
names = "Rapier Box3D PhysX Jolt Carom"
# An engine's lines: those in single precision where there are two; threads left out.
of(name) = sprintf("grep -E '^[^,]*,\"%s' %%s | grep -vE '%s'", name, name eq "Rapier" ? "double|threads" : "threads")

# ---- time by row, over the best peer's ----
set terminal svg size 900,620 font "sans-serif,11" background "white"
set output folder . "/engines.svg"
rows = system(sprintf("tail -n +2 %s | cut -d, -f1 | awk '!seen[$0]++'", csv))
at(row) = words(rows) - int(system(sprintf("echo '%s' | tr ' ' '\\n' | grep -nx '%s' | cut -d: -f1", join, row)))
join = ""
do for [i = 1:words(rows)] { join = join . (i > 1 ? " " : "") . word(rows, i) }
unset ytics
do for [i = 1:words(rows)] { set ytics add (word(rows, i) words(rows) - i) }
set logscale x
set xlabel "time a step (S10: of all rays, S11: bytes a body) over that of the best peer that holds; left of 1 is faster"
set title "Carom beside other engines" font ",14"
set key outside top right
set yrange [-0.7:words(rows) - 0.3]
set arrow from 1, graph 0 to 1, graph 1 nohead lc "#666666" dt 2
plot for [i = 1:words(names)] sprintf("< " . of(word(names, i)), csv) \
  using (column(11) > 0 && column(10) == 1 ? column(11) : NaN):(at(strcol(1))) with points ls i title word(names, i)

# ---- each step of four scenes ----
unset arrow
unset logscale x
set terminal svg size 900,700 font "sans-serif,11" background "white"
set output folder . "/engine_steps.svg"
set multiplot layout 2, 2 title "Time of each step" font ",14"
set ytics auto
set yrange [*:*]
set logscale y
set xlabel "s"
set ylabel "ms"
unset title
set key inside top right
do for [row in "S1-1024 S2 S5m-25 dolls"] {
  set title row font ",12"
  plot for [i = 1:words(names)] sprintf("< " . of(word(names, i)) . " | grep '^%s,'", steps, row) \
    using (column(3) / 60):4 with lines ls i title word(names, i)
}
unset multiplot
