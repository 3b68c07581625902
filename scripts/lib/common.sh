# shellcheck shell=bash
# Sourced by every script: messages, and commands that need root.

say() { printf '%s\n' "$*"; }

warn() { printf '%s: %s\n' "${0##*/}" "$*" >&2; }

die() {
    warn "$*"
    exit 1
}

# help_if_asked ARGUMENTS...: with --help the comment at the head of the script is printed, and nothing else is done.
help_if_asked() {
    case ${1:-} in
        -h | --help)
            sed -n '2,/^[^#]/s/^#\( \|$\)//p' "${BASH_SOURCE[-1]}"
            exit 0
            ;;
    esac
}

# end_with_children: what the script has started ends with it, when a signal ends it.
end_with_children() {
    trap 'end_children $$; exit 130' INT
    trap 'end_children $$; exit 143' TERM
}

end_children() {
    local child
    for child in $(pgrep -P "$1" 2>/dev/null); do
        end_children "$child"
        kill "$child" 2>/dev/null || true
    done
}

# within SECONDS COMMAND...: ends a command that hangs, where the system has a timeout.
within() {
    local seconds=$1
    shift
    if have timeout; then
        timeout --kill-after=10 "$seconds" "$@"
    else
        "$@"
    fi
}

have() { command -v "$1" >/dev/null 2>&1; }

# What a run as root has made belongs to root: a later run of another user would fail half way. Checks this folder.
require_own_folders() {
    local foreign
    foreign=$(find . -name .git -prune -o -type d ! -writable -print 2>/dev/null | head -n 1) || true
    [ -z "$foreign" ] || die "$foreign is not yours to write. Run as its owner, or: sudo chown -R $(id -un) '$PWD'"
}

# Without a terminal sudo must not ask: a run in the background would wait for ever.
as_root() {
    if [ "$(id -u)" -eq 0 ]; then
        "$@"
    elif ! have sudo; then
        return 1
    elif [ -t 0 ]; then
        sudo "$@"
    else
        sudo -n "$@"
    fi
}
