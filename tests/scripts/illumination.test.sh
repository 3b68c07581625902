# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

test_illumination_every_command_of_the_page_prints_what_the_page_shows() {
    /usr/bin/python3 -c 'import numpy' || { echo 'missing: NumPy' && exit 77; }
    [ -f "$MSISF_TESTED_ROOT/input/ldem/LDEM_4.IMG" ] || { echo 'missing: LDEM_4' && exit 77; }
    [ -x "$MSISF_TESTED_ROOT/publish/msis" ] || { echo 'missing: program, run scripts/build.sh' && exit 77; }
    mkdir work bin
    ln -s "$MSISF_TESTED_ROOT/msis" bin/msis
    export PATH="$PWD/bin:$PATH" PYTHONPATH="$MSISF_TESTED_ROOT/clients/python" PYTHONDONTWRITEBYTECODE=1
    cd work || exit
    run /usr/bin/python3 -B "$MSISF_TESTED_ROOT/tests/scripts/page.py" "$MSISF_TESTED_ROOT/docs/illumination.md" "$MSISF_TESTED_ROOT"
    assert_code 0
    assert_says '3 blocks'
}
