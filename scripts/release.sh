#!/usr/bin/env bash
# Packs the program, compiled ahead of time, for machines without .NET, into release/ or another folder:
#     scripts/release.sh [FOLDER]
#     scripts/release.sh --test     compares all that the native programs write with what the one on .NET's JIT writes, and draws with the
#                                   packages, by command line and by server, where there is the C library and nothing else; as root
# msisf-VERSION-linux-x64.tar.gz is unpacked anywhere and started by ./msis; msisf_VERSION_amd64.deb puts msis on the PATH of Debian or Ubuntu.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/dotnet.sh"
. "$root/scripts/lib/install.sh"
. "$root/scripts/lib/same-bytes.sh"
. "$root/scripts/lib/bare-root.sh"

help_if_asked "$@"
test=no
case "${1:-} $#" in
    '--test 1') test=yes ;;
    -* | *' '[2-9]) die 'Usage: scripts/release.sh [--test | FOLDER]' ;;
esac
have dpkg-deb || die 'dpkg-deb is missing: apt-get install dpkg'
if [ "$test" = yes ]; then
    target=$root/obj/release-test-$$
    [ "$(id -u)" -eq 0 ] || die 'root is needed to try the packages in a root file system of their own.'
    [ -f "$root/input/ldem/LDEM_4.IMG" ] || die 'LDEM_4 is missing: ./msis fetch ldem'
    compgen -G "$root/input/albedo/*.jpg" >/dev/null || die 'the map is missing: ./msis fetch albedo'
else
    target=${1:-$root/release}
fi
mkdir -p "$target" || die "$target can't be written: name another folder"
target=$(cd "$target" >/dev/null && pwd -P)
cd "$root"
if [ "$test" = yes ]; then
    scripts/build.sh --native # what runs here can be tried
else
    scripts/build.sh --native-all
fi

version=$(sed -n 's|.*<Version>\(.*\)</Version>.*|\1|p' Directory.Build.props)
name=msisf-$version-linux-x64
work=$target/.release-$$
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"

# stage_program FOLDER: what msis reads of its installation.
stage_program() {
    mkdir -p "$1/lib" "$1/input/ldem" "$1/input/albedo"
    cp -R msis kernels cameras "$1"
    cp -R publish "$1/publish"
    rm -f "$1"/publish/{sources,dotnet-root}
    cp lib/*.dtd "$1/lib"
    install -D -m 644 lib/fonts/LICENSE-DejaVu.txt "$1/lib/fonts/LICENSE-DejaVu.txt"
    # The program holds OpenSSL.
    cat /usr/share/doc/libssl-dev/copyright /usr/share/common-licenses/Apache-2.0 >"$1/lib/LICENSE-OpenSSL.txt"
    [ ! -e lib/native/libcspice.so ] || install -D -m 644 lib/native/libcspice.so "$1/lib/native/libcspice.so"
    cp README.md LICENSE "$1"
    find "$1" -type d -exec chmod 755 {} +
    find "$1" -type f ! -perm -u+x -exec chmod 644 {} +
    find "$1" -type f -perm -u+x -exec chmod 755 {} +
}

# The same sources give the same packages: one time for all files, that of the last commit.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null || stat -c %Y Directory.Build.props)
export SOURCE_DATE_EPOCH
same_times() { find "$1" -exec touch --no-dereference --date="@$SOURCE_DATE_EPOCH" {} +; }

pack_tarball() {
    stage_program "$work/$name"
    same_times "$work/$name"
    tar --directory "$work" --sort=name --owner=0 --group=0 --numeric-owner --create "$name" | gzip --no-name >"$work/$name.tar.gz"
    mv "$work/$name.tar.gz" "$target"
    rm -rf "${work:?}/$name"
}

# What is recommended and suggested makes single options work.
write_control() {
    local kilobytes
    kilobytes=$(du -sk "$1" | cut -f 1)
    mkdir -p "$1/DEBIAN"
    cat >"$1/DEBIAN/control" <<CONTROL
Package: msisf
Version: $version
Architecture: amd64
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

pack_deb() {
    local tree=$work/deb file words mark place
    mkdir -p "$tree/usr/lib" "$tree/usr/bin" "$tree/usr/share/doc/msisf"
    stage_program "$tree/usr/lib/msisf"
    ln -s ../lib/msisf/msis "$tree/usr/bin/msis"
    mv "$tree/usr/lib/msisf/LICENSE" "$tree/usr/share/doc/msisf/copyright"
    mv "$tree/usr/lib/msisf/README.md" "$tree/usr/share/doc/msisf/README.md"
    while IFS='|' read -r file words mark; do
        [ -n "$file" ] || continue
        place=$tree/usr/${file/zsh\/site-functions/zsh\/vendor-completions}
        mkdir -p "${place%/*}"
        # shellcheck disable=SC2086 # one or two words
        ./msis $words >"$place" || die "msis $words failed: please report this"
        grep -qF -- "$mark" "$place" || die "msis $words has not its mark \"$mark\": please report this"
    done <<<"$installed_texts"
    gzip --no-name --best "$tree/usr/share/man/man1/msis.1"
    write_control "$tree"
    same_times "$tree"
    dpkg-deb --root-owner-group -Zgzip --build "$tree" "$work/msisf_${version}_amd64.deb" >/dev/null
    mv "$work/msisf_${version}_amd64.deb" "$target"
}

# The programs stand in this folder, so that they name the same files. $target keeps what differs.
test_bytes() {
    local level
    for level in x86-64-v3 x86-64-v4; do
        if [ ! -e "publish/msis-$level" ]; then
            say "missing: a processor with AVX-512, so $level is not tried"
            continue
        fi
        say "$level and .NET's JIT:"
        compare_programs "$target/jit/msis" "$root/publish/msis-$level" "$target/$level" || die "what differs is in $target/$level"
    done
}

test_packages() {
    local kind
    # shellcheck disable=SC2046 # words
    "$target/jit/msis" $(words_of_trial) --output-dir "$target/trial" 2>/dev/null
    for kind in tarball deb; do
        make_bare_root "$target/$kind"
    done
    mkdir "$target/tarball/opt"
    tar -xzf "$target/$name.tar.gz" -C "$target/tarball/opt"
    try_package "$target/tarball" "/opt/$name/msis" "/opt/$name" "$target/trial" || die "the tarball does not draw: see $target"
    dpkg-deb -x "$target/msisf_${version}_amd64.deb" "$target/deb"
    try_package "$target/deb" msis /usr/lib/msisf "$target/trial" || die "the Debian package does not draw: see $target"
    say 'Both packages draw and serve with the C library alone.'
}

pack_tarball
pack_deb
if [ "$test" = yes ]; then
    find_dotnet || die '.NET is missing: run scripts/build.sh --dotnet'
    dotnet publish src/Msisf.Cli -c Release -p:RunAnalyzers=false -p:PublishReadyToRun=false -o "$target/jit" -v quiet -nologo ||
        die 'the build on .NET failed; the messages above say why.'
    test_packages
    test_bytes
    rm -r "$target"
else
    say "$target/$name.tar.gz"
    say "$target/msisf_${version}_amd64.deb"
fi
