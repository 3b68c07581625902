# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

test_camera_export_every_command_of_msis_on_the_page_runs() {
    need gdalinfo
    [ -f "$MSISF_TESTED_ROOT/input/ldem/LDEM_4.IMG" ] || { echo 'missing: LDEM_4' && exit 77; }
    [ -x "$MSISF_TESTED_ROOT/publish/msis" ] || { echo 'missing: program, run scripts/build.sh' && exit 77; }
    mkdir work bin
    ln -s "$MSISF_TESTED_ROOT/msis" bin/msis
    export PATH="$PWD/bin:$PATH"
    cd work || exit
    run /usr/bin/python3 -B "$MSISF_TESTED_ROOT/tests/scripts/page.py" "$MSISF_TESTED_ROOT/docs/camera-export.md" "$MSISF_TESTED_ROOT"
    assert_code 0
    assert_says '3 blocks'
}
