namespace Msisf.Benchmarks.Definitions;

/// <summary>A way to make an image, whose time and error are measured.</summary>
/// <param name="Name">In tables and plots, e.g. "povray, full".</param>
/// <param name="Kind">Whose way.</param>
/// <param name="Options">Of msis, beyond the renderer; none for the thesis's way.</param>
/// <param name="IsRepeated">The image is made several times where it takes seconds; otherwise once.</param>
internal sealed record Setting(string Name, SettingKind Kind, IReadOnlyList<string> Options, bool IsRepeated = false)
{
    /// <summary>Of the native renderer: samples along a pixel's edge.</summary>
    public int SubsamplesPerAxis { get; init; } = 1;

    /// <summary>The model itself is drawn, not a coarser level.</summary>
    public bool IsFull { get; init; }

    /// <summary>It shows points that no other way shows; other antialiasing of a surface does not.</summary>
    public bool HasOwnSurface { get; init; } = true;

    /// <summary>For the name of a folder.</summary>
    public string FolderName => string.Concat(Name.Where(letter => char.IsAsciiLetterOrDigit(letter) || letter == '.'));
}
