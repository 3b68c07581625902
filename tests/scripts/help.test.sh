# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

test_each_script_has_help_and_names_what_it_does_not_know() {
    local script
    for script in quickstart.sh test.sh benchmark.sh scripts/build.sh scripts/get-cspice.sh scripts/release.sh; do
        run "$MSISF_TESTED_ROOT/$script" --help
        assert_code 0
        assert_silent_on '# '
        assert_silent_on 'set -euo'
        [ "$(printf '%s\n' "$output" | wc -l)" -ge 2 ] || fail "$script --help says only: $output"
        run "$MSISF_TESTED_ROOT/$script" --helpp
        assert_code 1
        assert_says 'sage: '
        assert_same "$(printf '%s\n' "$output" | wc -l | tr -d ' ')" 1
    done
}

test_a_signal_ends_what_the_script_has_started() {
    need pgrep
    cat >long.sh <<LONG
#!/usr/bin/env bash
. '$MSISF_TESTED_ROOT/scripts/lib/common.sh'
end_with_children
bash -c 'sleep 61 & sleep 61' &
echo started
wait
LONG
    bash long.sh >said &
    local script=$!
    until grep -q started said; do sleep 0.1; done
    until [ "$(pgrep -cf 'sleep 61')" -ge 2 ]; do sleep 0.1; done
    kill "$script"
    code=0
    wait "$script" || code=$?
    assert_code 143
    sleep 0.2
    assert_same "$(pgrep -f 'sleep 61')" ''
}
