#!/usr/bin/env bash
# Packs the program, compiled ahead of time, for machines without .NET, into release/ or another folder:
#     scripts/release.sh [FOLDER]
#     scripts/release.sh --test     packs nothing: compares all that the native program writes with what the one on .NET's JIT writes
# msisf-VERSION-linux-x64.tar.gz is unpacked anywhere and started by ./msis; msisf_VERSION_amd64.deb puts msis on the PATH of Debian or Ubuntu.
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." >/dev/null && pwd -P)
. "$root/scripts/lib/common.sh"
. "$root/scripts/lib/packages.sh"
. "$root/scripts/lib/dotnet.sh"
. "$root/scripts/lib/install.sh"
. "$root/scripts/lib/same-bytes.sh"

# Both programs stand in this folder, so that they name the same files.
test_bytes() {
    local work=$root/obj/release-test-$$
    cd "$root"
    [ -f input/ldem/LDEM_4.IMG ] || die 'the comparison needs LDEM_4: ./msis fetch ldem'
    scripts/build.sh --native
    find_dotnet || die '.NET is missing: run scripts/build.sh'
    dotnet publish src/Msisf.Cli -c Release -p:RunAnalyzers=false -p:PublishReadyToRun=false -o "$work/jit" -v quiet -nologo ||
        die 'the build on .NET failed; the messages above say why.'
    compare_programs "$work/jit/msis" "$root/msis" "$work/outputs" || die "what differs is in $work/outputs"
    rm -r "$work"
}

help_if_asked "$@"
case "${1:-} $#" in
    '--test 1')
        test_bytes
        exit 0
        ;;
    -* | *' '[2-9]) die 'Usage: scripts/release.sh [--test | FOLDER]' ;;
esac
target=${1:-$root/release}
mkdir -p "$target" || die "$target can't be written: name another folder"
target=$(cd "$target" >/dev/null && pwd -P)
cd "$root"
have dpkg-deb || die 'dpkg-deb is missing: apt-get install dpkg'
scripts/build.sh --native-all

version=$(sed -n 's|.*<Version>\(.*\)</Version>.*|\1|p' Directory.Build.props)
name=msisf-$version-linux-x64
work=$target/.release-$$
trap 'rm -rf "$work"' EXIT
mkdir -p "$work"

# The server brings its .NET along, in a folder of its own. publish/server needs that of the machine.
publish_server() {
    find_dotnet || die '.NET is missing: run scripts/build.sh'
    say 'Packing the server ...'
    dotnet publish src/Msisf.Server -c Release -p:RunAnalyzers=false -r linux-x64 --self-contained -p:PublishReadyToRun=false \
        -o "$work/server" -v quiet -nologo || die 'the build of the server failed; the messages above say why.'
    rm -f "$work/server"/{createdump,libmscordaccore.so,libmscordbi.so}
}

# stage_program FOLDER: what msis reads of its installation; no symbols and no comments of the code.
stage_program() {
    mkdir -p "$1/lib" "$1/input/ldem" "$1/input/albedo"
    cp -R msis kernels cameras "$1"
    cp -R publish "$1/publish"
    rm -r "$1/publish/server"
    cp -R "$work/server" "$1/publish/server"
    rm -f "$1"/publish/{sources,dotnet-root} "$1"/publish/server/*.{pdb,xml}
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

# msis needs libc alone; the rest of what is needed are the libraries of the server's .NET, OpenSSL for its checksums. What is recommended
# and suggested makes single options work.
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
Depends: libc6 (>= 2.34), libgcc-s1, libstdc++6, libssl3t64 | libssl3
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

publish_server
pack_tarball
pack_deb
say "$target/$name.tar.gz"
say "$target/msisf_${version}_amd64.deb"
