# shellcheck shell=bash
# Sourced: the systems for which there are packages. A line each: .NET's name of the system | instruction sets for which the program is
# compiled ahead of time, the first of which runs on most; none where it takes .NET's JIT along | Debian's name | Python's name. The last is
# for all others, as a .NET tool that runs on the .NET of the machine.
targets='
linux-x64|x86-64-v3 x86-64-v4|amd64|manylinux_2_34_x86_64
linux-arm64|armv8-a|arm64|manylinux_2_34_aarch64
win-x64|||win_amd64
osx-arm64|||macosx_12_0_arm64
osx-x64|||macosx_12_0_x86_64
any|||'

# read_target NAME: sets target_levels, target_debian and target_python. Fails if there is no such system.
# shellcheck disable=SC2034 # read by the scripts that source this file
read_target() {
    local line name
    while IFS= read -r line; do
        IFS='|' read -r name target_levels target_debian target_python <<<"$line"
        [ -z "$line" ] || [ "$name" != "$1" ] || return 0
    done <<<"$targets"
    return 1
}

names_of_targets() { sed -n 's/|.*//p' <<<"$targets"; }
