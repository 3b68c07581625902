using System.Globalization;
using System.Text.RegularExpressions;

namespace Msisf.Benchmarks.Fronts;

/// <summary>What the patterns of an image amount to.</summary>
/// <param name="Files">How many.</param>
/// <param name="Bytes">Of all files.</param>
/// <param name="Triangles">That their first lines name.</param>
internal sealed partial record PatternFolder(int Files, long Bytes, long Triangles)
{
    /// <summary>Counts all patterns in a folder and below it.</summary>
    public static PatternFolder Of(string root)
    {
        FileInfo[] files = Directory.Exists(root) ? new DirectoryInfo(root).GetFiles("*.inc", SearchOption.AllDirectories) : [];
        return new PatternFolder(files.Length, files.Sum(file => file.Length), files.Sum(TrianglesOf));
    }

    private static long TrianglesOf(FileInfo file)
    {
        string header = File.ReadLines(file.FullName).FirstOrDefault() ?? string.Empty;
        return Faces().Matches(header).Sum(match => long.Parse(match.Groups["count"].Value, CultureInfo.InvariantCulture));
    }

    [GeneratedRegex(@"\bfaces=(?<count>[0-9]+)")]
    private static partial Regex Faces();
}
