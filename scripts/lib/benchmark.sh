# shellcheck shell=bash
# Sourced by benchmark.sh after common.sh and data.sh: the models that it measures on, and where its tables go.


# make_model FOLDER NAME BASE SYNTHESIZE-OPTIONS...: once; a synthetic model that continues BASE downwards, in integers as NASA's.
make_model() {
    local folder=$1 name=$2 base=$3
    shift 3
    [ ! -f "$folder/$name.LBL" ] || return 0
    say "Making the synthetic model $name ..."
    ./msis ldem synthesize "$@" --sample-type int16 --base "$base" --seed 1 --output-dir "$folder" --batch
    [ -f "$folder/$name.LBL" ] || die "msis ldem synthesize ended well, but did not write $folder/$name.LBL: please report this"
}

# publish_performance FOLDER: what a whole run has left there goes into the docs; plots of scenes that are no more go out.
publish_performance() {
    replace_block docs/performance.md "$1/summary.md"
    replace_block docs/performance.md "$1/scaling.md" series
    replace_block tests/Msisf.Benchmarks/results/performance-tables.md "$1/tables.md"
    rm -f tests/Msisf.Benchmarks/results/front-*.svg
    cp "$1"/{figures,targets,front}.csv "$1"/{time,error,memory}.svg "$1"/front-*.svg tests/Msisf.Benchmarks/results/
}

# replace_block FILE BLOCK [NAME]: puts the text of BLOCK between the two marks of FILE, which stay; NAME is in the marks where a page has several.
replace_block() {
    local file=$1 fresh=$1.partial begin_mark="<!-- benchmark.sh: ${3:+$3 }begin -->" end_mark="<!-- benchmark.sh: ${3:+$3 }end -->"
    [ "$(grep -Fx -e "$begin_mark" -e "$end_mark" "$file")" = "$begin_mark"$'\n'"$end_mark" ] ||
        die "$file needs the lines $begin_mark and $end_mark, each once and in this order: the text stays in $2"
    {
        sed "/^$begin_mark\$/q" "$file"
        printf '\n'
        cat "$2"
        printf '\n'
        sed -n "/^$end_mark\$/,\$p" "$file"
    } >"$fresh"
    mv "$fresh" "$file"
}

# validate FOLDER [LABEL...]: compares what the program draws with a real image; tables and plots go into the docs. With labels only
# their lines in the table of twins.
validate() {
    local folder=$1 data map strip
    shift
    data=$(dirname "$PWD")/shared/validation
    strip=$data/wac/M1181493219CE.vis.odd.reduced.cub
    [ $# -gt 0 ] || [ -f "$strip" ] ||
        die "--validate needs the LROC strip $(basename "$strip") of USGS's ISIS test data in $(dirname "$strip"), or labels of other images"
    install_parts matplotlib gdal-library downloader certificates
    scripts/build.sh
    fetch_data ldem >/dev/null || die '--validate needs the real elevation model LDEM_4'
    scripts/get-cspice.sh >/dev/null || say 'Going on without CSPICE, with the built-in kernel reader.'
    fetch_data albedo >/dev/null || die '--validate needs the map of the reflectance'
    mkdir -p "$folder"
    if [ $# -gt 0 ]; then
        /usr/bin/python3 -B tests/validation/twins.py --page docs/validation.md --folder "$folder" "$@"
        say "The lines are in docs/validation.md, the pages in $folder."
        return
    fi
    map=$(find input/albedo -maxdepth 1 -type f ! -name README.md ! -name '.*' | sort | head -n 1)
    /usr/bin/python3 -B tests/validation/validate.py --data "$data" --map "$map" --folder "$folder"
    replace_block docs/validation.md "$folder/validation.md"
    mkdir -p docs/validation
    cp "$folder"/strip.png "$folder"/scatter.svg "$folder"/disc.svg docs/validation/
    /usr/bin/python3 -B tests/validation/twins.py --page docs/validation.md --folder "$folder" "$strip"
    say 'The tables are in docs/validation.md, the plots in docs/validation/.'
}

# publish_stress FOLDER: what a run of the stress tests has left there goes into the docs; plots of tests that are no more go out.
publish_stress() {
    replace_block docs/accuracy.md "$1/promises.md"
    replace_block tests/Msisf.Benchmarks/results/accuracy-tables.md "$1/tables.md"
    rm -f tests/Msisf.Benchmarks/results/stress_*.svg
    cp "$1"/stress.csv "$1"/stress_machine.csv "$1"/stress_series.csv "$1"/stress_*.svg tests/Msisf.Benchmarks/results/
}
