# gnuplot -e "csv='FILE.csv'; png='FILE.png'; name='SCENE'" tests/soak/scene_soak.gp
set terminal pngcairo size 1200,800 font 'DejaVu Sans,11'
set output png
set datafile separator ','
set key bottom right
set grid
set xlabel 'share of the run'
set multiplot layout 3,1 title name
set xrange [0:1]
set yrange [0:1<*]
set ylabel 'height'
plot csv skip 1 using 1:2 with lines lw 2 lc rgb '#0072B2' title 'mean height'
set ylabel 'entries'
plot csv skip 1 using 1:3 with lines lw 2 lc rgb '#009E73' title 'mean entries'
set key top right
set ylabel 'step, microseconds'
plot csv skip 1 using 1:5 with lines lw 1 lc rgb '#D55E00' title '99th percentile', \
     csv skip 1 using 1:4 with lines lw 2 lc rgb '#000000' title 'median'
unset multiplot
