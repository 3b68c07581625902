using Msisf.Core.Terrain;

namespace Msisf.Core.Lod;

/// <summary>A computed level of a model of the whole Moon.</summary>
public sealed class ReducedMoon : ReducedGrid, IGlobalGrid
{
    /// <inheritdoc cref="ReducedGrid"/>
    internal ReducedMoon(IGlobalGrid source, int halvings, ReducedGrid? below, LodCache cache, int samplesBetweenReleases)
        : base(source, halvings, below, cache, samplesBetweenReleases) => PixelsPerDegree = source.PixelsPerDegree >> halvings;

    /// <inheritdoc/>
    public int PixelsPerDegree { get; }
}
