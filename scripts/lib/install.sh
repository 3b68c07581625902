# shellcheck shell=bash
# Sourced after common.sh: puts msis, its manual page and its completions under a prefix such as ~/.local, and takes them away again.

# The files under a prefix, each with the words that make its text and a text by which it is known for ours.
installed_texts='
share/man/man1/msis.1|man|.TH MSIS 1
share/bash-completion/completions/msis|completion bash|Completion of msis for bash
share/zsh/site-functions/_msis|completion zsh|Completion of msis for zsh
share/fish/vendor_completions.d/msis.fish|completion fish|Completion of msis for fish'

# is_our_link FILE: a link to a starter of MSISF, of this clone, of another one, or of one that is gone.
is_our_link() {
    local target
    [ -L "$1" ] || return 1
    target=$(readlink "$1")
    [ "${target##*/}" = msis ] && { [ ! -e "$target" ] || grep -q 'scripts/build.sh published' "$target"; }
}

# is_our_text FILE MARK
is_our_text() { [ -f "$1" ] && grep -qF -- "$2" "$1"; }

# install_program ROOT PREFIX: links to ROOT/msis, so that a new build needs no new installation.
install_program() {
    local root=$1 prefix file words mark
    mkdir -p "$2/bin" || die "$2 can't be written: choose a folder of your own, e.g. ~/.local"
    prefix=$(cd "$2" >/dev/null && pwd -P)
    if [ -e "$prefix/bin/msis" ] || [ -L "$prefix/bin/msis" ]; then
        is_our_link "$prefix/bin/msis" || die "$prefix/bin/msis is another program: it stays. Move it, or choose another folder"
    fi
    while IFS='|' read -r file words mark; do
        [ -n "$file" ] || continue
        if [ -e "$prefix/$file" ]; then
            is_our_text "$prefix/$file" "$mark" || die "$prefix/$file is not a file of msis: it stays. Move it, or choose another folder"
        fi
        mkdir -p "$prefix/${file%/*}"
        # shellcheck disable=SC2086 # one or two words
        "$root/msis" $words >"$prefix/$file.partial" || {
            rm -f "$prefix/$file.partial"
            die "msis $words failed: please report this"
        }
        mv "$prefix/$file.partial" "$prefix/$file"
    done <<<"$installed_texts"
    ln -sfn "$root/msis" "$prefix/bin/msis"
    say "Installed: $prefix/bin/msis, its manual page, and its completions for bash, zsh and fish."
    case ":$PATH:" in
        *":$prefix/bin:"*) ;;
        *) say "Put it on the PATH, e.g. in ~/.bashrc:  export PATH=\"$prefix/bin:\$PATH\"" ;;
    esac
    say "zsh needs, before compinit in ~/.zshrc:  fpath=(\"$prefix/share/zsh/site-functions\" \$fpath)"
}

# uninstall_program PREFIX: removes what install_program has made, and nothing else.
uninstall_program() {
    local prefix=$1 file words mark
    if is_our_link "$prefix/bin/msis"; then
        rm "$prefix/bin/msis"
    fi
    while IFS='|' read -r file words mark; do
        if [ -n "$file" ] && is_our_text "$prefix/$file" "$mark"; then
            rm "$prefix/$file"
        fi
    done <<<"$installed_texts"
    say "msis is no longer installed in $prefix; this folder is as it was."
}
