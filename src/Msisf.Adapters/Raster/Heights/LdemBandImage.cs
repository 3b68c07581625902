using Msisf.Core.Errors;
using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>An LDEM model of a band around the Moon between two latitudes, as SLDEM2015; lines count in the whole Moon's grid.</summary>
public sealed class LdemBandImage : ITerrainGrid, IDisposable
{
    private readonly LdemImage _image;

    private LdemBandImage(LdemImage image)
    {
        _image = image;
        int pixelsPerDegree = image.PixelsPerDegree;
        Projection = new Equirectangular(pixelsPerDegree);
        Window = new GridWindow(
            (int)(90.0 - image.Set.Parts.Max(part => part.NorthDegrees)) * pixelsPerDegree,
            (int)(90.0 - image.Set.Parts.Min(part => part.SouthDegrees)) * pixelsPerDegree,
            0,
            Samples);
    }

    /// <inheritdoc/>
    public string ProductId => _image.ProductId;

    /// <inheritdoc/>
    public MapProjection Projection { get; }

    /// <inheritdoc/>
    public int Lines => 180 * _image.PixelsPerDegree;

    /// <inheritdoc/>
    public int Samples => 360 * _image.PixelsPerDegree;

    /// <inheritdoc/>
    public GridWindow Window { get; }

    /// <inheritdoc/>
    public double ReferenceRadius => _image.ReferenceRadius;

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits => _image.RadiusLimits;

    /// <summary>Opens all images of a model.</summary>
    /// <exception cref="BadInputException">An image is missing, unreadable, or not as long as its label says.</exception>
    public static LdemBandImage Open(LdemSet set) => new(LdemImage.OpenParts(set));

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        CheckLines(line, 1);
        _image.ReadRadii(line, firstSample, radii);
    }

    /// <inheritdoc/>
    public (double Minimum, double Maximum) RadiusBounds(int firstLine, int lines, int firstSample, int samples)
    {
        CheckLines(firstLine, lines);
        return _image.RadiusBounds(firstLine, lines, firstSample, samples);
    }

    /// <inheritdoc/>
    public void ReleasePages() => _image.ReleasePages();

    /// <summary>Unmaps the files.</summary>
    public void Dispose() => _image.Dispose();

    private void CheckLines(int firstLine, int lines)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(firstLine, Window.FirstLine);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(firstLine + lines, Window.EndLine);
    }
}
