# shellcheck shell=bash disable=SC2317 # stand-ins are called by what is tested
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"
. "$MSISF_TESTED_ROOT/scripts/lib/common.sh"
. "$MSISF_TESTED_ROOT/scripts/lib/packages.sh"

# A stand-in for apt-get that writes down its calls; its first $REFUSALS installations fail.
fake_apt() {
    export CALLS=$PWD/calls REFUSALS=${1:-0} PATH="$PWD/bin:$PATH"
    : >"$CALLS"
    make_executable bin/apt-get <<'APT'
#!/usr/bin/env bash
echo "apt-get $*" >>"$CALLS"
case $* in
    *install*) [ "$(grep -c install "$CALLS")" -gt "$REFUSALS" ] || { echo 'E: no such package' >&2; exit 100; } ;;
esac
APT
    as_root() { "$@"; }
    start_policy=$PWD/policy-rc.d
}

test_packages_nothing_missing_leaves_apt_alone() {
    fake_apt
    run install_parts bash sh
    assert_code 0
    assert_same "$(cat "$CALLS")" ''
}

test_packages_only_what_is_missing_is_installed() {
    fake_apt
    run install_parts bash missing-one missing-two
    assert_code 0
    assert_says 'Installing with apt: missing-one missing-two'
    assert_same "$(wc -l <"$CALLS" | tr -d ' ')" 1
    case $(cat "$CALLS") in *'install -y --no-install-recommends missing-one missing-two') ;; *) fail "$(cat "$CALLS")" ;; esac
}

test_packages_lists_are_renewed_only_after_a_refusal() {
    fake_apt 1
    run install_parts missing-one
    assert_code 0
    assert_same "$(sed 's/.*Timeout=120 \([a-z]*\).*/\1/' "$CALLS" | tr '\n' ' ')" 'install update install '
}

test_packages_refused_for_good_says_what_to_do() {
    fake_apt 9
    run install_parts missing-one
    assert_code 1
    assert_says 'E: no such package'
    assert_says 'As root, run: apt-get update && apt-get install missing-one'
}

test_packages_installation_starts_no_daemon() {
    fake_apt
    make_executable bin/apt-get <<'APT'
#!/bin/sh
./policy-rc.d || echo "policy says $?" >>"$CALLS"
exit "${APT_CODE:-0}"
APT
    run install_parts missing-one
    assert_code 0
    assert_same "$(cat "$CALLS")" 'policy says 101'
    assert_no_file policy-rc.d
    APT_CODE=100 run install_parts missing-one
    assert_code 1
    assert_no_file policy-rc.d
}

test_packages_own_start_policy_is_left_alone() {
    fake_apt
    echo own >policy-rc.d
    run install_parts missing-one
    assert_code 0
    assert_same "$(cat policy-rc.d)" own
}

test_packages_slurm_comes_without_accounting() {
    assert_same "$(packages_of apt slurm parallel)" 'slurmctld slurmd slurm-client munge parallel'
}

# A PATH with these programs only.
only_programs() {
    mkdir only
    local program
    for program in "$@"; do
        ln -s "$(command -v "$program")" "only/$program"
    done
    export PATH="$PWD/only"
}

test_packages_user_without_sudo_is_told_what_to_do() {
    fake_apt
    unset -f as_root
    . "$MSISF_TESTED_ROOT/scripts/lib/common.sh"
    id() { echo 1000; }
    only_programs bash mktemp tail rm apt-get
    run install_parts missing-one
    assert_code 1
    assert_same "$(<"$CALLS")" ''
    assert_says 'As root, run: apt-get update'
}

test_packages_other_system_is_told_what_to_type() {
    only_programs uname
    make_tool() { printf '#!/bin/sh\n' >"only/$1" && PATH=/usr/bin:/bin chmod +x "only/$1"; }
    make_tool dnf
    run install_parts povray shellcheck
    assert_code 1
    assert_says 'sudo dnf install povray ShellCheck'
    rm() { PATH=/usr/bin:/bin command rm "$@"; }
    rm only/dnf
    run install_parts povray
    assert_says "with your system's package manager"
}
