namespace Msisf.Core.Numerics;

/// <summary>Points of the unit cube by their numbers, random ones or Kronecker's: the same seed gives the same points.</summary>
public sealed class UnitCubePoints
{
    private const ulong Purpose = 0x506F696E7473;

    private readonly int _dimensions;
    private readonly ulong _seed;
    private readonly long _stream;
    private readonly KroneckerSequence? _even;

    /// <summary>Chooses the points.</summary>
    /// <param name="dimensions">Number of coordinates, at most 16.</param>
    /// <param name="isEven">Whether they are Kronecker's, which fill the cube more evenly.</param>
    /// <param name="seed">The user's seed.</param>
    /// <param name="stream">Tells several sets of points of one seed apart.</param>
    public UnitCubePoints(int dimensions, bool isEven, ulong seed, long stream)
    {
        (_dimensions, _seed, _stream) = (dimensions, seed, stream);
        _even = isEven ? new KroneckerSequence(dimensions, seed, stream) : null;
    }

    /// <summary>The coordinates of a point, [0, 1).</summary>
    /// <param name="number">From 0.</param>
    public double[] PointAt(long number)
    {
        if (_even is not null)
        {
            return _even.PointAt(number);
        }

        SplitMix64 random = SplitMix64.For(_seed, Purpose, _stream, number);
        double[] point = new double[_dimensions];
        for (int dimension = 0; dimension < point.Length; dimension++)
        {
            point[dimension] = random.NextUniform();
        }

        return point;
    }
}
