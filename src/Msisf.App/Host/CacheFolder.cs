namespace Msisf.App.Host;

/// <summary>Finds the folder for files that can be made again and have no other place.</summary>
internal static class CacheFolder
{
    /// <summary>
    /// The folder: $XDG_CACHE_HOME/msisf, else %LOCALAPPDATA%\msisf, else $HOME/.cache/msisf; null if none of these variables is set.
    /// </summary>
    public static string? Of(ProgramHost host)
    {
        string? parent = host.Environment("XDG_CACHE_HOME")
            ?? host.Environment("LOCALAPPDATA")
            ?? (host.Environment("HOME") is { } home ? Path.Combine(home, ".cache") : null);
        return parent is null ? null : Path.Combine(parent, "msisf");
    }
}
