using MathNet.Numerics.LinearAlgebra;
using MathNet.Numerics.LinearAlgebra.Factorization;

namespace Msisf.Core.Sensitivity;

/// <summary>
/// What an image tells of some parameters: the Fisher information of independent pixels with normal noise, and its inverse, which no
/// unbiased estimator's covariance can undercut (Cramer and Rao; docs/sensitivities.md). Immutable.
/// </summary>
public sealed class FisherInformation
{
    /// <summary>
    /// Eigenvalue of the matrix with ones on its diagonal below which a direction counts as unknown: products of derivatives that are
    /// summed up over millions of pixels are right to ten digits.
    /// </summary>
    private const double LeastEigenvalue = 1e-10;

    private readonly double[] _scales;

    private FisherInformation(IReadOnlyList<Parameter> parameters, Matrix<double> matrix)
    {
        Parameters = parameters;
        Matrix = matrix.ToArray();
        _scales = [.. matrix.Diagonal().Select(value => value > 0.0 ? 1.0 / Math.Sqrt(value) : 0.0)];
        int count = parameters.Count;
        Matrix<double> scaled = Matrix<double>.Build.Dense(
            count, count, (i, j) => i == j && _scales[i] > 0.0 ? 1.0 : _scales[i] * matrix[i, j] * _scales[j]);
        Evd<double> eigen = scaled.Evd(Symmetricity.Symmetric);
        bool[] isKnown = [.. eigen.EigenValues.Select(value => value.Real > LeastEigenvalue)];
        Rank = isKnown.Count(known => known);
        Weakest = Normalized([.. eigen.EigenVectors.Column(0).Select((value, i) => value * (_scales[i] > 0.0 ? _scales[i] : 1.0))]);
        Covariance = new double?[count, count];
        for (int i = 0; i < count; i++)
        {
            for (int j = 0; j < count; j++)
            {
                Covariance[i, j] = IsBounded(i) && IsBounded(j) ? CovarianceOf(i, j) : null;
            }
        }

        bool IsBounded(int i) => Enumerable.Range(0, count)
            .All(k => isKnown[k] || Math.Abs(eigen.EigenVectors[i, k]) < Math.Sqrt(LeastEigenvalue));

        double CovarianceOf(int i, int j) => _scales[i] * _scales[j] * Enumerable.Range(0, count)
            .Where(k => isKnown[k])
            .Sum(k => eigen.EigenVectors[i, k] * eigen.EigenVectors[j, k] / eigen.EigenValues[k].Real);
    }

    /// <summary>The parameters, in the order of the rows and columns.</summary>
    public IReadOnlyList<Parameter> Parameters { get; }

    /// <summary>The information, one over the product of the parameters' units; symmetric.</summary>
    public double[,] Matrix { get; }

    /// <summary>Number of directions that the image tells; below that of the parameters the rest is unknown.</summary>
    public int Rank { get; }

    /// <summary>
    /// The bound of the covariance, in the product of the parameters' units; null where the image tells nothing of a parameter, or only
    /// together with another one.
    /// </summary>
    public double?[,] Covariance { get; }

    /// <summary>
    /// The direction in which the image tells least, counted in each parameter's own accuracy if the others were known: a part for each
    /// parameter, in its unit; the greatest is 1.
    /// </summary>
    public IReadOnlyList<double> Weakest { get; }

    /// <summary>The bound of a parameter's standard deviation, in its unit; null if there is none.</summary>
    public double? DeviationOf(Parameter parameter)
    {
        int index = Parameters.ToList().IndexOf(parameter);
        return index >= 0 && Covariance[index, index] is { } variance ? Math.Sqrt(variance) : null;
    }

    /// <summary>The axes of the bound's ellipsoid of three parameters, the longest first: standard deviations along unit vectors.</summary>
    /// <param name="kind">Position or turn.</param>
    /// <returns>Empty if the three are not all there, or not all bounded.</returns>
    public IReadOnlyList<(double Deviation, double X, double Y, double Z)> AxesOf(ParameterKind kind)
    {
        int[] rows = [.. Enumerable.Range(0, Parameters.Count).Where(i => Parameters[i].Kind == kind)];
        if (rows.Length != 3 || rows.Any(i => Covariance[i, i] is null))
        {
            return [];
        }

        Evd<double> eigen = Matrix<double>.Build.Dense(3, 3, (i, j) => Covariance[rows[i], rows[j]]!.Value).Evd(Symmetricity.Symmetric);
        return [.. Enumerable.Range(0, 3).Reverse().Select(k => (
            Math.Sqrt(Math.Max(0.0, eigen.EigenValues[k].Real)), eigen.EigenVectors[0, k], eigen.EigenVectors[1, k],
            eigen.EigenVectors[2, k]))];
    }

    /// <summary>Sums up the information of an image.</summary>
    /// <param name="parameters">At least one.</param>
    /// <param name="derivatives">Derivatives of the signal, a plane for each parameter.</param>
    /// <param name="variances">Variances of the signal; infinity for a pixel that tells nothing.</param>
    internal static FisherInformation Of(
        IReadOnlyList<Parameter> parameters, IReadOnlyList<double[]> derivatives, double[] variances)
    {
        int count = parameters.Count;
        Matrix<double> matrix = Matrix<double>.Build.Dense(count, count);
        for (int i = 0; i < count; i++)
        {
            for (int j = i; j < count; j++)
            {
                double sum = 0.0;
                for (int pixel = 0; pixel < variances.Length; pixel++)
                {
                    sum += derivatives[i][pixel] * derivatives[j][pixel] / variances[pixel];
                }

                matrix[i, j] = matrix[j, i] = sum;
            }
        }

        return new FisherInformation(parameters, matrix);
    }

    private static double[] Normalized(double[] vector)
    {
        double greatest = vector.MaxBy(Math.Abs);
        return [.. vector.Select(value => value / greatest)];
    }
}
