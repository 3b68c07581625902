namespace Msisf.App.Host;

/// <summary>Where the program keeps files that can be made again and have no other place.</summary>
internal static class CacheFolder
{
    /// <summary>
    /// $XDG_CACHE_HOME/msisf, else %LOCALAPPDATA%\msisf, else $HOME/.cache/msisf; null if the environment has none of them.
    /// </summary>
    public static string? Of(ProgramHost host)
    {
        string? parent = host.Environment("XDG_CACHE_HOME")
            ?? host.Environment("LOCALAPPDATA")
            ?? (host.Environment("HOME") is { } home ? Path.Combine(home, ".cache") : null);
        return parent is null ? null : Path.Combine(parent, "msisf");
    }
}
