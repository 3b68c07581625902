using Msisf.Core.Terrain;

namespace Msisf.Adapters.Raster.Heights;

/// <summary>
/// An LDEM model of a part of the Moon: the surroundings of a pole, or a band between two latitudes, as SLDEM2015, whose lines count in
/// the whole Moon's grid.
/// </summary>
/// <remarks>As of <see cref="LdemImage"/>.</remarks>
public sealed class LdemMapImage : ITerrainGrid, IDisposable
{
    private readonly LdemImage _image;

    private LdemMapImage(LdemImage image)
    {
        _image = image;
        Projection = image.Set.Parts[0].Polar is { } polar ? polar : new Equirectangular(image.PixelsPerDegree);
        Window = new GridWindow(image.Parts.Min(part => part.FirstLine), image.Parts.Max(part => part.EndLine), 0, Samples);
    }

    /// <inheritdoc/>
    public string ProductId => _image.ProductId;

    /// <inheritdoc/>
    public bool HoldsMeans => RasterProducts.HoldsMeans(ProductId);

    /// <inheritdoc/>
    public MapProjection Projection { get; }

    /// <inheritdoc/>
    public int Lines => _image.Lines;

    /// <inheritdoc/>
    public int Samples => _image.Samples;

    /// <inheritdoc/>
    public GridWindow Window { get; }

    /// <inheritdoc/>
    public double ReferenceRadius => _image.ReferenceRadius;

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits => _image.RadiusLimits;

    /// <summary>Opens all images of a model.</summary>
    /// <exception cref="BadInputException">An image is missing, unreadable, or not as long as its label says.</exception>
    public static LdemMapImage Open(LdemSet set) => new(LdemImage.OpenParts(set));

    /// <inheritdoc/>
    public void ReadRadii(int line, int firstSample, Span<double> radii)
    {
        // A band may go around the Moon, which the image checks.
        if (line < Window.FirstLine || line >= Window.EndLine
            || (Projection is PolarStereographic && radii.Length > Samples - firstSample))
        {
            _image.RefuseBlock(line, 1, firstSample, radii.Length);
        }

        _image.ReadRadii(line, firstSample, radii);
    }

    /// <inheritdoc/>
    public void ReleasePages() => _image.ReleasePages();

    /// <summary>Unmaps the files.</summary>
    public void Dispose() => _image.Dispose();
}
