namespace Msisf.Core.Terrain;

/// <summary>Resolution of a grid: samples a degree of a cylindrical one, metres a sample of another.</summary>
public readonly record struct GridResolution
{
    private GridResolution(int? pixelsPerDegree, double metresPerPixel) =>
        (PixelsPerDegree, MetresPerPixel) = (pixelsPerDegree, metresPerPixel);

    /// <summary>px/deg; null for a grid that is not one of latitude and longitude.</summary>
    public int? PixelsPerDegree { get; }

    /// <summary>m: distance of neighbouring samples on the reference sphere; at the equator, or at the pole of a polar map.</summary>
    public double MetresPerPixel { get; }

    /// <summary>The number as it is given for this kind of map: px/deg or m/px.</summary>
    public double Number => PixelsPerDegree ?? MetresPerPixel;

    /// <summary>Unit of <see cref="Number"/>.</summary>
    public string Unit => PixelsPerDegree is null ? "m/px" : "px/deg";

    /// <summary>The resolution of a grid of latitude and longitude.</summary>
    public static implicit operator GridResolution(int pixelsPerDegree) => FromPixelsPerDegree(pixelsPerDegree);

    /// <summary>The resolution of a grid of latitude and longitude.</summary>
    public static GridResolution FromPixelsPerDegree(int pixelsPerDegree) =>
        new(pixelsPerDegree, MoonConstants.ReferenceRadius * Math.PI / 180.0 / pixelsPerDegree);

    /// <summary>The same resolution on a sphere of another radius: as many samples a degree lie farther apart on a larger one.</summary>
    /// <param name="radius">m.</param>
    public GridResolution OnSphere(double radius) =>
        PixelsPerDegree is null ? this : new(PixelsPerDegree, MetresPerPixel * (radius / MoonConstants.ReferenceRadius));

    /// <summary>The resolution of a grid whose samples lie metres apart.</summary>
    public static GridResolution FromMetresPerPixel(double metresPerPixel) => new(null, metresPerPixel);

    /// <summary>How many times this grid's resolution was halved to get another one's.</summary>
    public int HalvingsTo(GridResolution coarser) => (int)Math.Round(Math.Log2(coarser.MetresPerPixel / MetresPerPixel));

    /// <summary>The number without its unit.</summary>
    public string NumberText => Number.ToString("R", CultureInfo.InvariantCulture);

    /// <summary>E.g. "64 px/deg" or "20 m/px".</summary>
    public override string ToString() => $"{NumberText} {Unit}";
}
