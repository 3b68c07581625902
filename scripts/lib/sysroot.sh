# shellcheck shell=bash
# shellcheck disable=SC2154 # the script that sources this sets root
# Sourced after packages.sh: what is compiled ahead of time for another processor is linked with Debian's libraries for that one.

# prepare_sysroot SYSTEM: sets sysroot, a folder with the C library and OpenSSL of a system; fetched with apt, nothing is installed.
prepare_sysroot() {
    local architecture machine state package link gcc
    case $1 in
        linux-arm64) architecture=arm64 machine=aarch64 ;;
        *) die "there is no compiler for $1" ;;
    esac
    have apt-get || die "programs for $1 are linked with packages of Debian: run this on Debian or Ubuntu."
    install_parts clang lld "objcopy-$machine" || exit
    sysroot=$root/obj/sysroots/$1
    [ ! -e "$sysroot/toolchain.cmake" ] || return 0

    state=$root/obj/sysroots/apt-$$
    mkdir -p "$state/lists/partial" "$sysroot"
    local apt=(apt-get -q -o "APT::Architectures=$architecture" -o "APT::Architecture=$architecture" -o "Dir::State::Lists=$state/lists"
        -o "Dir::Cache=$state" -o APT::Sandbox::User=root)
    gcc=$(dpkg-query -W -f '${Package}\n' 'libgcc-[0-9]*-dev' | sort -V | tail -n 1)
    say "Getting the C library and OpenSSL for $1 ..."
    (
        cd "$state"
        "${apt[@]}" update && "${apt[@]}" download libc6 libc6-dev linux-libc-dev "$gcc" libgcc-s1 libssl-dev zlib1g-dev
    ) >"$state/log" 2>&1 || {
        tail -n 3 "$state/log" >&2
        die "the packages of Debian for $architecture are not to be had here."
    }
    for package in "$state"/*.deb; do
        dpkg-deb -x "$package" "$sysroot"
    done
    rm -r "$state"
    while IFS= read -r link; do # those that start at / mean the root of that system
        ln -sf --relative "$sysroot$(readlink "$link")" "$link"
    done < <(find "$sysroot" -type l -lname '/*')
    cat >"$sysroot/toolchain.cmake" <<CMAKE
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR $machine)
set(CMAKE_C_COMPILER clang)
set(CMAKE_C_COMPILER_TARGET $machine-linux-gnu)
set(CMAKE_SYSROOT "$sysroot")
set(CMAKE_FIND_ROOT_PATH "$sysroot")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_EXE_LINKER_FLAGS_INIT -fuse-ld=lld)
set(CMAKE_LIBRARY_ARCHITECTURE $machine-linux-gnu)
CMAKE
}
