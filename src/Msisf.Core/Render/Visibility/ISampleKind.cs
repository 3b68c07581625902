namespace Msisf.Core.Render.Visibility;

/// <summary>Where the samples of the pixels lie. The drawing code is compiled for each kind, so that a pinhole pays nothing.</summary>
internal interface ISampleKind
{
    /// <summary>Whether each sample is its pixel's centre; otherwise it is where the band says.</summary>
    static abstract bool IsPixelCentre { get; }
}

/// <summary>The samples of a pinhole.</summary>
internal readonly struct PixelCentres : ISampleKind
{
    /// <inheritdoc/>
    public static bool IsPixelCentre => true;
}

/// <summary>The samples of a lens, at <see cref="Band.SampleColumns"/> and <see cref="Band.SampleRows"/>.</summary>
internal readonly struct AnySamples : ISampleKind
{
    /// <inheritdoc/>
    public static bool IsPixelCentre => false;
}
