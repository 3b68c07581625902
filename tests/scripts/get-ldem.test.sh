# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# Port 9 on this machine: nothing listens there, so that a connection is refused.
refusing='http://127.0.0.1:9/ldem_{res}.lbl'

# A clone whose download sites all refuse, and whose program can make a synthetic model.
make_lonely_clone() {
    export MSISF_LDEM_URLS=$refusing
    make_clone "$PWD/clone"
    make_executable clone/publish/msis <<'PROGRAM'
#!/bin/sh
echo "program: $*"
[ -z "$SYNTHESIZED" ] || cp "$SYNTHESIZED"/* input/ldem
PROGRAM
}

assert_model_in_place() {
    assert_same "$(cat clone/input/ldem/LDEM_4.IMG)" 'twelve bytes'
    assert_file clone/input/ldem/LDEM_4.LBL
    assert_same "$(find clone/input/ldem -mindepth 1 | wc -l | tr -d ' ')" 2
}

test_get_ldem_neighbour_folder_shared_is_copied() {
    make_lonely_clone
    make_model shared/ldem LDEM_4 IMG LBL
    chmod a-w shared/ldem/*
    run clone/scripts/get-ldem.sh
    assert_code 0
    assert_says 'comes from'
    assert_model_in_place
}

test_get_ldem_second_run_changes_nothing() {
    make_lonely_clone
    make_model clone/input/ldem LDEM_4 IMG LBL
    touch -t 202001010000 clone/input/ldem/* marker
    run clone/scripts/get-ldem.sh
    assert_code 0
    assert_says 'in place'
    assert_same "$(find clone/input/ldem -newer marker -type f)" ''
}

test_get_ldem_unknown_version_is_taken_with_a_warning() {
    make_lonely_clone
    make_model clone/input/ldem LDEM_4 IMG LBL
    run clone/scripts/get-ldem.sh
    assert_code 0
    assert_says 'not version V3.0'
}

test_get_ldem_refusing_server_gives_way_to_the_next_at_once() {
    need curl
    make_lonely_clone
    make_model 'site' LDEM_4 IMG LBL
    SECONDS=0
    MSISF_LDEM_URLS="$refusing file://${PWD// /%20}/site/LDEM_{res}.LBL" run clone/scripts/get-ldem.sh
    [ "$SECONDS" -lt 4 ] || fail "a refused connection took $SECONDS s"
    assert_code 0
    assert_model_in_place
}

test_get_ldem_names_in_small_letters_become_capitals() {
    need curl
    make_lonely_clone
    make_model 'site' ldem_4 img lbl
    MSISF_LDEM_URLS="file://${PWD// /%20}/site/ldem_{res}.lbl" run clone/scripts/get-ldem.sh
    assert_code 0
    assert_model_in_place
}

test_get_ldem_truncated_download_is_noticed_and_the_next_site_asked() {
    need curl
    make_lonely_clone
    make_model 'short' LDEM_4 IMG LBL
    printf 'half' >short/LDEM_4.IMG
    make_model 'site' LDEM_4 IMG LBL
    site=file://${PWD// /%20}
    MSISF_LDEM_URLS="$site/short/LDEM_4.LBL $site/site/LDEM_4.LBL" run clone/scripts/get-ldem.sh
    assert_code 0
    assert_says 'LDEM_4.IMG has 4 bytes, but its label says 12'
    assert_model_in_place
    rm clone/input/ldem/*
    MSISF_LDEM_URLS="$site/short/LDEM_4.LBL" run clone/scripts/get-ldem.sh --real-only
    assert_code 1
    assert_same "$(ls -A clone/input/ldem)" ''
}

test_get_ldem_page_in_place_of_a_label_is_refused() {
    need curl
    make_lonely_clone
    mkdir site
    echo '<html>log in first</html>' >site/LDEM_4.LBL
    MSISF_LDEM_URLS="file://${PWD// /%20}/site/LDEM_4.LBL" run clone/scripts/get-ldem.sh --real-only
    assert_code 1
    assert_says 'is not the label of an elevation model'
}

test_get_ldem_damaged_model_in_place_is_replaced() {
    make_lonely_clone
    make_model shared/ldem LDEM_4 IMG LBL
    make_model clone/input/ldem LDEM_4 IMG LBL
    printf 'half' >clone/input/ldem/LDEM_4.IMG
    run clone/scripts/get-ldem.sh
    assert_code 0
    assert_says 'LDEM_4.IMG has 4 bytes, but its label says 12'
    assert_model_in_place
}

test_get_ldem_no_source_makes_a_synthetic_model_once_and_says_so() {
    make_lonely_clone
    make_model made LDEM_4_SYNTHETIC IMG LBL
    SYNTHESIZED="$PWD/made" run clone/scripts/get-ldem.sh
    assert_code 10
    assert_says 'making a SYNTHETIC one'
    assert_says 'program: ldem synthesize --res 4 --seed 1'
    run clone/scripts/get-ldem.sh
    assert_code 10
    assert_says 'Going on with the SYNTHETIC model'
    assert_silent_on 'program:'
}

test_get_ldem_synthetic_model_that_was_not_written_is_noticed() {
    make_lonely_clone
    run clone/scripts/get-ldem.sh
    assert_code 1
    assert_says 'please report this'
}

test_get_ldem_real_model_is_preferred_as_soon_as_one_is_found() {
    make_lonely_clone
    make_model clone/input/ldem LDEM_4_SYNTHETIC IMG LBL
    run clone/scripts/get-ldem.sh
    assert_code 10
    make_model shared/ldem LDEM_4 IMG LBL
    run clone/scripts/get-ldem.sh
    assert_code 0
    assert_file clone/input/ldem/LDEM_4.IMG
}

test_get_ldem_no_source_and_no_program_says_what_to_do() {
    make_lonely_clone
    rm clone/publish/msis
    run clone/scripts/get-ldem.sh
    assert_code 1
    assert_says 'into input/ldem'
}

# make_site NAMES...: a site with NASA's split product of 512 px/deg, in small letters.
make_site() {
    local name
    mkdir -p site/img
    for name; do
        make_model site/img "$name" img lbl
    done
    export MSISF_LDEM_URLS="file://${PWD// /%20}/site/{img}/ldem_{res}.lbl"
}

test_get_ldem_split_product_is_fetched_part_by_part_and_goes_on_where_it_stopped() {
    need curl
    make_lonely_clone
    . "$MSISF_TESTED_ROOT/scripts/lib/ldem.sh"
    mapfile -t names < <(products_of_resolution 512 '' | tr '[:upper:]' '[:lower:]')
    make_site "${names[@]:0:5}"
    run clone/scripts/get-ldem.sh --res 512
    assert_code 1
    assert_says 'no source has the elevation model LDEM_512_00N_45N_090_180. Put'
    assert_silent_on 'SYNTHETIC'
    assert_same "$(find clone/input/ldem -name '*.IMG' | wc -l | tr -d ' ')" 5
    make_site "${names[@]}"
    run clone/scripts/get-ldem.sh --res 512
    assert_code 0
    assert_says 'LDEM_512_45N_90N_000_090 is in place'
    assert_same "$(find clone/input/ldem -name '*.IMG' | wc -l | tr -d ' ')" 16
    assert_file clone/input/ldem/LDEM_512_90S_45S_270_360.LBL
}

test_get_ldem_names_of_the_products_are_nasas() {
    . "$MSISF_TESTED_ROOT/scripts/lib/ldem.sh"
    assert_same "$(products_of_resolution 256 _FLOAT | tr '\n' ' ')" \
        'LDEM_256_00N_90N_000_180_FLOAT LDEM_256_00N_90N_180_360_FLOAT LDEM_256_90S_00S_000_180_FLOAT LDEM_256_90S_00S_180_360_FLOAT '
    assert_same "$(products_of_resolution 1024 '' | wc -l | tr -d ' ')" 144
    # As ldem_1024_15s_00s_000_030.img in the archive.
    products_of_resolution 1024 '' | grep -x LDEM_1024_15S_00S_000_030 >found || fail 'the part south of the equator is missing'
    ! products_of_resolution 32 '' || fail 'there is no model of 32 px/deg'
}

test_get_ldem_float_product_has_a_folder_of_its_own() {
    need curl
    make_lonely_clone
    make_site ldem_16
    mkdir site/float_img
    make_model site/float_img ldem_16_float img lbl
    run clone/scripts/get-ldem.sh --res 16 --float
    assert_code 0
    assert_same "$(ls clone/input/ldem)" "$(printf '%s\n' LDEM_16_FLOAT.IMG LDEM_16_FLOAT.LBL)"
    run clone/scripts/get-ldem.sh --res 16
    assert_code 0
    assert_file clone/input/ldem/LDEM_16.IMG
}

test_get_ldem_wrong_arguments_are_named() {
    make_lonely_clone
    run clone/scripts/get-ldem.sh --res 5
    assert_code 1
    assert_says '--res 5'
    run clone/scripts/get-ldem.sh --res
    assert_code 1
    assert_says '--res needs a number'
    run clone/scripts/get-ldem.sh --rez
    assert_code 1
    assert_says 'unknown argument --rez'
}
