namespace Msisf.Core.Render.Visibility;

/// <summary>
/// The facets that the pixels of a row show, with their planes as the camera sees them. The first pixel is element 1; before and behind the
/// pixels there are elements that show no facet of the image, so that four pixels and their neighbours can be read anywhere.
/// </summary>
internal sealed class FacetRow
{
    /// <summary>The facet of pixels that show no surface.</summary>
    public const long NoSurface = -1;

    /// <summary>The facet of places outside the image.</summary>
    public const long Outside = -2;

    private const int Padding = 6;

    /// <summary>A number for each pixel, the same for the same facet in all rows.</summary>
    public long[] Facets { get; private set; } = [];

    /// <summary>
    /// 1/m: the dot product of this vector and a pixel's ray is the inverse of the parameter at which the ray meets the facet's plane.
    /// Undefined where no facet is shown.
    /// </summary>
    public double[] PlaneX { get; private set; } = [];

    /// <summary>Second component of the vector.</summary>
    public double[] PlaneY { get; private set; } = [];

    /// <summary>Third component of the vector.</summary>
    public double[] PlaneZ { get; private set; } = [];

    /// <summary>I/F of the pixels' centres.</summary>
    public double[] Factors { get; private set; } = [];

    /// <summary>Makes room for a row, and shows nothing in it.</summary>
    public void Clear(int width)
    {
        if (Facets.Length < width + Padding)
        {
            Facets = new long[width + Padding];
            (PlaneX, PlaneY, PlaneZ) = (new double[width + Padding], new double[width + Padding], new double[width + Padding]);
            Factors = new double[width + Padding];
        }

        Facets.AsSpan().Fill(Outside);
    }
}
