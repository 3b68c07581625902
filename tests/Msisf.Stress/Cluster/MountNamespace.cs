using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>Runs shell scripts that may mount what only they see, and that is gone with them: as root, or in a user namespace.</summary>
internal static class MountNamespace
{
    private static readonly TimeSpan Limit = TimeSpan.FromMinutes(5);

    private static readonly Lazy<string[]?> Prefix = new(
        () => ((string[][])[["--mount"], ["--user", "--map-root-user", "--mount"]]).FirstOrDefault(CanMount));

    /// <summary>What is missing; null if scripts can run.</summary>
    public static string? MissingPart => Prefix.Value is null ? "leave to mount (unshare --mount)" : null;

    /// <summary>Runs a script.</summary>
    /// <param name="folder">Its working directory.</param>
    /// <param name="script">For sh, with -eu.</param>
    /// <param name="arguments">Its "$@".</param>
    /// <returns>Its standard output.</returns>
    /// <exception cref="InvalidOperationException">It fails; the message has what it said.</exception>
    public static string Run(string folder, string script, params IReadOnlyList<string> arguments)
    {
        using RunningProgram program = RunningProgram.Start(
            "unshare", [.. Prefix.Value!, "sh", "-euc", script, "sh", .. arguments], folder);
        return program.End(Limit).Succeeded().Output;
    }

    private static bool CanMount(string[] prefix)
    {
        try
        {
            using RunningProgram program = RunningProgram.Start("unshare", [.. prefix, "mount", "-t", "tmpfs", "none", "/mnt"], "/");
            return program.End(Limit).ExitCode == 0;
        }
        catch (System.ComponentModel.Win32Exception)
        {
            return false; // there is no unshare
        }
    }
}
