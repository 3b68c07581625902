namespace Msisf.Adapters.CameraExport;

/// <summary>
/// The poses of a scanning camera at equal intervals, between which USGSCSM interpolates: as few as keep its error small, at least as many
/// as it wants, and some before and after the image, which are extrapolated.
/// </summary>
/// <param name="First">When the first one is, in exposures.</param>
/// <param name="Spacing">From one to the next, in exposures.</param>
/// <param name="Poses">The poses: position (m), and what turns the sensor into the body, each the nearer of its two signs.</param>
/// <param name="Error">px: the largest that interpolation leaves at any exposure.</param>
internal sealed record ScanNodes(double First, double Spacing, IReadOnlyList<(Vector3D Position, UnitQuaternion Turn)> Poses, double Error)
{
    /// <summary>px: as large an error may be.</summary>
    public const double Tolerance = 1e-5;

    /// <summary>USGSCSM's polynomials are through as many nodes, and through fewer near the ends.</summary>
    private const int Order = 8;

    /// <summary>Nodes that are needed before the first exposure, and after the last one, for polynomials of full order.</summary>
    private const int Beyond = 3;

    /// <summary>USGSCSM replaces image support data with fewer nodes than this.</summary>
    private const int Fewest = 25;

    private const int Components = 7;

    /// <summary>Chooses nodes.</summary>
    /// <param name="poses">The pose at each exposure.</param>
    /// <param name="errorOf">px: how far the image moves if the camera has another pose at an exposure.</param>
    public static ScanNodes Of(
        IReadOnlyList<(Vector3D Position, UnitQuaternion Turn)> poses,
        Func<int, (Vector3D Position, UnitQuaternion Turn), double> errorOf)
    {
        double[][] known =
        [
            .. poses.Zip(Continuous(poses.Select(pose => pose.Turn)), (pose, turn) => (double[])
                [pose.Position.X, pose.Position.Y, pose.Position.Z, turn.X, turn.Y, turn.Z, turn.W]),
        ];
        double spacing = 1.0;
        while ((known.Length - 1) / (2.0 * spacing) >= Order - 1)
        {
            spacing *= 2.0;
        }

        for (; ; spacing /= 2.0)
        {
            Table table = Table.Of(known, spacing);
            double error = 0.0;
            for (int i = 0; spacing > 1.0 && i < known.Length && error <= Tolerance; i++)
            {
                error = Math.Max(error, errorOf(i, PoseOf(table.At(i))));
            }

            if (error <= Tolerance && table.Nodes.Length >= Fewest)
            {
                return new ScanNodes(table.First, spacing, [.. table.Nodes.Select(PoseOf)], error);
            }
        }
    }

    /// <summary>Neighbours with the signs that bring them near each other: USGSCSM interpolates components.</summary>
    public static UnitQuaternion[] Continuous(IEnumerable<UnitQuaternion> rotations)
    {
        UnitQuaternion[] turns = [.. rotations];
        for (int i = 1; i < turns.Length; i++)
        {
            (UnitQuaternion a, UnitQuaternion b) = (turns[i - 1], turns[i]);
            if ((a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W) < 0.0)
            {
                turns[i] = UnitQuaternion.FromComponents(-b.X, -b.Y, -b.Z, -b.W);
            }
        }

        return turns;
    }

    private static (Vector3D Position, UnitQuaternion Turn) PoseOf(double[] row)
    {
        double length = double.Hypot(double.Hypot(row[3], row[4]), double.Hypot(row[5], row[6]));
        return (
            new Vector3D(row[0], row[1], row[2]),
            UnitQuaternion.FromComponents(row[3] / length, row[4] / length, row[5] / length, row[6] / length));
    }

    /// <summary>The value of the polynomial through some rows that are one apart.</summary>
    private static double[] Polynomial(ReadOnlySpan<double[]> rows, double at)
    {
        Span<double> times = stackalloc double[rows.Length];
        Span<double> weights = stackalloc double[rows.Length];
        for (int i = 0; i < rows.Length; i++)
        {
            times[i] = i;
        }

        SampleWeights.Lagrange(times, at, weights, stackalloc double[rows.Length]);
        double[] sum = new double[Components];
        for (int i = 0; i < rows.Length; i++)
        {
            for (int component = 0; component < Components; component++)
            {
                sum[component] += weights[i] * rows[i][component];
            }
        }

        return sum;
    }

    /// <summary>Nodes at a spacing.</summary>
    private readonly record struct Table(double First, double Spacing, double[][] Nodes)
    {
        public static Table Of(double[][] known, double spacing)
        {
            int stride = (int)Math.Max(1.0, spacing);
            double[][] inside = [.. known.Where((_, index) => index % stride == 0)];
            int last = (int)Math.Ceiling((known.Length - 1) / spacing);
            int beyond = known.Length > 1 ? Beyond : Fewest / 2; // one exposure alone: the same pose again and again
            return new Table(
                -beyond * spacing,
                spacing,
                [.. Enumerable.Range(-beyond, last + 1 + (2 * beyond)).Select(node => Through(inside, node * spacing / stride))]);
        }

        /// <summary>What USGSCSM interpolates at an exposure.</summary>
        public double[] At(int exposure)
        {
            double at = (exposure - First) / Spacing;
            int before = (int)at;
            return at == before ? Nodes[before] : Polynomial(Nodes.AsSpan(before - Beyond, Order), at - before + Beyond);
        }

        private static double[] Through(double[][] inside, double at)
        {
            if (at >= 0.0 && at <= inside.Length - 1 && at == Math.Floor(at))
            {
                return inside[(int)at];
            }

            int count = Math.Min(Order, inside.Length);
            int first = Math.Clamp((int)Math.Floor(at) - Beyond, 0, inside.Length - count);
            return Polynomial(inside.AsSpan(first, count), at - first);
        }
    }
}
