namespace Msisf.Core.Render.Visibility;

/// <summary>The samples of a pinhole.</summary>
internal readonly struct PixelCentres : ISampleKind
{
    /// <inheritdoc/>
    public static bool IsPixelCentre => true;
}
