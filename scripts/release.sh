#!/usr/bin/env bash
# Packs the program for machines without .NET, with an elevation model and a map, into release/ or another folder:
#     scripts/release.sh [--for NAME]... [FOLDER]
#     scripts/release.sh --test [--for NAME]...     compares what the programs write, and draws with the packages where there is the C
#                                   library and nothing else: by command line, server, viewer and Python; those for other systems under
#                                   Wine and qemu; as root
# Without --for the packages of all systems (scripts/lib/targets.sh): an archive, which is unpacked anywhere; a Debian package; a package
# for pip; one for `dotnet tool install`.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/dotnet.sh"
. "$root/scripts/lib/install.sh"
. "$root/scripts/lib/targets.sh"
. "$root/scripts/lib/release-test.sh"

help_if_asked "$@"
test=no
systems=()
folder=$root/release
while [ $# -gt 0 ]; do
    case $1 in
        --test) test=yes folder=$root/obj/release-test-$$ ;;
        --for)
            read_target "${2:-}" || die "unknown system: ${2:-}. Choose one of: $(names_of_targets | paste -sd ' ')"
            systems+=("$2")
            shift
            ;;
        -*) die 'Usage: scripts/release.sh [--test] [--for NAME]... [FOLDER]' ;;
        *) folder=$1 ;;
    esac
    shift
done
if [ ${#systems[@]} -eq 0 ]; then
    read -ra systems <<<"$(names_of_targets | paste -sd ' ')"
    # Nobody here has a Mac to try them on.
    [ "$test" = no ] || systems=(linux-x64 linux-arm64 win-x64 any)
fi
have dpkg-deb || die 'dpkg-deb is missing: apt-get install dpkg'
have python3 || die 'python3 is missing: apt-get install python3'
if [ "$test" = yes ]; then
    [ "$(id -u)" -eq 0 ] || die 'root is needed to try the packages in a root file system of their own.'
fi
[ -f "$root/input/ldem/LDEM_4.IMG" ] || die 'LDEM_4 is missing: ./msis fetch ldem'
compgen -G "$root/input/albedo/*.jpg" >/dev/null || die 'the map is missing: put moon_nasa_svs4720_11469x5734.jpg into input/albedo'
mkdir -p "$folder" || die "$folder can't be written: name another folder"
folder=$(cd "$folder" >/dev/null && pwd -P)
cd "$root"

version=$(sed -n 's|.*<Version>\(.*\)</Version>.*|\1|p' Directory.Build.props)
work=$folder/.release-$$
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"

# The same sources give the same packages: one time for all files, that of the last commit.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null || stat -c %Y Directory.Build.props)
export SOURCE_DATE_EPOCH
same_times() { find "$1" -exec touch --no-dereference --date="@$SOURCE_DATE_EPOCH" {} +; }

# stage_program SYSTEM TREE: the installation. On Windows, and where .NET starts it, the program is at the top; elsewhere a starter.
stage_program() {
    mkdir -p "$2/lib/fonts" "$2/input/ldem" "$2/input/albedo"
    if [[ $1 = win-* || $1 = any ]]; then
        cp -R "obj/programs/$1/." "$2"
        rm "$2/sources"
    else
        cp -R "obj/programs/$1" "$2/publish"
        rm "$2/publish/sources"
        cp msis "$2"
    fi
    cp -R kernels cameras README.md LICENSE "$2"
    cp lib/*.dtd "$2/lib"
    cp lib/fonts/LICENSE-DejaVu.txt "$2/lib/fonts"
    cp input/ldem/{README.md,LDEM_4.IMG,LDEM_4.LBL} "$2/input/ldem"
    cp input/albedo/{README.md,*.jpg} "$2/input/albedo"
    if [ -n "$target_levels" ]; then # the program holds OpenSSL
        cat /usr/share/doc/libssl-dev/copyright /usr/share/common-licenses/Apache-2.0 >"$2/lib/LICENSE-OpenSSL.txt"
    fi
    if [ "$1" = linux-x64 ] && [ -e lib/native/libcspice.so ]; then
        install -D -m 644 lib/native/libcspice.so "$2/lib/native/libcspice.so"
    fi
    find "$2" -type d -exec chmod 755 {} +
    find "$2" -type f ! -perm -u+x -exec chmod 644 {} +
    find "$2" -type f -perm -u+x -exec chmod 755 {} +
    same_times "$2"
}

pack_archive() { # SYSTEM TREE
    local name=msisf-$version-$1
    if [[ $1 = win-* ]]; then
        python3 scripts/lib/archives.py zip "$2" "$work/$name.zip"
        give "$name.zip"
    else
        tar --directory "${2%/*}" --sort=name --owner=0 --group=0 --numeric-owner --create "${2##*/}" | gzip --no-name >"$work/$name.tar.gz"
        give "$name.tar.gz"
    fi
}

# What is recommended and suggested makes single options work.
write_control() { # FOLDER
    local kilobytes
    kilobytes=$(du -sk "$1" | cut -f 1)
    mkdir -p "$1/DEBIAN"
    cat >"$1/DEBIAN/control" <<CONTROL
Package: msisf
Version: $version
Architecture: $target_debian
Maintainer: The MSISF authors <msisf@localhost>
Installed-Size: $kilobytes
Depends: libc6 (>= 2.34)
Recommends: libcfitsio10t64 | libcfitsio10, povray, curl
Suggests: libgdal36 | libgdal34t64 | libgdal32
Section: science
Priority: optional
Description: synthetic images of the Moon for optical navigation
 MSISF places a camera and the Sun, takes the shape of the Moon from LOLA elevation
 data, and draws with its own renderer or with POV-Ray. Beside each image it writes
 where on the Moon the pixels look, and from which direction the Sun lights that spot.
CONTROL
}

# write_texts TREE: manual page and completions, which are the same for all systems, by the program for this one.
write_texts() {
    local file words mark place
    scripts/build.sh --for linux-x64
    while IFS='|' read -r file words mark; do
        [ -n "$file" ] || continue
        place=$1/usr/${file/zsh\/site-functions/zsh\/vendor-completions}
        mkdir -p "${place%/*}"
        # shellcheck disable=SC2086 # one or two words
        obj/programs/linux-x64/msis $words >"$place" || die "msis $words failed: please report this"
        grep -qF -- "$mark" "$place" || die "msis $words has not its mark \"$mark\": please report this"
    done <<<"$installed_texts"
    gzip --no-name --best "$1/usr/share/man/man1/msis.1"
}

pack_deb() { # TREE
    local deb=$work/deb name=msisf_${version}_$target_debian.deb
    mkdir -p "$deb/usr/lib" "$deb/usr/bin" "$deb/usr/share/doc/msisf"
    cp -a "$1" "$deb/usr/lib/msisf"
    ln -s ../lib/msisf/msis "$deb/usr/bin/msis"
    mv "$deb/usr/lib/msisf/LICENSE" "$deb/usr/share/doc/msisf/copyright"
    mv "$deb/usr/lib/msisf/README.md" "$deb/usr/share/doc/msisf/README.md"
    write_texts "$deb"
    write_control "$deb"
    same_times "$deb"
    dpkg-deb --root-owner-group -Zgzip --build "$deb" "$work/$name" >/dev/null
    rm -rf "$deb"
    give "$name"
}

give() {
    mv "$work/$1" "$folder"
    [ "$test" = yes ] || say "$folder/$1"
}

for system in "${systems[@]}"; do
    read_target "$system"
    scripts/build.sh --for "$system"
    tree=$work/msisf-$version-$system
    stage_program "$system" "$tree"
    if [ -n "$target_python" ]; then
        pack_archive "$system" "$tree"
        python3 scripts/lib/archives.py wheel "$tree" "$work" "$target_python"
        give "msisf-$version-py3-none-$target_python.whl"
    fi
    [ -z "$target_debian" ] || pack_deb "$tree"
    python3 scripts/lib/archives.py tool "$tree" "$work" "$version" "$system"
    give "msisf.$system.$version.nupkg"
    rm -rf "$tree"
done
python3 scripts/lib/archives.py tools "$work" "$version" "${systems[@]}"
give "msisf.$version.nupkg"

if [ "$test" = yes ]; then
    test_release "$folder" "$version" "${systems[@]}"
    rm -r "$folder"
fi
