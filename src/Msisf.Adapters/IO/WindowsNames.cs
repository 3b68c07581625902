namespace Msisf.Adapters.IO;

/// <summary>The names that Windows does not give to files, though other systems do.</summary>
public static class WindowsNames
{
    private static readonly string[] Devices =
    [
        "CON", "PRN", "AUX", "NUL",
        .. Enumerable.Range(1, 9).SelectMany(number => new[] { Invariant($"COM{number}"), Invariant($"LPT{number}") }),
    ];

    /// <summary>What keeps a name from being that of a file.</summary>
    /// <param name="name">Without folders; with extension or without.</param>
    /// <returns>Null if nothing does.</returns>
    /// <remarks>Microsoft, "Naming Files, Paths, and Namespaces".</remarks>
    public static string? FaultOf(string name)
    {
        if (name.FirstOrDefault(letter => letter < ' ' || "<>:\"/\\|?*".Contains(letter)) is var letter and not '\0')
        {
            return $"Windows allows no {letter} in names of files";
        }

        string start = name.Split('.')[0].TrimEnd(' ');
        return Devices.Contains(start, StringComparer.OrdinalIgnoreCase) ? $"{start} is a device of Windows"
            : name.EndsWith(' ') || name.EndsWith('.') ? "names of files on Windows do not end with a space or a point"
            : null;
    }
}
