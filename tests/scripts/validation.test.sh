# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# The limits are those that docs/validation.md promises.
test_validation_moon_law_with_the_map_matches_the_real_strip() {
    local data=${MSISF_TESTED_ROOT%/*}/shared correlation rms count
    for part in "$data/validation/wac" "$data/albedo" "$MSISF_TESTED_ROOT/publish/msis" "$MSISF_TESTED_ROOT/input/ldem/LDEM_4.LBL"; do
        [ -e "$part" ] || {
            echo "missing: $(basename "$part")"
            exit 77
        }
    done
    /usr/bin/python3 -c 'import numpy' 2>/dev/null || {
        echo 'missing: numpy'
        exit 77
    }
    /usr/bin/python3 -B "$MSISF_TESTED_ROOT/tests/validation/validate.py" --quick --data "$data/validation" \
        --map "$(find "$data/albedo" -name '*.jpg' -o -name '*.tif' | head -n 1)" --folder "$PWD/strip" >found || fail "$(cat found)"
    read -r correlation rms count <found
    assert_same "$count" 3366
    awk "BEGIN { exit !($correlation >= 0.975 && $rms <= 0.07) }" || fail "correlation $correlation, relative rms $rms"
}
