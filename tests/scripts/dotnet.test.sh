# shellcheck shell=bash disable=SC2317 # stand-ins are called by what is tested
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"
. "$MSISF_TESTED_ROOT/scripts/lib/common.sh"
. "$MSISF_TESTED_ROOT/scripts/lib/packages.sh"
. "$MSISF_TESTED_ROOT/scripts/lib/dotnet.sh"

# A machine without the SDK until apt installs it; its distribution has the SDK as its lists say: yes, no, or outdated.
machine_without_sdk() {
    lists=$1
    find_dotnet() { [ -e installed ]; }
    part_is_here() { true; }
    have() { true; }
    apt-cache() { [ "$lists" = yes ]; }
    apt_get() {
        echo "apt: $1"
        case $1-$lists in
            update-outdated) lists=yes ;;
            install-yes) : >installed ;;
            install-*) return 100 ;;
        esac
    }
}

test_dotnet_missing_sdk_comes_from_the_distribution_if_it_has_it() {
    machine_without_sdk yes
    run ensure_dotnet
    assert_code 0
    assert_says 'Installing with apt: dotnet-sdk-10.0'
}

test_dotnet_outdated_lists_are_renewed_first() {
    machine_without_sdk outdated
    run ensure_dotnet
    assert_code 0
    assert_file installed
}

test_dotnet_distribution_without_it_says_how_to_get_it() {
    machine_without_sdk no
    run ensure_dotnet
    assert_code 1
    assert_says 'dotnet-install.sh | bash -s -- --channel 10.0'
    assert_no_file installed
}
