namespace Msisf.Core.Illumination;

/// <summary>Where a body is at each step of an interval, as seen from the centre of the ground's body. Immutable.</summary>
internal sealed class LightTimes
{
    /// <summary>Steps that are computed at once.</summary>
    public const int Lanes = 16;

    /// <summary>Takes the body's places.</summary>
    /// <param name="positionsBodyFixed">m, body-fixed, at each step.</param>
    /// <param name="radius">Radius of the body, m; 0 for a point.</param>
    public LightTimes(IReadOnlyList<Vector3D> positionsBodyFixed, double radius)
    {
        Count = positionsBodyFixed.Count;
        int padded = (Count + Lanes - 1) / Lanes * Lanes;
        (X, Y, Z) = (new float[padded], new float[padded], new float[padded]);
        (PerMetre, Slope, Distances) = (new float[padded], new float[padded], new double[padded]);
        for (int step = 0; step < padded; step++)
        {
            Vector3D position = positionsBodyFixed[Math.Min(step, Count - 1)];
            double distance = position.Length;
            Vector3D direction = position / distance;
            (X[step], Y[step], Z[step]) = ((float)direction.X, (float)direction.Y, (float)direction.Z);
            (PerMetre[step], Distances[step]) = ((float)(1.0 / distance), distance);
            Slope[step] = (float)(radius / Math.Sqrt((distance - radius) * (distance + radius)));
        }

        MaxSlope = Slope.Max();
    }

    /// <summary>Number of steps; the arrays are padded with the last one.</summary>
    public int Count { get; }

    /// <summary>Directions, body-fixed, length 1.</summary>
    public float[] X { get; }

    /// <inheritdoc cref="X"/>
    public float[] Y { get; }

    /// <inheritdoc cref="X"/>
    public float[] Z { get; }

    /// <summary>1/m: one over the distance.</summary>
    public float[] PerMetre { get; }

    /// <summary>Tangent of the angular radius.</summary>
    public float[] Slope { get; }

    /// <summary>m.</summary>
    public double[] Distances { get; }

    /// <summary>The greatest of <see cref="Slope"/>.</summary>
    public float MaxSlope { get; }
}
