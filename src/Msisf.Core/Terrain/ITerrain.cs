namespace Msisf.Core.Terrain;

/// <summary>The ground that a run draws: one elevation model, or several of which the finest wins. Safe for several threads.</summary>
public interface ITerrain
{
    /// <summary>The products' name or names, e.g. "LDEM_4" or "LDEM_4+LDEM_80S_80M".</summary>
    string ProductId { get; }

    /// <summary>The finest resolution.</summary>
    GridResolution Resolution { get; }

    /// <summary>
    /// Minimum and maximum radius that samples can have, m, known without reading any. The default is the maximum relief of the Moon.
    /// </summary>
    (double Min, double Max) RadiusLimits => (ReferenceRadius - MoonConstants.MaxRelief, ReferenceRadius + MoonConstants.MaxRelief);

    /// <summary>m: radius of the sphere over which heights are counted; that of the Moon unless the model is of another body.</summary>
    double ReferenceRadius => MoonConstants.ReferenceRadius;

    /// <summary>Number of models; the facets of the seams between several have this number as their part.</summary>
    int PartCount => 1;

    /// <summary>
    /// Tells the models that most of the samples read so far are not needed again soon, so that their memory may be released. Reading is
    /// still possible.
    /// </summary>
    void ReleasePages()
    {
    }
}
