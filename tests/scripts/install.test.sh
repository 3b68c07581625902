# shellcheck shell=bash
. "$MSISF_TESTED_ROOT/tests/scripts/lib.sh"

# A clone whose parts are all there; its program prints the texts that are installed, each with the mark of the real one.
make_set_up_clone() {
    make_clone "$PWD/my clone"
    make_model 'my clone/input/ldem' LDEM_4 IMG LBL
    local script
    for script in build get-cspice; do
        make_executable "my clone/scripts/$script.sh" <<'DONE'
#!/bin/sh
echo done
DONE
    done
    cat >>'my clone/scripts/lib/packages.sh' <<'NOTHING'
install_parts() { :; }
NOTHING
    make_executable 'my clone/publish/msis' <<'PROGRAM'
#!/bin/sh
case $1 in
    man) echo '.TH MSIS 1 ""' ;;
    completion) echo "# Completion of msis for $2; made by: msis completion $2" ;;
    *) echo "program: $*" ;;
esac
PROGRAM
}

files_below() { (cd "$1" && find . ! -type d | LC_ALL=C sort | tr '\n' ' '); }

test_install_puts_program_manual_and_completions_where_shells_look() {
    make_set_up_clone
    run 'my clone/quickstart.sh' --install 'a prefix'
    assert_code 0
    assert_says 'Put it on the PATH'
    assert_same "$(files_below 'a prefix')" './bin/msis ./share/bash-completion/completions/msis ./share/fish/vendor_completions.d/msis.fish ./share/man/man1/msis.1 ./share/zsh/site-functions/_msis '
    assert_same "$(cat 'a prefix/share/man/man1/msis.1')" '.TH MSIS 1 ""'
    cd / || exit
    PATH="$OLDPWD/a prefix/bin:$PATH" run msis --version
    assert_same "$output" 'program: --version'
}

test_install_again_renews_it_and_says_nothing_of_a_path_that_is_right() {
    make_set_up_clone
    run 'my clone/quickstart.sh' --install prefix
    echo '# Completion of msis for bash; of an older version' >prefix/share/bash-completion/completions/msis
    PATH="$PWD/prefix/bin:$PATH" run 'my clone/quickstart.sh' --install prefix
    assert_code 0
    assert_silent_on 'Put it on the PATH'
    assert_same "$(cat prefix/share/bash-completion/completions/msis)" '# Completion of msis for bash; made by: msis completion bash'
    mv 'my clone' moved
    run moved/quickstart.sh --install prefix
    assert_code 0
    assert_same "$(readlink prefix/bin/msis)" "$(cd moved && pwd -P)/msis"
}

test_install_leaves_what_belongs_to_others() {
    make_set_up_clone
    mkdir -p prefix/bin prefix/share/man/man1
    echo 'another program' >prefix/bin/msis
    run 'my clone/quickstart.sh' --install prefix
    assert_code 1
    assert_says 'prefix/bin/msis is another program: it stays'
    rm prefix/bin/msis
    echo '.TH OTHER 1' >prefix/share/man/man1/msis.1
    run 'my clone/quickstart.sh' --install prefix
    assert_code 1
    assert_says 'msis.1 is not a file of msis'
    assert_same "$(cat prefix/share/man/man1/msis.1)" '.TH OTHER 1'
    assert_no_file prefix/bin/msis
}

test_uninstall_removes_what_was_installed_and_nothing_else() {
    make_set_up_clone
    mkdir -p prefix/bin
    echo mine >prefix/bin/other
    run 'my clone/quickstart.sh' --install prefix
    run 'my clone/quickstart.sh' --uninstall prefix
    assert_code 0
    assert_same "$(files_below prefix)" './bin/other '
    run 'my clone/quickstart.sh' --uninstall prefix
    assert_code 0
}

test_quickstart_wrong_arguments_are_named() {
    make_set_up_clone
    run 'my clone/quickstart.sh' --instal prefix
    assert_code 1
    assert_says 'unknown argument --instal. Usage:'
    run 'my clone/quickstart.sh' --install
    assert_code 1
    assert_says '--install needs one folder'
    run 'my clone/quickstart.sh' --install a b
    assert_code 1
    assert_says '--install needs one folder'
}
