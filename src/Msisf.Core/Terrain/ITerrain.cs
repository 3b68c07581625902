namespace Msisf.Core.Terrain;

/// <summary>The ground that a run draws: one elevation model, or several of which the finest wins. Safe for several threads.</summary>
public interface ITerrain
{
    /// <summary>The products' name or names, e.g. "LDEM_4" or "LDEM_4+LDEM_80S_80M".</summary>
    string ProductId { get; }

    /// <summary>The finest resolution.</summary>
    GridResolution Resolution { get; }

    /// <summary>
    /// Minimum and maximum radius that samples can have, m, known without reading any. The default is the maximum relief of the body.
    /// </summary>
    (double Min, double Max) RadiusLimits =>
        (ReferenceRadius - MoonConstants.MaxReliefOver(ReferenceRadius), ReferenceRadius + MoonConstants.MaxReliefOver(ReferenceRadius));

    /// <summary>m: radius of the sphere over which heights are counted; that of the Moon unless the model is of another body.</summary>
    double ReferenceRadius => MoonConstants.ReferenceRadius;

    /// <summary>The models, the coarsest first; of a single one itself.</summary>
    IReadOnlyList<ITerrainGrid> Models { get; }

    /// <summary>The ground in which detail is invented: the models with what they get from finer ones, the coarsest first.</summary>
    IReadOnlyList<ITerrainGrid> Grounds => Models;

    /// <summary>Whether it goes around the whole body.</summary>
    bool IsWholeBody => true;

    /// <summary>
    /// Resolution at which each of several models is drawn; null for one that is left out, because a coarser one is as fine. Those of
    /// invented windows follow. Empty for one model.
    /// </summary>
    IReadOnlyList<GridResolution?> DrawnResolutions => [];

    /// <summary>Name of the ground that is invented below the models' resolution; null if none is.</summary>
    string? InventedName => null;

    /// <summary>
    /// Facets of this part and of those after it are of invented ground, or join it to the models; null if none is to be invented.
    /// </summary>
    int? FirstInventedPart => null;

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
