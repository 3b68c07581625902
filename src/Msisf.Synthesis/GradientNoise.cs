using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Synthesis;

/// <summary>
/// Gradient noise on a cubic lattice in space, eight points at a time; smooth (C2), of zero mean, with wavelengths of about one to two
/// lattice steps.
/// </summary>
/// <remarks>
/// K. Perlin, "Improving noise", SIGGRAPH 2002; the gradients come from a hash instead of a table, each component uniform in [-1, 1].
/// </remarks>
internal static class GradientNoise
{
    /// <summary>Per lattice step: root mean square of one component of the noise's gradient (measured, GradientNoiseTests).</summary>
    public const double RmsSlope = 0.5;

    private const int PrimeX = 0x1B873593;
    private const int PrimeY = unchecked((int)0xCC9E2D51);
    private const int PrimeZ = 0x165667B1;
    private const float GradientCentre = 511.5f;
    private const float GradientScale = 1.0f / 511.5f;

    /// <summary>The noise at eight points.</summary>
    /// <param name="x0">First coordinate of points 0 to 3, in lattice steps, |x| below 2^31.</param>
    /// <param name="x1">The same of points 4 to 7.</param>
    /// <param name="y0">Second coordinate of points 0 to 3.</param>
    /// <param name="y1">The same of points 4 to 7.</param>
    /// <param name="z0">Third coordinate of points 0 to 3.</param>
    /// <param name="z1">The same of points 4 to 7.</param>
    /// <param name="seed">Another seed gives another noise.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> At(
        Vector256<double> x0,
        Vector256<double> x1,
        Vector256<double> y0,
        Vector256<double> y1,
        Vector256<double> z0,
        Vector256<double> z1,
        int seed)
    {
        (Vector256<int> cellX, Vector256<float> fx) = Split(x0, x1);
        (Vector256<int> cellY, Vector256<float> fy) = Split(y0, y1);
        (Vector256<int> cellZ, Vector256<float> fz) = Split(z0, z1);
        Vector256<int> hashX0 = (cellX * PrimeX) ^ Vector256.Create(seed);
        Vector256<int> hashX1 = ((cellX + Vector256<int>.One) * PrimeX) ^ Vector256.Create(seed);
        Vector256<int> hashY0 = cellY * PrimeY;
        Vector256<int> hashY1 = hashY0 + Vector256.Create(PrimeY);
        Vector256<int> hashZ0 = cellZ * PrimeZ;
        Vector256<int> hashZ1 = hashZ0 + Vector256.Create(PrimeZ);
        Vector256<float> gx = fx - Vector256<float>.One;
        Vector256<float> gy = fy - Vector256<float>.One;
        Vector256<float> gz = fz - Vector256<float>.One;
        Vector256<float> wx = Fade(fx);
        Vector256<float> wy = Fade(fy);
        Vector256<float> lowZ = Mix(
            Mix(Corner(hashX0 ^ hashY0 ^ hashZ0, fx, fy, fz), Corner(hashX1 ^ hashY0 ^ hashZ0, gx, fy, fz), wx),
            Mix(Corner(hashX0 ^ hashY1 ^ hashZ0, fx, gy, fz), Corner(hashX1 ^ hashY1 ^ hashZ0, gx, gy, fz), wx),
            wy);
        Vector256<float> highZ = Mix(
            Mix(Corner(hashX0 ^ hashY0 ^ hashZ1, fx, fy, gz), Corner(hashX1 ^ hashY0 ^ hashZ1, gx, fy, gz), wx),
            Mix(Corner(hashX0 ^ hashY1 ^ hashZ1, fx, gy, gz), Corner(hashX1 ^ hashY1 ^ hashZ1, gx, gy, gz), wx),
            wy);
        return Mix(lowZ, highZ, Fade(fz)) * GradientScale;
    }

    // Doubles are used until the lattice cell is subtracted: a float resolves only 1/128 of a step at the finest lattices.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static (Vector256<int> Cell, Vector256<float> Fraction) Split(Vector256<double> low, Vector256<double> high)
    {
        Vector256<double> floorLow = Vector256.Floor(low);
        Vector256<double> floorHigh = Vector256.Floor(high);

        // In the sum with 1.5 2^52 the last bits are those of the whole number.
        Vector256<double> units = Vector256.Create(6755399441055744.0);
        return (
            Vector256.Narrow((floorLow + units).AsInt64(), (floorHigh + units).AsInt64()),
            Vector256.Narrow(low - floorLow, high - floorHigh));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Corner(Vector256<int> hash, Vector256<float> dx, Vector256<float> dy, Vector256<float> dz)
    {
        hash *= 0x27D4EB2D;
        hash ^= Vector256.ShiftRightLogical(hash, 15);
        hash *= unchecked((int)0x85EBCA6B);
        return (dx * Component(Vector256.ShiftRightLogical(hash, 22)))
            + (dy * Component(Vector256.ShiftRightLogical(hash, 12) & Vector256.Create(1023)))
            + (dz * Component(Vector256.ShiftRightLogical(hash, 2) & Vector256.Create(1023)));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Component(Vector256<int> tenBits) =>
        Vector256.ConvertToSingle(tenBits) - Vector256.Create(GradientCentre);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Fade(Vector256<float> t) =>
        t * t * t * ((t * ((t * 6.0f) - Vector256.Create(15.0f))) + Vector256.Create(10.0f));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Mix(Vector256<float> a, Vector256<float> b, Vector256<float> weightOfB) =>
        a + (weightOfB * (b - a));
}
