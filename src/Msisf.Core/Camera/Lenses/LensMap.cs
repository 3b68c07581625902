using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Msisf.Core.Camera.Lenses;

/// <summary>
/// Both directions of a distortion over an image, in units of the focal length. The direction that has no formula is computed by Newton's
/// method, with as many steps everywhere, so that a point gets the same bits alone and among others: eight points in a vector, of which
/// MathNet has none. Immutable.
/// </summary>
internal sealed class LensMap
{
    /// <summary>Nodes along each side of the image, at which the ideal points are known.</summary>
    private const int Nodes = 65;

    /// <summary>Steps from the principal point to a point on the way of which the inverse is followed.</summary>
    private const int WaySteps = 12;

    private const int NewtonSteps = 4;

    /// <summary>Every so many cells between nodes are checked; the number is prime to the cells of a row, so all columns are met.</summary>
    private const int CellsPerCheck = 5;

    /// <summary>
    /// Parts of the image's distance from the principal point: limits the error of a point that was mapped forth and back.
    /// </summary>
    private const double RoundTrip = 1e-14;

    private readonly Distortion _formula;
    private readonly (double Left, double Top, double Right, double Bottom) _image;
    private readonly double[] _x = new double[Nodes * Nodes];
    private readonly double[] _y = new double[Nodes * Nodes];
    private readonly double _roundTrip;
    private int _steps;

    private LensMap(Distortion formula, (double Left, double Top, double Right, double Bottom) image)
    {
        _formula = formula;
        _image = image;
        double across = Math.Max(Math.Abs(image.Left), Math.Abs(image.Right));
        double down = Math.Max(Math.Abs(image.Top), Math.Abs(image.Bottom));
        _roundTrip = RoundTrip * Math.Max(across, down);
    }

    /// <summary>Minimum change of the ideal point when the measured point moves by 1, anywhere in the image and in any direction.</summary>
    public double MinScale { get; private set; } = double.PositiveInfinity;

    /// <summary>Maximum distance of an ideal point from the principal point: a tangent.</summary>
    public double MaxTangent { get; private set; }

    /// <summary>Prepares an image.</summary>
    /// <param name="image">The image's borders in the measured plane.</param>
    /// <param name="failed">A measured point whose ideal one cannot be found.</param>
    /// <returns>Null if there is such a point.</returns>
    public static LensMap? TryCreate(
        Distortion formula, (double Left, double Top, double Right, double Bottom) image, out (double X, double Y) failed)
    {
        LensMap map = new(formula, image);
        return map.FindNodes(out failed) && map.FindSteps(out failed) ? map : null;
    }

    public LanePoints ToIdeal(in LanePoints measured) => _formula.IsFromIdeal
        ? Solve(measured, StartOf(measured), _steps)
        : _formula.Apply(measured, out _);

    /// <summary>The measured point of an ideal one.</summary>
    /// <param name="ideal">The ideal point, eight times.</param>
    /// <param name="measured">The measured point, eight times.</param>
    /// <param name="slopes">Derivatives of the measured point with respect to the ideal one.</param>
    /// <returns>False if the lens does not show it: the distortion has no inverse on the way there from the principal point.</returns>
    public bool TryToMeasured(in LanePoints ideal, out LanePoints measured, out LaneSlopes slopes)
    {
        if (_formula.IsFromIdeal)
        {
            measured = _formula.Apply(ideal, out slopes);
            return IsRegularOnTheWayTo(ideal) && double.IsFinite(measured.X[0] + measured.Y[0]);
        }

        bool isFound = Follow(ideal, out measured) != 0;
        _ = _formula.Apply(measured, out LaneSlopes inverse);
        Vector512<double> determinant = inverse.Determinant;
        slopes = new LaneSlopes(
            inverse.Yy / determinant, -inverse.Xy / determinant, -inverse.Yx / determinant, inverse.Xx / determinant);
        return isFound;
    }

    private bool FindNodes(out (double X, double Y) failed)
    {
        Span<double> atX = stackalloc double[Vector512<double>.Count];
        Span<double> atY = stackalloc double[Vector512<double>.Count];
        for (int node = 0; node < Nodes * Nodes; node += Vector512<double>.Count)
        {
            for (int lane = 0; lane < atX.Length; lane++)
            {
                (atX[lane], atY[lane]) = MeasuredAt(Math.Min(node + lane, (Nodes * Nodes) - 1));
            }

            LanePoints measured = new(Vector512.Create<double>(atX), Vector512.Create<double>(atY));
            if (!TryFollow(measured, out LanePoints ideal, out LaneSlopes scale, out int bad))
            {
                failed = (atX[bad], atY[bad]);
                return false;
            }

            for (int lane = 0; lane < atX.Length && node + lane < Nodes * Nodes; lane++)
            {
                (_x[node + lane], _y[node + lane]) = (ideal.X[lane], ideal.Y[lane]);
                MinScale = Math.Min(MinScale, MinStretch(scale, lane));
                MaxTangent = Math.Max(MaxTangent, double.Hypot(ideal.X[lane], ideal.Y[lane]));
            }
        }

        failed = default;
        return true;
    }

    /// <summary>Finds ideal points with certainty on the branch of the principal point.</summary>
    private bool TryFollow(in LanePoints measured, out LanePoints ideal, out LaneSlopes scale, out int bad)
    {
        uint good;
        if (_formula.IsFromIdeal)
        {
            good = Follow(measured, out ideal);
            _ = _formula.Apply(ideal, out LaneSlopes inverse);
            Vector512<double> determinant = inverse.Determinant;
            scale = new LaneSlopes(
                inverse.Yy / determinant, -inverse.Xy / determinant, -inverse.Yx / determinant, inverse.Xx / determinant);
        }
        else
        {
            ideal = _formula.Apply(measured, out scale);
            good = (uint)Vector512.GreaterThan(scale.Determinant, Vector512<double>.Zero).ExtractMostSignificantBits()
                & (uint)IsFinite(ideal).ExtractMostSignificantBits();
            for (int step = 0; step < WaySteps; step++)
            {
                double part = (double)step / WaySteps;
                _ = _formula.Apply(new LanePoints(part * measured.X, part * measured.Y), out LaneSlopes on);
                good &= (uint)Vector512.GreaterThan(on.Determinant, Vector512<double>.Zero).ExtractMostSignificantBits();
            }
        }

        bad = BitOperations.TrailingZeroCount(~good);
        return good == 0xffu;
    }

    /// <summary>Finds how many steps of Newton's method are enough from any start, and checks that they reach the points.</summary>
    private bool FindSteps(out (double X, double Y) failed)
    {
        failed = default;
        if (!_formula.IsFromIdeal)
        {
            return true;
        }

        const int maxSteps = 8;
        for (int cell = 0; cell < (Nodes - 1) * (Nodes - 1); cell += CellsPerCheck)
        {
            double x = _image.Left + ((_image.Right - _image.Left) * ((cell % (Nodes - 1)) + 0.5) / (Nodes - 1));
            double y = _image.Top + ((_image.Bottom - _image.Top) * ((cell / (Nodes - 1)) + 0.5) / (Nodes - 1));
            LanePoints measured = LanePoints.All(x, y);
            LanePoints start = StartOf(measured);
            int steps = 1;
            while (steps <= maxSteps && !(Error(Solve(measured, start, steps), measured) <= _roundTrip))
            {
                steps++;
            }

            if (steps > maxSteps)
            {
                failed = (x, y);
                return false;
            }

            _steps = Math.Max(_steps, steps);
        }

        _steps++; // the start is a little worse beside the middle of a cell where the lens is irregular
        return true;
    }

    private double Error(in LanePoints ideal, in LanePoints measured)
    {
        LanePoints back = _formula.Apply(ideal, out _);
        return double.Hypot(back.X[0] - measured.X[0], back.Y[0] - measured.Y[0]);
    }

    /// <summary>Where Newton's method starts: between the four nodes around each point.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private LanePoints StartOf(in LanePoints measured)
    {
        Vector512<double> max = Vector512.Create(Nodes - 2.0);
        Vector512<double> column = (measured.X - Vector512.Create(_image.Left)) * ((Nodes - 1) / (_image.Right - _image.Left));
        Vector512<double> row = (measured.Y - Vector512.Create(_image.Top)) * ((Nodes - 1) / (_image.Bottom - _image.Top));
        Vector512<double> left = Vector512.Min(Vector512.Max(Vector512.Floor(column), Vector512<double>.Zero), max);
        Vector512<double> top = Vector512.Min(Vector512.Max(Vector512.Floor(row), Vector512<double>.Zero), max);
        Span<double> nodes = stackalloc double[8 * Vector512<double>.Count];
        for (int lane = 0; lane < Vector512<double>.Count; lane++)
        {
            int node = ((int)top[lane] * Nodes) + (int)left[lane];
            nodes[lane] = _x[node];
            nodes[8 + lane] = _x[node + 1];
            nodes[16 + lane] = _x[node + Nodes];
            nodes[24 + lane] = _x[node + Nodes + 1];
            nodes[32 + lane] = _y[node];
            nodes[40 + lane] = _y[node + 1];
            nodes[48 + lane] = _y[node + Nodes];
            nodes[56 + lane] = _y[node + Nodes + 1];
        }

        return new LanePoints(
            Between(nodes[..32], column - left, row - top), Between(nodes[32..], column - left, row - top));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector512<double> Between(ReadOnlySpan<double> nodes, Vector512<double> across, Vector512<double> down)
    {
        Vector512<double> upperLeft = Vector512.Create(nodes);
        Vector512<double> lowerLeft = Vector512.Create(nodes[16..]);
        Vector512<double> upper = upperLeft + (across * (Vector512.Create(nodes[8..]) - upperLeft));
        Vector512<double> lower = lowerLeft + (across * (Vector512.Create(nodes[24..]) - lowerLeft));
        return upper + (down * (lower - upper));
    }

    /// <summary>Follows the inverse of the formula from the principal point; the bits of the points that it found are set.</summary>
    private uint Follow(in LanePoints target, out LanePoints found)
    {
        found = default;
        LanePoints from = _formula.Apply(found, out _);
        Vector512<double> isRegular = Vector512<double>.AllBitsSet;
        for (int step = 1; step <= WaySteps; step++)
        {
            double part = (double)step / WaySteps;
            LanePoints on = new(from.X + (part * (target.X - from.X)), from.Y + (part * (target.Y - from.Y)));
            found = Solve(on, found, NewtonSteps);
            _ = _formula.Apply(found, out LaneSlopes slopes);
            isRegular &= Vector512.GreaterThan(slopes.Determinant, Vector512<double>.Zero);
        }

        found = Solve(target, found, NewtonSteps);
        LanePoints back = _formula.Apply(found, out _);
        Vector512<double> size = Vector512.Max(Vector512.Abs(target.X), Vector512.Abs(target.Y));
        Vector512<double> error = Vector512.Max(Vector512.Abs(back.X - target.X), Vector512.Abs(back.Y - target.Y));
        isRegular &= Vector512.LessThanOrEqual(error, (RoundTrip * size) + Vector512.Create(_roundTrip)) & IsFinite(found);
        return (uint)isRegular.ExtractMostSignificantBits();
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private LanePoints Solve(in LanePoints target, LanePoints at, int steps)
    {
        for (int step = 0; step < steps; step++)
        {
            LanePoints reached = _formula.Apply(at, out LaneSlopes slopes);
            Vector512<double> x = reached.X - target.X;
            Vector512<double> y = reached.Y - target.Y;
            Vector512<double> perDeterminant = Vector512<double>.One / slopes.Determinant;
            at = new LanePoints(
                at.X - (((slopes.Yy * x) - (slopes.Xy * y)) * perDeterminant),
                at.Y - (((slopes.Xx * y) - (slopes.Yx * x)) * perDeterminant));
        }

        return at;
    }

    private bool IsRegularOnTheWayTo(in LanePoints ideal)
    {
        for (int step = 1; step <= WaySteps; step++)
        {
            double part = (double)step / WaySteps;
            _ = _formula.Apply(new LanePoints(part * ideal.X, part * ideal.Y), out LaneSlopes slopes);
            if (!(slopes.Determinant[0] > 0.0))
            {
                return false;
            }
        }

        return true;
    }

    private (double X, double Y) MeasuredAt(int node) => (
        _image.Left + ((_image.Right - _image.Left) * (node % Nodes) / (Nodes - 1)),
        _image.Top + ((_image.Bottom - _image.Top) * (node / Nodes) / (Nodes - 1)));

    private static Vector512<double> IsFinite(in LanePoints points) =>
        Vector512.LessThan(Vector512.Abs(points.X) + Vector512.Abs(points.Y), Vector512.Create(double.PositiveInfinity));

    /// <summary>The smaller singular value of a 2 x 2 matrix.</summary>
    private static double MinStretch(in LaneSlopes slopes, int lane)
    {
        double mean = double.Hypot(slopes.Xx[lane] + slopes.Yy[lane], slopes.Xy[lane] - slopes.Yx[lane]);
        double difference = double.Hypot(slopes.Xx[lane] - slopes.Yy[lane], slopes.Xy[lane] + slopes.Yx[lane]);
        return 0.5 * Math.Abs(mean - difference);
    }
}
