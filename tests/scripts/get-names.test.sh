# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# Port 9 on this machine: nothing listens there, so that a connection is refused.
export MSISF_NAMES_URLS='http://127.0.0.1:9/names.csv'
export MSISF_STELLARIUM_DATA=/nowhere

test_get_names_no_source_says_so() {
    make_clone "$PWD/clone"
    run clone/scripts/get-names.sh
    assert_code 1
    assert_says 'the 300 largest'
    assert_same "$(find clone/input/names -name '*.csv' | wc -l | tr -d ' ')" 0
}

test_get_names_gazetteer_is_taken_without_what_has_no_size() {
    make_clone "$PWD/clone"
    mkdir site
    printf '%s\r\n' 'Feature_ID,Feature_Name,Diameter,Center_Latitude,Center_Longitude' \
        '6163,Tycho,85.29,-43.3,348.78' '1,"Statio, Tranquillitatis",0,0.8,23.5' '2,"Montes, a b",599.7,19.9,0.03' >site/names.csv
    MSISF_NAMES_URLS="http://127.0.0.1:9/names.csv file://${PWD// /%20}/site/names.csv" run clone/scripts/get-names.sh
    assert_code 0
    assert_says '2 named features come from'
    assert_same "$(cat clone/input/names/names.csv)" "$(printf '%s\n' 'name,diameter_km,latitude,longitude' \
        '"Tycho",85.29,-43.3,348.78' '"Montes, a b",599.7,19.9,0.03')"
    run clone/scripts/get-names.sh
    assert_code 0
    assert_says 'in place'
}

test_get_names_stellarium_has_them_of_the_moon_alone() {
    make_clone "$PWD/clone"
    mkdir data
    printf '%s\n' '# a comment' $'Mars\t1\t_("Gale","crater")\tAA\t-5.4\t137.8\t154' \
        $'Moon\t6163\t_("Tycho","crater")\tAA\t-43.295800\t348.784700\t85.2943' | gzip >data/nomenclature.dat
    MSISF_STELLARIUM_DATA=$PWD/data run clone/scripts/get-names.sh
    assert_code 0
    assert_same "$(tail -n +2 clone/input/names/names.csv)" '"Tycho",85.2943,-43.295800,348.784700'
}

test_get_names_page_in_place_of_a_list_is_not_taken() {
    make_clone "$PWD/clone"
    mkdir site
    echo '<html>not found</html>' >site/names.csv
    MSISF_NAMES_URLS="file://${PWD// /%20}/site/names.csv" run clone/scripts/get-names.sh
    assert_code 1
    assert_says 'holds no names'
}
