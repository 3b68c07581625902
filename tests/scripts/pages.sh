# shellcheck shell=bash
# For tests that run the commands of a page of docs.

# need_part NAME CONDITION...: skips the test, by the name of the part, where the condition does not hold.
need_part() {
    local name=$1
    shift
    "$@" || {
        echo "missing: $name"
        exit 77
    }
}

# run_page PAGE CLONE: with the system's Python, which is the one that has NumPy.
run_page() { /usr/bin/python3 -B "$MSISF_TESTED_ROOT/tests/scripts/page.py" "$@"; }

# part_is_here PART: what quickstart.sh would otherwise install.
part_is_here() (
    . "$MSISF_TESTED_ROOT/scripts/lib/common.sh"
    . "$MSISF_TESTED_ROOT/scripts/lib/packages.sh"
    part_is_here "$1"
)

# need_program_of_pages: skips the test where the program, or what it needs, is missing; else msis and msisf are those of the clone.
need_program_of_pages() {
    need_part NumPy /usr/bin/python3 -c 'import numpy'
    need_part LDEM_4 test -f "$MSISF_TESTED_ROOT/input/ldem/LDEM_4.IMG"
    need_part 'program, run scripts/build.sh' test -x "$MSISF_TESTED_ROOT/publish/msis"
    export HOME=$PWD/home PATH="$MSISF_TESTED_ROOT:$PATH" PYTHONPATH="$MSISF_TESTED_ROOT/clients/python"
    unset XDG_CONFIG_HOME
}
