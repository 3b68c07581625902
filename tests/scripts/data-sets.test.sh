# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# prepare: what a page needs, or the test is skipped by the name of the missing part.
prepare() {
    /usr/bin/python3 -c 'import numpy' || { echo 'missing: NumPy' && exit 77; }
    [ -f "$MSISF_TESTED_ROOT/input/ldem/LDEM_4.IMG" ] || { echo 'missing: LDEM_4' && exit 77; }
    [ -x "$MSISF_TESTED_ROOT/publish/msis" ] || { echo 'missing: program, run scripts/build.sh' && exit 77; }
    mkdir work bin
    ln -s "$MSISF_TESTED_ROOT/msis" bin/msis
    export PATH="$PWD/bin:$PATH" PYTHONPATH="$MSISF_TESTED_ROOT/clients/python" PYTHONDONTWRITEBYTECODE=1
    export MSISF_PROGRAM="$MSISF_TESTED_ROOT/msis"
    cd work || exit
}

# run_page PAGE: every command of the page.
run_page() {
    run /usr/bin/python3 -B "$MSISF_TESTED_ROOT/tests/scripts/page.py" "$MSISF_TESTED_ROOT/docs/$1" "$MSISF_TESTED_ROOT"
    assert_code 0
}

test_data_sets_every_command_of_the_page_prints_what_the_page_shows() {
    prepare
    run_page data-sets.md
    assert_says '3 blocks'
}

test_data_sets_every_command_of_the_page_of_navigation_runs() {
    prepare
    (. "$MSISF_TESTED_ROOT/scripts/lib/common.sh" && . "$MSISF_TESTED_ROOT/scripts/lib/packages.sh" && part_is_here cfitsio) ||
        { echo 'missing: cfitsio' && exit 77; }
    printf '%s\n' 'id,name,lat,lon,diam_km' T,Tycho,-43.3,-11.2,85 C,Clavius,-58.6,-14.1,231 >craters.csv
    printf '%s\n' Breite,Laenge,D 10,20,50 >krater.txt
    printf '%s\n' 20,10,50000 21,11,30000 >plain.txt
    printf '%s\n' id,lat,lon peak,-43.3,-8.5 >landmarks.csv
    printf '%s\n' time,lat,lon,height 2010-03-25T06:00:00Z,-46,-12,300000 2010-03-25T06:01:00Z,-45.5,-12,295000 >approach.csv
    run_page navigation-truth.md
    assert_says '5 blocks'
    assert_file output/MoonSurfIllumSim_step_00001.flow.png
}
