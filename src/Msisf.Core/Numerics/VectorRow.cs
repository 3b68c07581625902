namespace Msisf.Core.Numerics;

/// <summary>
/// Vectors with one array for each component. Each array has room for seven numbers after the last vector, so that eight can be read and
/// written from any vector on.
/// </summary>
/// <param name="X">First components.</param>
/// <param name="Y">Second components.</param>
/// <param name="Z">Third components.</param>
internal sealed record VectorRow(double[] X, double[] Y, double[] Z)
{
    /// <summary>Makes room for vectors.</summary>
    /// <param name="length">Length of the arrays.</param>
    public static VectorRow OfLength(int length) => new(new double[length], new double[length], new double[length]);

    /// <summary>One vector.</summary>
    public Vector3D this[int index] => new(X[index], Y[index], Z[index]);
}
