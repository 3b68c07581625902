using MathNet.Numerics.LinearAlgebra;
using Msisf.Core.Camera;

namespace Msisf.Adapters.CameraExport;

/// <summary>
/// The nearest of USGSCSM's lenses for one that it has not, by least squares over the image: RADTAN or TRANSVERSE, of one row KAGUYALISM.
/// </summary>
internal static class CsmLensFit
{
    /// <summary>px: a lens that is farther off somewhere in the image is none.</summary>
    public const double Limit = 0.05;

    /// <summary>Points along each side of the image; errors are largest in its corners.</summary>
    private const int Nodes = 41;

    private static readonly int[] Powers = [0, 1, 1, 2, 2, 2, 3, 3, 3, 3];

    /// <summary>The nearest lens, however far off it is.</summary>
    public static CsmLens Of(CameraModel camera)
    {
        Sample[] samples = [.. Samples(camera)];
        double down = camera.FocalY / camera.FocalX;
        CsmLens tangential = Tangential(samples, camera.FocalX, down);

        // One row says nothing of the second coordinate, but lies along the one that KAGUYALISM knows.
        CsmLens other = camera.Height == 1 ? AlongRow(camera, samples, down) : Transverse(samples, down);
        return other.Misfit < tangential.Misfit ? other : tangential;
    }

    private static CsmLens AlongRow(CameraModel camera, Sample[] samples, double down)
    {
        double scale = samples.Max(one => Math.Abs(one.X));
        double[][] terms = [.. samples.Select(one => new[] { 1.0, one.X / scale, Math.Pow(one.X / scale, 2), Math.Pow(one.X / scale, 3) })];
        double[] x = Solve(terms, [.. samples.Select(one => one.IdealX - one.X)]);
        double[] y = Solve(terms, [.. samples.Select(one => one.IdealY - one.Y)]);
        return CsmLens.AlongRow(
            camera, [.. x.Select((number, power) => number / Math.Pow(scale, power))],
            [.. y.Select((number, power) => number / Math.Pow(scale, power))]) with
        {
            Misfit = samples.Zip(terms, (one, term) => double.Hypot(
                one.X + Dot(x, term) - one.IdealX, down * (one.Y + Dot(y, term) - one.IdealY))).Max(),
        };
    }

    private static IEnumerable<Sample> Samples(CameraModel camera)
    {
        int rows = camera.Height == 1 ? 1 : Nodes;
        for (int i = 0; i < Nodes * rows; i++)
        {
            double h = 1.0 + ((camera.Width - 1.0) * (i % Nodes) / (Nodes - 1.0));
            double v = 1.0 + ((camera.Height - 1.0) * (i / Nodes) / (Nodes - 1.0));
            (double right, double down) = camera.ToIdeal(h, v);
            double y = (v - camera.PrincipalY) * camera.FocalX / camera.FocalY;
            double x = h - camera.PrincipalX - (camera.Skew * y / camera.FocalX);
            yield return new Sample(right * camera.FocalX, down * camera.FocalX, x, y);
        }
    }

    /// <summary>k1, k2, p1, p2, k3 of coordinates in units of the focal length, to which the measured point is linear.</summary>
    /// <param name="down">Pixels along a column in the length of one along a row.</param>
    private static CsmLens Tangential(Sample[] samples, double f, double down)
    {
        (double[] X, double[] Y) Terms(Sample one)
        {
            (double x, double y) = (one.IdealX / f, one.IdealY / f);
            double q = (x * x) + (y * y);
            return (
                [f * x * q, f * x * q * q, f * 2.0 * x * y, f * (q + (2.0 * x * x)), f * x * q * q * q],
                [f * y * q, f * y * q * q, f * (q + (2.0 * y * y)), f * 2.0 * x * y, f * y * q * q * q]);
        }

        double[] k = Solve(
            [.. samples.Select(one => Terms(one).X), .. samples.Select(one => Terms(one).Y)],
            [.. samples.Select(one => one.X - one.IdealX), .. samples.Select(one => one.Y - one.IdealY)]);
        return new CsmLens(7, "radtan", k)
        {
            Misfit = samples.Max(one => double.Hypot(
                one.IdealX + Dot(k, Terms(one).X) - one.X, down * (one.IdealY + Dot(k, Terms(one).Y) - one.Y))),
        };
    }

    private static CsmLens Transverse(Sample[] samples, double down)
    {
        double scale = samples.Max(one => Math.Max(Math.Abs(one.IdealX), Math.Abs(one.IdealY)));
        double[][] terms = [.. samples.Select(one => Cubic(one.IdealX / scale, one.IdealY / scale))];
        double[] x = Solve(terms, [.. samples.Select(one => one.X)]);
        double[] y = Solve(terms, [.. samples.Select(one => one.Y)]);
        return new CsmLens(
            1, "transverse", [.. x.Concat(y).Select((coefficient, i) => coefficient / Math.Pow(scale, Powers[i % Powers.Length]))])
        {
            Misfit = samples.Zip(terms, (one, term) => double.Hypot(Dot(x, term) - one.X, down * (Dot(y, term) - one.Y))).Max(),
        };
    }

    private static double[] Cubic(double x, double y) => [1.0, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y];

    private static double[] Solve(double[][] terms, double[] values) =>
        Matrix<double>.Build.DenseOfRowArrays(terms).QR().Solve(Vector<double>.Build.Dense(values)).AsArray();

    private static double Dot(double[] coefficients, double[] terms) => coefficients.Zip(terms, (one, term) => one * term).Sum();

    /// <summary>A point of the focal plane, px along a row from the principal point: ideal, and measured.</summary>
    private readonly record struct Sample(double IdealX, double IdealY, double X, double Y);
}
