#!/usr/bin/env bash
# Puts NAIF's CSPICE, as a shared library, into lib/native/libcspice.so. The first source that answers is taken:
# MSISF_CSPICE (used where it is), what is installed, ../shared/cspice beside the repository, NAIF's site.
# Prints the library's path on stdout. Exits non-zero, with one sentence on stderr, if there is none: msis then uses its
# built-in kernel reader, so callers may go on. Can be run again at no cost.
set -euo pipefail

readonly version='N0067' # the version that the tests ran with
readonly url='https://naif.jpl.nasa.gov/pub/naif/toolkit/C/PC_Linux_GCC_64bit/packages/cspice.tar.Z'
readonly least_bytes=20000000   # NAIF replaces the package under one name and gives no checksum; a page of excuses is smaller

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
readonly root
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
help_if_asked "$@"
[ $# -eq 0 ] || die "unknown argument $1. Usage: scripts/get-cspice.sh"
readonly library="$root/lib/native/libcspice.so"
readonly shared="$root/../shared/cspice/libcspice.so"

work=''
cleanup() {
    if [[ -n $work ]]; then
        rm -rf -- "$work"
    fi
}
trap cleanup EXIT
trap 'exit 130' INT
trap 'exit 143' TERM

give_up() {
    printf 'get-cspice: %s; msis will use its built-in kernel reader.\n' "$1" >&2
    exit 1
}

# tkvrsn's text stands in the library; a page, a half copy or another library does not have it, spkpos_c and the ELF mark.
is_cspice() {
    [[ -f $1 && $(head -c 4 -- "$1" | tail -c 3) == 'ELF' ]] && grep -aqF "$version" -- "$1" && grep -aqF 'spkpos_c' -- "$1"
}

make_work_folder() {
    mkdir -p -- "$root/lib/native" || give_up "$root/lib/native can't be made"
    work=$(mktemp -d -- "$root/lib/native/.get-cspice.XXXXXX") || give_up "$root/lib/native can't be written"
}

# A reader of the final name sees the old file, the new file or none, but never a part.
install_library() {
    is_cspice "$work/libcspice.so" || give_up "$1 is not CSPICE $version"
    chmod 644 -- "$work/libcspice.so"
    mv -f -- "$work/libcspice.so" "$library"
    printf '%s\n' "$library"
}

download() {
    [[ $(uname -sm) == 'Linux x86_64' ]] || give_up "NAIF's package is for Linux on x86-64 and this is $(uname -sm)"
    local compiler tool
    for tool in curl gzip tar; do
        command -v "$tool" > /dev/null || give_up "CSPICE must be downloaded, and there is no $tool"
    done

    printf 'get-cspice: downloading %s\n' "$url" >&2
    curl --fail --silent --location --connect-timeout 5 --speed-limit 10000 --speed-time 20 \
        --output "$work/cspice.tar.Z" -- "$url" || give_up "$url does not answer (curl: exit code $?)"
    # Only now, that there is something to link.
    install_parts compiler || give_up 'CSPICE must be linked, and there is no C compiler (cc or gcc)'
    compiler=$(command -v cc || command -v gcc)
    (($(wc -c < "$work/cspice.tar.Z") >= least_bytes)) || give_up "$url is too small to be CSPICE"
    gzip -dc -- "$work/cspice.tar.Z" | tar -xf - -C "$work" cspice/lib/cspice.a || give_up "$url is not the package that it should be"
    "$compiler" -shared -o "$work/libcspice.so" -Wl,-soname,libcspice.so \
        -Wl,--whole-archive "$work/cspice/lib/cspice.a" -Wl,--no-whole-archive -lm >&2 || give_up 'CSPICE could not be linked'
}

if [[ -n ${MSISF_CSPICE:-} ]]; then
    is_cspice "$MSISF_CSPICE" || give_up "MSISF_CSPICE is $MSISF_CSPICE, which is not CSPICE $version"
    printf '%s\n' "$MSISF_CSPICE"
elif is_cspice "$library"; then
    printf '%s\n' "$library"
elif is_cspice "$shared"; then
    make_work_folder
    cp -- "$shared" "$work/libcspice.so" || give_up "$shared can't be copied"
    install_library "$shared"
else
    make_work_folder
    download
    install_library "$url"
fi
