# shellcheck shell=bash
# Sourced after common.sh and packages.sh: finds the .NET 10 SDK.

export DOTNET_CLI_TELEMETRY_OPTOUT=1 DOTNET_NOLOGO=1
# Short runs: what the runtime notes for a second compilation costs them more than it gains; MSISF itself is set so.
export DOTNET_TieredPGO=0
# seldom_collecting COMMAND...: compilers keep most of what they make, and looking through it again and again takes them long.
seldom_collecting() { DOTNET_GCgen0size=0x6000000 "$@"; } # bytes: 100 MB

# Names of the xunit projects.
test_projects() {
    grep -l Microsoft.NET.Test.Sdk tests/*/*.csproj | sed 's|.*/||; s|\.csproj$||'
}

# Puts an SDK 10.0 on the PATH and into DOTNET_ROOT; fails if there is none.
find_dotnet() {
    local candidate sdk
    for candidate in "$(command -v dotnet || true)" ~/.dotnet/dotnet /usr/share/dotnet/dotnet /usr/lib/dotnet/dotnet \
        /usr/local/share/dotnet/dotnet; do
        [ -x "$candidate" ] || continue
        # a line is: 10.0.100 [/usr/share/dotnet/sdk]
        sdk=$("$candidate" --list-sdks 2>/dev/null | sed -n 's/^10\.0\.[^ ]* \[\(.*\)\/sdk\]$/\1/p' | head -n 1)
        [ -n "$sdk" ] || continue
        export DOTNET_ROOT=$sdk PATH="$sdk:$PATH"
        return 0
    done
    return 1
}

# The lists of packages may be older than .NET 10, or not there at all.
apt_has_dotnet() {
    have apt-cache || return 1
    apt-cache show dotnet-sdk-10.0 >/dev/null 2>&1 ||
        { apt_get update >/dev/null 2>&1 && apt-cache show dotnet-sdk-10.0 >/dev/null 2>&1; }
}

# As find_dotnet, and installs the SDK where the distribution has it; otherwise says how to get it and ends the script.
ensure_dotnet() {
    if ! find_dotnet; then
        ! apt_has_dotnet || apt_install dotnet-sdk-10.0 || true
        find_dotnet || die 'the .NET SDK 10.0 is missing. This installs it into ~/.dotnet, where it is found:
    curl -fsSL https://dot.net/v1/dotnet-install.sh | bash -s -- --channel 10.0'
    fi
    # The SDK runs without ICU, the tests do not: they set a culture with decimal commas.
    install_parts icu || export DOTNET_SYSTEM_GLOBALIZATION_INVARIANT=1
}
