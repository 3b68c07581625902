# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# A clone, and a stand-in for the SDK that publishes one file and notes its builds; it has no package of the runtime where RUNTIME=no.
make_clone_with_sdk() {
    make_clone "$PWD/clone"
    make_executable sdk/dotnet <<'SDK'
#!/usr/bin/env bash
case $1 in
    --list-sdks) printf '8.0.100 [/old/sdk]\n10.0.100 [%s/sdk]\n' "$(cd "$(dirname "$0")" && pwd -P)" ;;
    restore) [ "${RUNTIME:-}" != no ] || exit 1 ;;
    publish)
        program=msis
        case $2 in
            *Msisf.Server) exit ;;
            *Msisf.Native) program=msisf ;;
        esac
        [[ " $* " != *' win-x64 '* ]] || program=$program.exe
        echo "$*" >>"$BUILDS"
        [ -z "${BROKEN:-}" ] || exit 1
        while [ "$1" != -o ]; do shift; done
        mkdir -p "$2/wwwroot" && echo '#!/bin/sh' >"$2/$program" && chmod +x "$2/$program" && echo lib >"$2/libSkiaSharp.so"
        ;;
esac
SDK
    export BUILDS=$PWD/builds PATH="$PWD/sdk:$PATH"
    : >"$BUILDS"
}

builds() { wc -l <"$BUILDS" | tr -d ' '; }

test_build_only_builds_what_has_changed() {
    make_clone_with_sdk
    run clone/scripts/build.sh
    assert_code 0
    assert_file clone/publish/msis
    assert_same "$(cat clone/publish/dotnet-root)" "$PWD/sdk"
    touch clone/src/Msisf.Cli/Program.cs
    mkdir -p clone/src/Msisf.Cli/obj && echo made >clone/src/Msisf.Cli/obj/made.cs
    run clone/scripts/build.sh
    assert_says 'up to date'
    assert_same "$(builds)" 1
    echo 'return 1;' >clone/src/Msisf.Cli/Other.cs
    run clone/scripts/build.sh
    assert_same "$(builds)" 2
    rm clone/src/Msisf.Cli/Other.cs
    run clone/scripts/build.sh
    assert_same "$(builds)" 3
}

test_build_that_fails_leaves_the_old_program() {
    make_clone_with_sdk
    run clone/scripts/build.sh
    echo old >clone/publish/mark
    echo 'broken' >clone/src/Msisf.Cli/Program.cs
    BROKEN=yes run clone/scripts/build.sh
    assert_code 1
    assert_says 'the build failed'
    assert_file clone/publish/mark
    assert_same "$(ls -A clone/obj)" ''
    run clone/scripts/build.sh
    assert_code 0
    assert_no_file clone/publish/mark
}

test_build_sdk_in_the_home_folder_is_found_behind_an_old_one() {
    make_clone_with_sdk
    mkdir home
    mv sdk home/.dotnet
    make_executable sdk/dotnet <<'SDK'
#!/bin/sh
echo '8.0.100 [/old/sdk]'
SDK
    HOME=$PWD/home run clone/scripts/build.sh
    assert_code 0
    assert_same "$(cat clone/publish/dotnet-root)" "$PWD/home/.dotnet"
}

test_build_brings_dotnet_along_where_its_package_is_to_be_had() {
    [ "$(uname -s)-$(uname -m)" = Linux-x86_64 ] || {
        echo 'missing: Linux on x86-64'
        exit 77
    }
    make_clone_with_sdk
    run clone/scripts/build.sh
    assert_code 0
    assert_says_build '-r linux-x64 -p:WithFramework=true'
    echo 'return 1;' >clone/src/Msisf.Cli/Other.cs
    RUNTIME=no run clone/scripts/build.sh
    assert_code 0
    assert_says 'msis uses the .NET of this machine'
    assert_says_build '-r linux-x64'
    assert_silent_on WithFramework
}

test_build_native_has_a_program_for_each_level() {
    [ "$(uname -s)-$(uname -m)" = Linux-x86_64 ] || {
        echo 'missing: Linux on x86-64'
        exit 77
    }
    make_clone_with_sdk
    # What is installed is not of this test.
    for part in cc cmake; do make_executable "sdk/$part" </dev/null; done
    printf 'install_parts() { :; }\n' >>clone/scripts/lib/packages.sh
    run clone/scripts/build.sh --native-all
    assert_code 0
    assert_says_build '-p:Native=true -p:IlcInstructionSet=x86-64-v4'
    assert_same "$(builds)" 2
    assert_same "$(cd clone/publish && ls)" "libSkiaSharp.so
msis
msis-x86-64-v3
msis-x86-64-v4
sources
wwwroot"
    assert_same "$(readlink clone/publish/msis)" msis-x86-64-v3
    run clone/scripts/build.sh --native-all
    assert_says 'up to date'
    run clone/scripts/build.sh
    assert_says 'up to date'
    echo 'return 1;' >clone/src/Msisf.Cli/Other.cs
    run clone/scripts/build.sh
    assert_says 'ahead of time (x86-64-v3 x86-64-v4)'
    assert_same "$(builds)" 4
    run clone/scripts/build.sh --dotnet
    assert_code 0
    assert_no_file clone/publish/msis-x86-64-v3
    run clone/scripts/build.sh
    assert_says 'up to date'
    run clone/scripts/build.sh --nativ
    assert_code 1
    assert_says 'Usage: scripts/build.sh [--dotnet | --native | --native-all | --for NAME]'
}

test_build_for_a_system_leaves_publish_as_it_is() {
    make_clone_with_sdk
    run clone/scripts/build.sh
    run clone/scripts/build.sh --for win-x64
    assert_code 0
    assert_says_build '-r win-x64 -p:WithJit=true'
    assert_file clone/obj/programs/win-x64/msis.exe
    assert_file clone/publish/msis
    run clone/scripts/build.sh --for win-x64
    assert_says 'up to date'
    run clone/scripts/build.sh --for win-x86
    assert_code 1
    assert_says 'unknown system: win-x86. Choose one of: linux-x64 linux-arm64 win-x64 osx-arm64 osx-x64'
}

# assert_says_build TEXT: the last build was asked for it.
assert_says_build() {
    output=$(tail -n 1 "$BUILDS")
    assert_says "$1"
}
