# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# Port 9 on this machine: nothing listens there, so that a connection is refused.
refusing='http://127.0.0.1:9/lroc_color_poles_{size}.tif'

make_image() {
    mkdir -p "${1%/*}"
    printf 'II*\0 a map' >"$1"
}

test_get_albedo_no_source_says_so() {
    export MSISF_ALBEDO_URLS=$refusing
    make_clone "$PWD/clone"
    run clone/scripts/get-albedo.sh
    assert_code 1
    assert_says 'without its maria'
    assert_same "$(find clone/input/albedo -type f | wc -l | tr -d ' ')" 0
}

test_get_albedo_nasa_comes_before_the_neighbour() {
    make_clone "$PWD/clone"
    make_image site/lroc_color_poles_4k.tif
    make_image shared/albedo/moon_nasa_svs4720_11469x5734.jpg
    MSISF_ALBEDO_URLS="$refusing file://${PWD// /%20}/site/lroc_color_poles_{size}.tif" run clone/scripts/get-albedo.sh --size 4k
    assert_code 0
    assert_says 'lroc_color_poles_4k.tif comes from'
    assert_file clone/input/albedo/lroc_color_poles_4k.tif
    touch -t 202001010000 clone/input/albedo/*
    run clone/scripts/get-albedo.sh
    assert_code 0
    assert_says 'is in place'
}

test_get_albedo_neighbour_folder_shared_is_copied() {
    export MSISF_ALBEDO_URLS=$refusing
    make_clone "$PWD/clone"
    make_image shared/albedo/moon_nasa_svs4720_11469x5734.jpg
    chmod a-w shared/albedo/*
    run clone/scripts/get-albedo.sh
    assert_code 0
    assert_file clone/input/albedo/moon_nasa_svs4720_11469x5734.jpg
}

test_get_albedo_page_in_place_of_an_image_is_not_taken() {
    make_clone "$PWD/clone"
    mkdir site
    echo '<html>not found</html>' >site/lroc_color_poles_8k.tif
    MSISF_ALBEDO_URLS="file://${PWD// /%20}/site/lroc_color_poles_{size}.tif" run clone/scripts/get-albedo.sh
    assert_code 1
    assert_says 'it is no image'
}

test_get_albedo_wrong_size_names_the_right_ones() {
    make_clone "$PWD/clone"
    run clone/scripts/get-albedo.sh --size 3k
    assert_code 1
    assert_says '2k, 4k, 8k and 16k'
}
