namespace Msisf.Core.Render.Options;

/// <summary>Light that the ground throws on ground.</summary>
/// <param name="Bounces">How often light may be reflected before the last time, towards the camera: 1 to <see cref="MaxBounces"/>.</param>
/// <param name="Error">
/// Root mean square of the error of the brightness that it gives, over that of this brightness, in the whole image, as against a drawing
/// of 16 times the work.
/// </param>
public sealed record IndirectLight(int Bounces, double Error)
{
    /// <summary>Most bounces: the ninth adds less than 1e-8 of the light to the deepest of bowls of an albedo of 0.5.</summary>
    public const int MaxBounces = 8;

    /// <summary>Error if none is given.</summary>
    public const double DefaultError = 0.01;

    /// <summary>Least error.</summary>
    public const double MinError = 0.001;

    /// <summary>Greatest error.</summary>
    public const double MaxError = 0.2;
}
