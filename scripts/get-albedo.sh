#!/usr/bin/env bash
# Puts a map of the Moon's reflectance into input/albedo, where msis finds it:
#     scripts/get-albedo.sh [--size 2k|4k|8k|16k]
# Sources, the first that answers: what is there already, NASA's Scientific Visualization Studio (SVS 4720, default 8k),
# and ../shared/albedo. Exit code: 0 a map is there, 1 none; msis then draws a surface that reflects alike everywhere.
# MSISF_ALBEDO_URLS: other addresses, separated by spaces, with {size} for the size.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/download.sh"

official_urls='https://svs.gsfc.nasa.gov/vis/a000000/a004700/a004720/lroc_color_poles_{size}.tif'

size=8k
while [ $# -gt 0 ]; do
    case $1 in
        --size) size=${2:-} && shift ;;
        *) die "unknown argument $1. Usage: scripts/get-albedo.sh [--size 2k|4k|8k|16k]" ;;
    esac
    shift || die '--size needs one of 2k, 4k, 8k and 16k'
done
case $size in
    2k | 4k | 8k | 16k) ;;
    *) die "--size $size: NASA offers 2k, 4k, 8k and 16k" ;;
esac

folder=$root/input/albedo
shared=${root%/*}/shared/albedo
incoming=$folder/.incoming-$$
trap 'rm -rf "$incoming"' EXIT

# The names by which msis knows the map.
maps_in() {
    [ ! -d "$1" ] || find "$1" -maxdepth 1 -type f \( -name '*lroc_color_poles*' -o -name '*svs4720*' \) | sort
}

# is_image FILE: it begins as a TIFF, JPEG or PNG file does; a page that says "not found" does not.
is_image() {
    case $(head -c 4 "$1" | od -An -tx1 | tr -d ' \n') in
        49492a00 | 4d4d002a | 49492b00 | 4d4d002b | ffd8ff* | 89504e47) return 0 ;;
        *) return 1 ;;
    esac
}

# keep FILE PLACE: what was fetched is put in place if it is an image, and that ends the search.
keep() {
    if ! is_image "$1"; then
        warn "not taken from $2: it is no image"
        return 0
    fi
    mv "$1" "$folder/${1##*/}"
    say "The map of the Moon's reflectance ${1##*/} comes from $2."
    exit 0
}

present=$(maps_in "$folder" | head -n 1)
if [ -n "$present" ]; then
    say "The map of the Moon's reflectance ${present##*/} is in place."
    exit 0
fi

mkdir -p "$incoming"
for url in ${MSISF_ALBEDO_URLS:-$official_urls}; do
    url=${url//\{size\}/$size}
    if download "$url" "$incoming/${url##*/}"; then
        keep "$incoming/${url##*/}" "$url"
    fi
done
neighbour=$(maps_in "$shared" | head -n 1)
if [ -n "$neighbour" ] && cp "$neighbour" "$incoming" && chmod u+w "$incoming"/*; then
    keep "$incoming/${neighbour##*/}" "$shared"
fi
warn 'no source has a map of the reflectance; the Moon is drawn without its maria. Put lroc_color_poles_8k.tif of' \
    'https://svs.gsfc.nasa.gov/4720 into input/albedo'
exit 1
