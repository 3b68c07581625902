namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Converts radiance factors to grey levels. The conversion does not depend on the content of an image, so it is the same for all images.
/// </summary>
public sealed class GreyScale
{
    // IEC 61966-2-1: the sRGB curve is linear up to this value of linear grey and a power above it.
    private const double SrgbToe = 0.0031308;
    private const double SrgbToeSlope = 12.92;
    private const double SrgbOffset = 0.055;
    private const double SrgbExponent = 2.4;

    /// <summary>Makes the scale.</summary>
    /// <param name="exposure">Linear grey of the radiance factor 1, above 0. With 1, I/F = 1 is white; with 2, I/F = 0.5 is white.</param>
    /// <param name="transfer">How linear grey is encoded in the image's levels.</param>
    /// <exception cref="Errors.BadInputException">The exposure is not above 0.</exception>
    public GreyScale(double exposure = 1.0, GreyTransfer transfer = GreyTransfer.Srgb)
    {
        Exposure = Guard.InRange(exposure, 1e-6, 1e6, "exposure");
        Transfer = transfer;
    }

    /// <summary>Linear grey of the radiance factor 1.</summary>
    public double Exposure { get; }

    /// <summary>How linear grey is encoded in the image's levels.</summary>
    public GreyTransfer Transfer { get; }

    /// <summary>
    /// The level of one radiance factor by the plain formula, rounded to the nearest level, as POV-Ray does. Values beyond the ends become
    /// black or white.
    /// </summary>
    /// <param name="radianceFactor">I/F.</param>
    /// <param name="maxLevel">Level of white: 255 or 65535.</param>
    public int Level(double radianceFactor, int maxLevel) =>
        (int)Math.Floor((Encode(Math.Clamp(Exposure * radianceFactor, 0.0, 1.0)) * maxLevel) + 0.5);

    /// <summary>
    /// The minimum radiance factor that has a level; there the formula is half-way between that level and the level below.
    /// </summary>
    /// <param name="level">1 to <paramref name="maxLevel"/>.</param>
    /// <param name="maxLevel">Level of white: 255 or 65535.</param>
    internal double MinRadianceFactor(int level, int maxLevel) => Decode((level - 0.5) / maxLevel) / Exposure;

    private double Encode(double linear) => Transfer switch
    {
        GreyTransfer.Linear => linear,
        _ when linear <= SrgbToe => SrgbToeSlope * linear,
        _ => ((1.0 + SrgbOffset) * Math.Pow(linear, 1.0 / SrgbExponent)) - SrgbOffset,
    };

    private double Decode(double encoded) => Transfer switch
    {
        GreyTransfer.Linear => encoded,
        _ when encoded <= SrgbToeSlope * SrgbToe => encoded / SrgbToeSlope,
        _ => Math.Pow((encoded + SrgbOffset) / (1.0 + SrgbOffset), SrgbExponent),
    };
}

/// <summary>How linear grey is encoded in the levels of an image.</summary>
public enum GreyTransfer
{
    /// <summary>The sRGB curve (IEC 61966-2-1), for display; the PNG files of POV-Ray use it too.</summary>
    Srgb = 0,

    /// <summary>Levels proportional to radiance, for measurement.</summary>
    Linear = 1,
}
