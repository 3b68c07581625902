namespace Msisf.Core.Surface;

/// <summary>By how much the ground's reflectance differs from place to place beyond laws and maps. Safe for several threads.</summary>
internal interface IGroundBrightness
{
    /// <summary>Multiplies reflectances by the factors of their places.</summary>
    /// <param name="x">m, body-fixed.</param>
    /// <param name="y">m.</param>
    /// <param name="z">m.</param>
    void Scale(ReadOnlySpan<double> x, ReadOnlySpan<double> y, ReadOnlySpan<double> z, Span<double> reflectances);
}
