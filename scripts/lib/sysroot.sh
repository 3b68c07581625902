# shellcheck shell=bash
# shellcheck disable=SC2154 # the script that sources this sets root
# Sourced after packages.sh: Debian's packages for other processors than this one.

# unpack_packages ARCHITECTURE FOLDER PACKAGE...: what they depend on too; fetched with apt, nothing is installed.
unpack_packages() {
    local state package link
    have apt-get || die "packages for $1 are fetched with apt: run this on Debian or Ubuntu."
    mkdir -p "$root/obj" "$2"
    state=$(mktemp -d "$root/obj/apt-XXXXXX")
    mkdir -p "$state/lists/partial"
    : >"$state/status" # as if nothing were installed
    local apt=(apt-get -q -o "APT::Architectures=$1" -o "APT::Architecture=$1" -o "Dir::State=$state" -o "Dir::State::Status=$state/status"
        -o "Dir::Cache=$state" -o APT::Sandbox::User=root)
    {
        "${apt[@]}" update && "${apt[@]}" -y --no-install-recommends --download-only install "${@:3}"
    } >"$state/log" 2>&1 || {
        tail -n 3 "$state/log" >&2
        die "the packages of Debian for $1 are not to be had here."
    }
    for package in "$state"/archives/*.deb; do
        dpkg-deb -x "$package" "$2"
    done
    rm -r "$state"
    while IFS= read -r link; do # those that start at / mean the root of that system
        ln -sf --relative "$2$(readlink "$link")" "$link"
    done < <(find "$2" -type l -lname '/*')
}

# prepare_sysroot SYSTEM: sets sysroot, a folder with the C library and OpenSSL of a system, for the linker.
prepare_sysroot() {
    local architecture machine gcc
    case $1 in
        linux-arm64) architecture=arm64 machine=aarch64 ;;
        *) die "there is no compiler for $1" ;;
    esac
    install_parts clang lld "objcopy-$machine" || exit
    sysroot=$root/obj/sysroots/$1
    [ ! -e "$sysroot/toolchain.cmake" ] || return 0

    gcc=$(dpkg-query -W -f '${Package}\n' 'libgcc-[0-9]*-dev' | sort -V | tail -n 1)
    say "Getting the C library and OpenSSL for $1 ..."
    unpack_packages "$architecture" "$sysroot" libc6-dev "$gcc" libssl-dev zlib1g-dev
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
