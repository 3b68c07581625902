# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# A clone whose programs are stand-ins: they say where they run, and print the texts that are installed.
make_published_clone() {
    local system program
    need dpkg-deb
    make_clone "$PWD/clone"
    mkdir -p clone/cameras clone/lib/fonts clone/input/albedo
    cp "$MSISF_TESTED_ROOT"/{README.md,LICENSE} clone
    cp -R "$MSISF_TESTED_ROOT/clients" clone
    echo 'licence' >clone/lib/fonts/LICENSE-DejaVu.txt
    echo 'focal-length: 1' >clone/cameras/one.yaml
    echo 'meta' >clone/kernels/msisf.tm
    echo '<!ELEMENT a EMPTY>' >clone/lib/MSISRendering.dtd
    touch clone/input/{ldem,albedo}/README.md
    echo model >clone/input/ldem/LDEM_4.IMG
    echo label >clone/input/ldem/LDEM_4.LBL
    echo map >clone/input/albedo/map.jpg
    make_executable clone/scripts/build.sh </dev/null
    for system in linux-x64/msis-x86-64-v3 linux-arm64/msis-armv8-a win-x64/msis.exe osx-arm64/msis; do
        program=clone/obj/programs/$system
        make_executable "$program" <<'PROGRAM'
#!/bin/sh
case $1 in
    man) echo '.TH MSIS 1 ""' ;;
    completion) echo "# Completion of msis for $2" ;;
    *) echo "program: $* in $0" ;;
esac
PROGRAM
        echo made >"${program%/*}/sources"
        mkdir "${program%/*}/wwwroot"
        echo page >"${program%/*}/wwwroot/index.html"
        [[ $system != linux-* ]] || ln -s "${program##*/}" "${program%/*}/msis"
    done
    cp clone/obj/programs/linux-x64/msis-x86-64-v{3,4}
    version=$(sed -n 's|.*<Version>\(.*\)</Version>.*|\1|p' clone/Directory.Build.props)
}

test_release_packages_hold_program_kernels_and_data() {
    make_published_clone
    run clone/scripts/release.sh --for linux-x64 out
    assert_code 0
    assert_says "$PWD/out/msisf-$version-linux-x64.tar.gz"
    assert_same "$(ls -A out)" "msisf-$version-linux-x64.tar.gz
msisf-$version-py3-none-manylinux_2_34_x86_64.whl
msisf.$version.nupkg
msisf.linux-x64.$version.nupkg
msisf_${version}_amd64.deb"

    tar -xzf "out/msisf-$version-linux-x64.tar.gz"
    run env -i "msisf-$version-linux-x64/msis" --version
    assert_says "program: --version in msisf-$version-linux-x64/publish/msis"
    assert_file "msisf-$version-linux-x64/kernels/msisf.tm"
    assert_file "msisf-$version-linux-x64/lib/fonts/LICENSE-DejaVu.txt"
    assert_file "msisf-$version-linux-x64/lib/LICENSE-OpenSSL.txt"
    assert_file "msisf-$version-linux-x64/input/ldem/LDEM_4.IMG"
    assert_file "msisf-$version-linux-x64/input/albedo/map.jpg"
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

test_release_real_program_runs_where_there_is_no_dotnet() {
    [ -e "$MSISF_TESTED_ROOT/publish/libcoreclr.so" ] || compgen -G "$MSISF_TESTED_ROOT/publish/msis-x86-64-v*" >/dev/null || {
        echo 'missing: a program that brings .NET along or needs none'
        exit 77
    }
    run env -i HOME="$PWD" PATH=/nowhere /bin/sh "$MSISF_TESTED_ROOT/msis" --version
    assert_code 0
    assert_same "$output" "$(sed -n 's|.*<Version>\(.*\)</Version>.*|\1|p' "$MSISF_TESTED_ROOT/Directory.Build.props")"
}

test_release_same_sources_give_the_same_bytes() {
    make_published_clone
    run clone/scripts/release.sh --for linux-arm64 --for win-x64 one
    assert_code 0
    touch clone/obj/programs/linux-arm64/msis-armv8-a
    run clone/scripts/release.sh --for linux-arm64 --for win-x64 other
    assert_code 0
    diff -r one other
}

test_release_pip_installs_command_and_module() {
    need /usr/bin/python3
    /usr/bin/python3 -c 'import numpy, pip' 2>/dev/null || {
        echo 'missing: pip and NumPy'
        exit 77
    }
    make_published_clone
    run clone/scripts/release.sh --for linux-x64 out
    assert_code 0
    run /usr/bin/python3 -m pip install --quiet --no-index --no-deps --target site "out/msisf-$version-py3-none-manylinux_2_34_x86_64.whl"
    assert_code 0
    PYTHONPATH=site run site/bin/msis --version
    assert_says "program: --version in $PWD/site/msisf/_installation/publish/msis"
    PYTHONPATH=site run /usr/bin/python3 -c 'from msisf._process import find_program; print(find_program())'
    assert_same "$output" "$PWD/site/msisf/_installation/msis"
}

test_release_windows_has_the_program_at_the_top() {
    make_published_clone
    run clone/scripts/release.sh --for win-x64 out
    assert_code 0
    assert_same "$(python3 -m zipfile --list "out/msisf-$version-win-x64.zip" | grep -c "^msisf-$version-win-x64/msis.exe ")" 1
    assert_same "$(python3 -m zipfile --list "out/msisf-$version-py3-none-win_amd64.whl" | grep -c '^msisf/_installation/msis.exe ')" 1
    run clone/scripts/release.sh --for win-x86 out
    assert_code 1
    assert_says 'unknown system: win-x86. Choose one of:'
}
