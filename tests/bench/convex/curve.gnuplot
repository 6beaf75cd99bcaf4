# Draws what accuracy costs: gnuplot -e "csv='curve.csv'; folder='tests/bench/plots'" tests/bench/convex/curve.gnuplot
families = "box capsule hull32 hull1000 ellipsoid cylinder cone"
simplices = "johnson voronoi voronoi_last"
rows(family, kind, simplex, value) = \
  sprintf("< awk -F, '$1==\"%s\" && $2==\"%s\" && $3==\"%s\" {print $4, (%s)}' %s", family, kind, simplex, value, csv)
array colour[3] = ["#d55e00", "#7fd8b5", "#0072b2"]
array width[3] = [1.4, 4, 1.4]  # voronoi and voronoi_last often coincide

set terminal svg size 1120,560 font "sans-serif,11" background "white"
set logscale xy
unset mxtics
unset mytics
set xrange [2e-2:5e-13]
set xtics ("10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10, "10^{-12}" 1e-12)
set format y "10^{%T}"
set grid lc "#dddddd"
set border 31 lc "#666666"

do for [picture in "ns error"] {
  speed = (picture eq "ns")
  value = speed ? "$5" : "$7 > 1e-17 ? $7 : 1e-17"
  set output sprintf("%s/tolerance_%s.svg", folder, picture)
  if (speed) { set yrange [1e2:2e5]; set ytics 10 } else { set yrange [5e-18:1e-1]; set ytics 1e4 }
  set multiplot layout 2,4 title (speed ? "Time a query against the tolerance asked for" \
    : "Error that 99.9 % of the queries keep within, against the tolerance asked for (10^{-17}: none at all)") font ",14"
  set xlabel "tolerance, of the smaller radius"
  set ylabel (speed ? "ns a query" : "error, m")
  unset key
  do for [family in families] {
    set title family
    plot for [i = 1:3] rows(family, "apart", word(simplices, i), value) using 1:2 with lines lc rgb colour[i] \
           lw width[i], \
         for [i = 1:3] rows(family, "deep", word(simplices, i), value) using 1:2 with lines lc rgb colour[i] \
           lw width[i] dt 2, \
         (speed ? NaN : x) with lines lc rgb "#999999" lw 1
  }
  unset border; unset tics; unset xlabel; unset ylabel; unset grid; set title " "
  set key center center samplen 3 spacing 1.6
  plot for [i = 1:3] NaN with lines lc rgb colour[i] lw width[i] title word(simplices, i) noenhanced, \
       NaN with lines lc rgb "#000000" lw 1.4 title "solid: apart", \
       NaN with lines lc rgb "#000000" lw 1.4 dt 2 title "dashed: deep", \
       NaN with lines lc rgb (speed ? "#ffffff" : "#999999") title (speed ? " " : "grey: as asked")
  unset multiplot
  set border 31 lc "#666666"; set grid lc "#dddddd"; set format y "10^{%T}"
  set xtics ("10^{-2}" 1e-2, "10^{-4}" 1e-4, "10^{-6}" 1e-6, "10^{-8}" 1e-8, "10^{-10}" 1e-10, "10^{-12}" 1e-12)
}
