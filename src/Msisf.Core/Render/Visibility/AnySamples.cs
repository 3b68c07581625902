namespace Msisf.Core.Render.Visibility;

/// <summary>The samples of a lens, at <see cref="Band.SampleColumns"/> and <see cref="Band.SampleRows"/>.</summary>
internal readonly struct AnySamples : ISampleKind
{
    /// <inheritdoc/>
    public static bool IsPixelCentre => false;
}
