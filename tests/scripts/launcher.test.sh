# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

make_clone_with_program() {
    make_clone "$PWD/clone"
    make_executable clone/publish/msis <<'PROGRAM'
#!/bin/sh
printf '<%s>' "$@"
echo " dotnet=${DOTNET_ROOT:-none} folder=$PWD"
exit 3
PROGRAM
    unset DOTNET_ROOT
}

test_launcher_in_another_folder_passes_arguments_folder_and_exit_code() {
    make_clone_with_program
    mkdir elsewhere
    clone=$PWD/clone
    cd elsewhere || exit
    run "$clone/msis" --fixed-state '{1,2, 3}' ''
    assert_code 3
    assert_says "<--fixed-state><{1,2, 3}><> dotnet=none folder=$PWD"
}

test_launcher_relative_path_finds_its_program() {
    make_clone_with_program
    run clone/msis a
    assert_says '<a>'
    cd clone || exit
    run sh msis b
    assert_says '<b>'
}

test_launcher_chain_of_symbolic_links_finds_its_program() {
    make_clone_with_program
    mkdir bin
    ln -s ../clone/msis bin/first
    ln -s first bin/second
    ln -s "$PWD/bin/second" third
    run ./third a
    assert_code 3
    assert_says '<a>'
    PATH="$PWD/bin:$PATH" run second b
    assert_says '<b>'
}

test_launcher_not_built_says_what_to_run() {
    make_clone "$PWD/clone"
    run clone/msis --version
    assert_code 1
    assert_says 'msis: error: the program is not built yet'
    assert_says 'clone/quickstart.sh first'
}

# make_native_clone FLAGS: a clone with programs for two levels of processors, on a processor with these flags.
make_native_clone() {
    make_clone "$PWD/clone"
    printf 'processor\t: 0\nflags\t\t: fpu %s sse\nbugs\t\t: avx512vl\n' "$1" >cpuinfo
    sed -i "s|</proc/cpuinfo|<'$PWD/cpuinfo'|" clone/msis
    for level in x86-64-v3 x86-64-v4; do
        printf '#!/bin/sh\necho "program of %s: $*"\n' "$level" | make_executable "clone/publish/msis-$level"
    done
    ln -sf msis-x86-64-v3 clone/publish/msis
}

test_launcher_takes_the_program_for_this_processor() {
    make_native_clone 'avx2 avx512f avx512vl'
    run clone/msis a
    assert_same "$output" 'program of x86-64-v4: a'
    rm clone/publish/msis-x86-64-v4
    run clone/msis b
    assert_same "$output" 'program of x86-64-v3: b'
    make_native_clone 'avx2 avx512f'
    run clone/msis c
    assert_same "$output" 'program of x86-64-v3: c'
}

test_launcher_on_a_processor_without_avx2_says_what_to_run() {
    make_native_clone avx
    run clone/msis --version
    assert_code 1
    assert_same "$output" \
        'msis: error: this program needs a processor with AVX2 (x86-64-v3). Build it here from its source: scripts/build.sh --dotnet.'
}

test_launcher_with_the_program_for_avx512_alone_says_what_to_run_elsewhere() {
    make_native_clone 'avx2 avx512vl'
    rm clone/publish/msis-x86-64-v3
    ln -sf msis-x86-64-v4 clone/publish/msis
    run clone/msis a
    assert_same "$output" 'program of x86-64-v4: a'
    printf 'flags\t\t: avx2\n' >cpuinfo
    run clone/msis a
    assert_code 1
    assert_same "$output" \
        'msis: error: this program needs a processor with AVX-512 (x86-64-v4). Build it for both kinds: scripts/build.sh --native-all.'
}

test_launcher_dotnet_noted_by_the_build_is_used_unless_the_user_names_one() {
    make_clone_with_program
    make_executable "$PWD/my dotnet/dotnet" </dev/null
    echo "$PWD/my dotnet" >clone/publish/dotnet-root
    run clone/msis
    assert_says "dotnet=$PWD/my dotnet folder"
    DOTNET_ROOT=/mine run clone/msis
    assert_says 'dotnet=/mine folder'
    rm -r 'my dotnet'
    run clone/msis
    assert_says 'dotnet=none folder'
}
