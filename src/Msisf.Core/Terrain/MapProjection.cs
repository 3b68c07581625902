namespace Msisf.Core.Terrain;

/// <summary>Where the samples of a regular grid lie on the Moon; line 0 and sample 0 are the centre of the first pixel.</summary>
public abstract record MapProjection
{
    /// <summary>The resolution, as it is given for this kind of map.</summary>
    public abstract GridResolution Resolution { get; }

    /// <summary>
    /// The projection of the grid whose line i and sample j stand for the lines 2 i, 2 i + 1 and the samples 2 j, 2 j + 1 of this one; null
    /// if there is none.
    /// </summary>
    public abstract MapProjection? Halved();

    /// <summary>Direction of a place of the grid from the Moon's centre, body-fixed, length 1.</summary>
    /// <param name="line">px from the centre of the top line, downwards.</param>
    /// <param name="sample">px from the centre of the leftmost sample, to the right.</param>
    public abstract Vector3D DirectionOf(double line, double sample);

    /// <summary>Line and sample of a direction, px from the centre of the first pixel; they may lie outside the grid.</summary>
    /// <param name="directionBodyFixed">MOON_ME, of any length above 0.</param>
    public abstract (double Line, double Sample) PixelOf(Vector3D directionBodyFixed);
}
