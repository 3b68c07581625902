using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Tiles;
using Msisf.Core.Tiles;

namespace Msisf.Benchmarks.Thesis;

/// <summary>The thesis's patterns: text meshes in absolute kilometres, with its overlap.</summary>
internal static class ThesisPatterns
{
    /// <summary>px/deg from which on the thesis takes the narrower overlap.</summary>
    private const int FineResolution = 64;

    private const double Margin = 0.5; // degrees, thesis appendix B.4
    private const double FineMargin = 0.1; // degrees

    /// <summary>Makes those that are not there.</summary>
    /// <param name="folder">The repository.</param>
    /// <param name="tiles">Which.</param>
    /// <param name="image">The elevation model.</param>
    /// <returns>The files, by latitude, then longitude.</returns>
    public static IReadOnlyList<string> Make(string folder, IEnumerable<TileId> tiles, LdemImage image)
    {
        double margin = image.PixelsPerDegree >= FineResolution ? FineMargin : Margin;
        return new PatternRepository(folder).EnsurePatterns(
            tiles, image, new PatternOptions(margin, PatternFormat.Mesh), Environment.ProcessorCount).Paths;
    }
}
