# Draws what effects cost: gnuplot -e "csv='effects.csv'; folder='tests/bench/plots'" tests/bench/effects.gnuplot
# Rows: the effect, ns a customer and step, ms a scene; dearest last, those that cost nothing measurable left out.
rows = sprintf("< awk -F, 'NR > 1 {name = $1; at = 2; if (name ~ /^\"/ && name !~ /\"$/) {name = name \",\" $2; at = 3} " . \
  "gsub(/\"/, \"\", name); gsub(/_/, \" \", name); if ($(at + 3) > 0) print $(at + 3) \"\\t\" name \" (\" $at \" \" $(at + 1) \")\"}' %s | sort -g", csv)

set terminal svg size 900,640 font "sans-serif,11" background "white"
set output folder . "/effects.svg"
set datafile separator "\t"
set logscale x
unset mxtics
set grid x lc "#dddddd"
set border 3 lc "#666666"
set xlabel "ns a customer and step: the scene with them, less the same scene with the effect forbidden"
set title "What an effect costs" font ",14"
set lmargin 42
unset key
set offsets 0, 0, 0.5, 0.5
set style fill solid
plot rows using 1:0:(0.1):1:($0 - 0.35):($0 + 0.35):ytic(2) with boxxyerror lc rgb "#0072b2"
