using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;
using Msisf.Core.Camera.Lenses;
using Msisf.Core.Parallel;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Where the ideal image plane is sampled by several samples in each pixel of a camera with a lens. What is kept of a sample is how far it
/// lies from where the distances of the neighbouring pixels' centres put it. That is so little that single precision is enough, to far
/// below 1e-8 px. Immutable.
/// </summary>
internal sealed class LensSubsamples
{
    private readonly CameraModel _model;
    private readonly LensSamples _centres;
    private readonly SamplePattern _pattern;
    private readonly float[] _right;
    private readonly float[] _down;

    /// <param name="model">The camera, with a lens.</param>
    /// <param name="centres">Its samples at the pixels' centres.</param>
    /// <param name="pattern">Where the samples of a pixel lie.</param>
    /// <param name="threads">Maximum number of threads; the samples do not depend on it.</param>
    public LensSubsamples(CameraModel model, LensSamples centres, SamplePattern pattern, int threads, CancellationToken cancellation)
    {
        (_model, _centres, _pattern) = (model, centres, pattern);
        _right = new float[(model.Width * model.Height * pattern.Count) + SamplePattern.Lanes]; // whole vectors are read from any sample
        _down = new float[_right.Length];
        WorkerTeam.Run(threads, model.Height, (_, row) => FillRow(row), cancellation);
    }

    /// <summary>Memory that the samples of a camera take, in bytes.</summary>
    public static long BytesOf(CameraModel model, SamplePattern pattern) =>
        2L * sizeof(float) * model.Width * model.Height * pattern.Count;

    /// <summary>Whether these are the samples of a camera with a pattern.</summary>
    public bool IsOf(CameraModel model, SamplePattern pattern) => _centres.IsOf(model) && _pattern.Equals(pattern);

    /// <summary>Reads the samples of a pixel.</summary>
    /// <param name="right">Receives their tangents to the right, whole vectors of <see cref="SamplePattern.Lanes"/>.</param>
    /// <param name="down">Receives their tangents down.</param>
    /// <param name="start">Index of the first one in these.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be drawn with unoptimised vectors
    public void Read(int column, int row, double[] right, double[] down, int start)
    {
        int place = ((row * _model.Width) + column) * _pattern.Count;
        Slopes ofRight = Slopes.Of(_centres.Right, _model, column, row);
        Slopes ofDown = Slopes.Of(_centres.Down, _model, column, row);
        for (int sample = 0; sample < _pattern.Count; sample += Vector256<float>.Count)
        {
            for (int half = 0; half < Vector256<float>.Count; half += Vector256<double>.Count)
            {
                int four = sample + half;
                Vector256<double> x = ArrayLanes.Load256(_pattern.Right, four);
                Vector256<double> y = ArrayLanes.Load256(_pattern.Down, four);
                (ofRight.At(x, y) + Four(_right, place + four)).StoreTo(right, start + four);
                (ofDown.At(x, y) + Four(_down, place + four)).StoreTo(down, start + four);
            }
        }
    }

    private static Vector256<double> Four(float[] values, int first)
    {
        (Vector128<double> lower, Vector128<double> upper) = Vector128.Widen(ArrayLanes.Load128<float>(values, first));
        return Vector256.Create(lower, upper);
    }

    private void FillRow(int row)
    {
        for (int column = 0; column < _model.Width; column += Vector512<double>.Count)
        {
            for (int sample = 0; sample < _pattern.Count; sample++)
            {
                (double x, double y) = (_pattern.Right[sample], _pattern.Down[sample]);
                LanePoints ideal = LensSamples.EightPixels(_model, column, row, x, y);
                for (int lane = 0; lane < Vector512<double>.Count && column + lane < _model.Width; lane++)
                {
                    int place = (((row * _model.Width) + column + lane) * _pattern.Count) + sample;
                    _right[place] = (float)(ideal.X[lane] - Slopes.Of(_centres.Right, _model, column + lane, row).At(x, y));
                    _down[place] = (float)(ideal.Y[lane] - Slopes.Of(_centres.Down, _model, column + lane, row).At(x, y));
                }
            }
        }
    }

    /// <summary>A tangent as a linear function around a pixel's centre.</summary>
    private readonly record struct Slopes(double Centre, double PerColumn, double PerRow)
    {
        /// <summary>From the neighbouring pixels; at a border from the pixel itself and the one inside.</summary>
        public static Slopes Of(double[] centres, CameraModel model, int column, int row)
        {
            (int left, int right) = (Math.Max(column - 1, 0), Math.Min(column + 1, model.Width - 1));
            (int above, int below) = (Math.Max(row - 1, 0), Math.Min(row + 1, model.Height - 1));
            int start = row * model.Width;
            return new Slopes(
                centres[start + column],
                (centres[start + right] - centres[start + left]) / Math.Max(right - left, 1),
                (centres[(below * model.Width) + column] - centres[(above * model.Width) + column]) / Math.Max(below - above, 1));
        }

        public double At(double x, double y) => Centre + (PerColumn * x) + (PerRow * y);

        public Vector256<double> At(Vector256<double> x, Vector256<double> y) => Vector256.Create(Centre) + (PerColumn * x) + (PerRow * y);
    }
}
