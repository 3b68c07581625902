# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# A clone whose program is a stand-in: it says where it runs, and prints the texts that are installed.
make_published_clone() {
    need dpkg-deb
    make_clone "$PWD/clone"
    make_executable clone/scripts/build.sh </dev/null
    cp "$MSISF_TESTED_ROOT"/{README.md,LICENSE} clone
    mkdir -p clone/cameras clone/lib/fonts
    echo 'licence' >clone/lib/fonts/LICENSE-DejaVu.txt
    echo 'focal-length: 1' >clone/cameras/one.yaml
    echo 'meta' >clone/kernels/msisf.tm
    echo '<!ELEMENT a EMPTY>' >clone/lib/MSISRendering.dtd
    make_executable clone/publish/msis-x86-64-v3 <<'PROGRAM'
#!/bin/sh
case $1 in
    man) echo '.TH MSIS 1 ""' ;;
    completion) echo "# Completion of msis for $2" ;;
    *) echo "program: $* in $0 dotnet=${DOTNET_ROOT:-none}" ;;
esac
PROGRAM
    cp clone/publish/msis-x86-64-v3 clone/publish/msis-x86-64-v4
    ln -s msis-x86-64-v3 clone/publish/msis
    mkdir clone/publish/wwwroot
    echo page >clone/publish/wwwroot/index.html
    echo /my/dotnet >clone/publish/dotnet-root
}

test_release_packages_hold_program_kernels_and_dependencies() {
    make_published_clone
    run clone/scripts/release.sh out
    assert_code 0
    version=$(sed -n 's|.*<Version>\(.*\)</Version>.*|\1|p' clone/Directory.Build.props)
    assert_says "$PWD/out/msisf-$version-linux-x64.tar.gz"
    assert_same "$(ls -A out)" "msisf-$version-linux-x64.tar.gz
msisf_${version}_amd64.deb"

    tar -xzf "out/msisf-$version-linux-x64.tar.gz"
    run env -i "msisf-$version-linux-x64/msis" --version
    assert_says "program: --version in msisf-$version-linux-x64/publish/msis"
    assert_says 'dotnet=none'
    assert_file "msisf-$version-linux-x64/kernels/msisf.tm"
    assert_file "msisf-$version-linux-x64/lib/fonts/LICENSE-DejaVu.txt"
    assert_file "msisf-$version-linux-x64/lib/LICENSE-OpenSSL.txt"
    assert_same "$(cd "msisf-$version-linux-x64/publish" && find . ! -type d | sort)" './msis
./msis-x86-64-v3
./msis-x86-64-v4
./wwwroot/index.html'

    dpkg-deb -x "out/msisf_${version}_amd64.deb" tree
    run env -i tree/usr/bin/msis --version
    assert_says 'program: --version in'
    assert_file tree/usr/lib/msisf/kernels/msisf.tm
    assert_file tree/usr/lib/msisf/cameras/one.yaml
    assert_same "$(gzip -dc tree/usr/share/man/man1/msis.1.gz)" '.TH MSIS 1 ""'
    assert_same "$(cat tree/usr/share/zsh/vendor-completions/_msis)" '# Completion of msis for zsh'
    run dpkg-deb -f "out/msisf_${version}_amd64.deb" Package Version Architecture Depends
    assert_says "Version: $version"
    assert_says 'Depends: libc6 (>= 2.34)'
    assert_silent_on dotnet
}

test_release_again_gives_the_same_bytes() {
    make_published_clone
    run clone/scripts/release.sh first
    touch clone/publish/msis-x86-64-v4
    run clone/scripts/release.sh second
    assert_code 0
    assert_same "$(cd second && cksum -- *)" "$(cd first && cksum -- *)"
}

test_release_real_program_runs_where_there_is_no_dotnet() {
    [ -e "$MSISF_TESTED_ROOT/publish/libcoreclr.so" ] || [ -e "$MSISF_TESTED_ROOT/publish/msis-x86-64-v3" ] || {
        echo 'missing: a program that brings .NET along or needs none'
        exit 77
    }
    run env -i HOME="$PWD" PATH=/nowhere /bin/sh "$MSISF_TESTED_ROOT/msis" --version
    assert_code 0
    assert_same "$output" "$(sed -n 's|.*<Version>\(.*\)</Version>.*|\1|p' "$MSISF_TESTED_ROOT/Directory.Build.props")"
}
