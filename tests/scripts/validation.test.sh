# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# The limits are the figures of docs/validation.md, which promises 0.975 and 7 %.
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
    cp "$MSISF_TESTED_ROOT/docs/validation.md" page.md
    /usr/bin/python3 -B "$MSISF_TESTED_ROOT/tests/validation/twins.py" --page page.md --folder "$PWD/twins" \
        "$data/validation/wac/M1181493219CE.vis.odd.reduced.cub" >found || fail "$(cat found)"
    assert_same "$(grep -c '^| `M1181493219CE' page.md)" 1
    read -r correlation rms count <<NUMBERS
$(/usr/bin/python3 -c 'import json, sys
found = json.load(open(sys.argv[1]))["comparison"]
print(found["correlation"], found["relativeRms"], found["pixels"])' twins/*/*.twin.json)
NUMBERS
    assert_same "$count" 3366
    awk "BEGIN { exit !($correlation >= 0.989 && $rms <= 0.0455) }" || fail "correlation $correlation, relative rms $rms"
}
