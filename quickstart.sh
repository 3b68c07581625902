#!/usr/bin/env bash
# Sets up MSISF on a fresh machine and renders three images of the Moon into output/. As root, or as a user with sudo.
# Can be run again at no cost: what is there and up to date is left alone.
#     ./quickstart.sh
#     ./quickstart.sh --install FOLDER     sets it up and puts msis, its manual page and completions there, e.g. into ~/.local
#     ./quickstart.sh --uninstall FOLDER   takes them away again
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")" >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/install.sh"
. "$root/scripts/lib/data.sh"

help_if_asked "$@"
usage='Usage: ./quickstart.sh [--install FOLDER | --uninstall FOLDER], e.g. --install ~/.local'
prefix=''
case "${1:-} $#" in
    ' 0') ;;
    '--install 2' | '--uninstall 2')
        [ -n "$2" ] || die "$1 needs a folder. $usage"
        case $2 in
            /*) prefix=$2 ;;
            *) prefix=$PWD/$2 ;;
        esac
        ;;
    '--install '* | '--uninstall '*) die "$1 needs one folder. $usage" ;;
    *) die "unknown argument $1. $usage" ;;
esac
if [ "${1:-}" = --uninstall ]; then
    uninstall_program "$prefix"
    exit 0
fi
cd "$root"
require_own_folders

# What is made of a synthetic model is kept apart: the real one may be found in a later run.
model_options=()
pattern_options=()
get_model() {
    get_base
    case $base in
        *SYNTHETIC*)
            model_options=(--ldem "$base")
            pattern_options=(--pattern-repos pattern-repository/synthetic/)
            ;;
    esac
}

# is_current NAME: the image and its companions are there and newer than all they were made from.
is_current() {
    local file
    for file in "output/$1.xml" "output/$1.png"; do
        [ -e "$file" ] || return 1
        [ -z "$(find quickstart.sh publish/sources input/ldem input/albedo lib kernels -type f -newer "$file" -print | head -n 1)" ] ||
            return 1
    done
}

# render NAME ARGUMENTS...: an image and its meta file.
render() {
    local name=$1
    shift
    if is_current "$name"; then
        say "output/$name.png is up to date."
    else
        say "Rendering output/$name.png ..."
        ./msis "$@" --res 4 "${model_options[@]}" --batch --overwrite --output-name "$name"
        [ -s "output/$name.png" ] || die "msis ended well, but did not write output/$name.png: please report this"
    fi
    images+=("$root/output/$name.png")
}

install_parts povray cfitsio downloader certificates
scripts/build.sh
get_model
if library=$(scripts/get-cspice.sh); then
    say "CSPICE is $library."
else
    say 'Going on without CSPICE, with the built-in kernel reader.'
fi
fetch_data albedo >/dev/null || say 'Going on without a map of the reflectance: the native image shows a Moon without maria.'
if [ -n "$prefix" ]; then
    install_program "$root" "$prefix"
    exit 0
fi

images=()
# README's picture: Mare Serenitatis in the evening, through the lens of a navigation camera.
render serenitatis --look photo --camera input/navigation-camera.yaml --position 12,16,1500000 --look-at 26,24 --time 2010-04-03T00:00:00Z
# The example of section 9.2 of the thesis, by POV-Ray and by the program's own renderer.
thesis=(
    --fixed-state '{55289,2E6,2E6,0,-2.391176183943345e-001,+9.904576054128762e-002,+3.696438106143861e-001,+8.923991008325228e-001}'
    --width 1024 --height 1024 --fov 40 --rendering-annotation
)
render thesis-9.2 "${thesis[@]}" "${pattern_options[@]}"
render thesis-9.2.native "${thesis[@]}" --renderer native --samples 9

say
say 'The images (the numbers to each are in the .xml file beside it):'
printf '    %s\n' "${images[@]}"
say 'To look around in the browser: ./msis view'
