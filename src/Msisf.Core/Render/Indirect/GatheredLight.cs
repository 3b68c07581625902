namespace Msisf.Core.Render.Indirect;

/// <summary>What a group of points gets.</summary>
/// <param name="isIrradiance">Whether irradiance and its mean direction are asked for, not the brightness towards the camera.</param>
internal sealed class GatheredLight(bool isIrradiance)
{
    /// <summary>Whether irradiance is asked for.</summary>
    public bool IsIrradiance => isIrradiance;

    /// <summary>I/F of each point before the map of the reflectance scales it; or the irradiance over the Sun's.</summary>
    public double[] Values { get; } = new double[Receivers.Size];

    /// <summary>Directions from which irradiance comes, each times its part.</summary>
    public Vector3D[] Directions { get; } = new Vector3D[Receivers.Size];

    /// <summary>Sum over the points of the square of the error, estimated from how much neighbouring samples differ.</summary>
    public double Variance { get; set; }

    /// <summary>
    /// Sum over the points of the square of the sum of the samples' magnitudes, without bias: what the samples change of a point's light is
    /// no more than that.
    /// </summary>
    public double Bound { get; set; }

    /// <summary>rad over their facets: the highest near ground that rays of the points met.</summary>
    public double Top { get; set; }

    /// <summary>Forgets everything.</summary>
    public void Clear()
    {
        Array.Clear(Values);
        Array.Clear(Directions);
        (Variance, Bound, Top) = (0.0, 0.0, 0.0);
    }
}
