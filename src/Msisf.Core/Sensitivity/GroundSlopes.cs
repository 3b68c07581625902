using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Render.Options;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Shading;
using Msisf.Core.Render.Visibility;

namespace Msisf.Core.Sensitivity;

/// <summary>
/// How the brightness of a point of the ground changes when the camera or the Sun moves: by the law's slopes in the three angles. For one
/// thread.
/// </summary>
/// <param name="samples">The samples, with ground truth.</param>
/// <param name="options">How they were drawn.</param>
internal sealed class GroundSlopes(IGroundTruth samples, NativeRenderOptions options)
{
    /// <summary>
    /// Step of a cosine or haversine: the slopes of laws are right to a millionth of their curvature, and differences keep nine digits.
    /// </summary>
    private const double Step = 1e-6;


    private readonly SunlitPoints _points = new();
    private readonly Vector3D _sun = samples.Light.PositionBodyFixed;
    private readonly Vector3D _camera = samples.Camera.BandAt(1.0).Camera.PositionBodyFixed;
    private readonly bool _isFlat = options is { Reflectance.DependsOnViewer: false, Hapke: null };
    private readonly double[] _cosIncidence = new double[samples.Camera.Width + SunlitPoints.Padding];
    private readonly double[] _light = new double[samples.Camera.Width + SunlitPoints.Padding];
    private readonly double[] _law = new double[samples.Camera.Width + SunlitPoints.Padding];
    private readonly double[] _byIncidence = new double[samples.Camera.Width + SunlitPoints.Padding];
    private readonly double[] _byEmission = new double[samples.Camera.Width + SunlitPoints.Padding];
    private readonly VectorRow _bySun = VectorRow.OfLength(samples.Camera.Width + SunlitPoints.Padding);
    private readonly VectorRow _byCamera = VectorRow.OfLength(samples.Camera.Width + SunlitPoints.Padding);

    /// <summary>Finds the slopes of a line of samples.</summary>
    public void Find(SampleLine line)
    {
        SurfaceRow row = line.Truth.Points;
        ReadOnlySpan<double> light = line.Light;
        for (int i = 0; i < row.Count; i++)
        {
            _light[i] = light[row.Columns[i]];
        }

        _points.Clear(light.Length);
        _points.Share(row, _cosIncidence);
        FindIncidence();
        FindSlopes();
        FindGradients();
    }

    /// <summary>Adds the brightness of a line of samples, and its slopes, to their pixels.</summary>
    /// <param name="line">The line whose slopes were found last.</param>
    /// <param name="weight">Weight of the line in the pixels.</param>
    public void Add(SampleLine line, Span<PixelSums> sums, double weight)
    {
        const int PerAxis = SensitivityFinder.SamplesPerAxis;
        ReadOnlySpan<double> light = line.Light;
        for (int column = 0; column < sums.Length; column++)
        {
            ref PixelSums pixel = ref sums[column];
            int first = column * PerAxis;
            for (int sample = first; sample <= first + PerAxis; sample++)
            {
                if (light[sample] == 0.0)
                {
                    continue;
                }

                // A sample on the border of two pixels counts half in each.
                double part = sample == first || sample == first + PerAxis ? 0.5 * weight : weight;
                int i = line.IndexOf(sample);
                pixel.Light += part * light[sample];
                pixel.BySun += part * _bySun[i];
                if (!_isFlat)
                {
                    pixel.ByCamera += part * _byCamera[i];
                }
            }
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void FindIncidence()
    {
        for (int i = 0; i < _points.Count; i += Vector512<double>.Count)
        {
            LaneVector toSun = LaneVector.All(_sun) - new LaneVector(
                ArrayLanes.Load(_points.X, i), ArrayLanes.Load(_points.Y, i), ArrayLanes.Load(_points.Z, i));
            LaneVector normal = new(
                ArrayLanes.Load(_points.NormalX, i), ArrayLanes.Load(_points.NormalY, i), ArrayLanes.Load(_points.NormalZ, i));
            Vector512<double> cosine = LaneVector.Dot(normal, toSun) * LaneMath.InverseSqrt(LaneVector.Dot(toSun, toSun));
            Vector512.MinNative(cosine, Vector512<double>.One).StoreTo(_cosIncidence, i);
        }
    }

    /// <summary>
    /// Finds the law's values and slopes; the slope by the haversine goes to the points' factors.
    /// </summary>
    private void FindSlopes()
    {
        int count = _points.Count;
        if (!_isFlat)
        {
            _points.FindAngles(_sun, _camera);
        }

        RowReflection.FindLawFactors(_points, options);
        _points.Factors.AsSpan(0, count).CopyTo(_law);
        if (!_isFlat)
        {
            Slope(_points.CosEmission, _byEmission);
        }

        Slope(_cosIncidence, _byIncidence);
        if (!_isFlat)
        {
            Slope(_points.PhaseHaversine, _points.Factors);
        }
    }

    /// <summary>Finds the law's slopes by one of its angles, with a step towards the middle of its range.</summary>
    private void Slope(double[] angles, double[] slopes)
    {
        int count = _points.Count;
        for (int i = 0; i < count; i++)
        {
            angles[i] += angles[i] < 0.5 ? Step : -Step;
        }

        RowReflection.FindLawFactors(_points, options);
        for (int i = 0; i < count; i++)
        {
            double step = angles[i] < 0.5 + (0.5 * Step) ? Step : -Step;
            slopes[i] = (_points.Factors[i] - _law[i]) / step;
            angles[i] -= step;
        }
    }

    /// <summary>Finds the gradients: of I/F by the direction to the Sun, times the parallax, and by the camera's position.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void FindGradients()
    {
        Vector512<double> ofCentre = Vector512.Create(_sun.Length);
        Vector512<double> half = Vector512.Create(0.5);
        for (int i = 0; i < _points.Count; i += Vector512<double>.Count)
        {
            LaneVector point = new(ArrayLanes.Load(_points.X, i), ArrayLanes.Load(_points.Y, i), ArrayLanes.Load(_points.Z, i));
            LaneVector normal = new(
                ArrayLanes.Load(_points.NormalX, i), ArrayLanes.Load(_points.NormalY, i), ArrayLanes.Load(_points.NormalZ, i));
            LaneVector toSun = LaneVector.All(_sun) - point;
            Vector512<double> perDistance = LaneMath.InverseSqrt(LaneVector.Dot(toSun, toSun));
            toSun = perDistance * toSun;
            Vector512<double> law = ArrayLanes.Load(_law, i);
            Vector512<double> isLit = Vector512.GreaterThan(law, Vector512<double>.Zero);
            Vector512<double> scale = isLit & (ArrayLanes.Load(_light, i) / law);
            Vector512<double> byIncidence = scale * ArrayLanes.Load(_byIncidence, i);
            LaneVector bySun = byIncidence * (normal - (ArrayLanes.Load(_cosIncidence, i) * toSun));
            if (!_isFlat)
            {
                LaneVector toCamera = LaneVector.All(_camera) - point;
                Vector512<double> perRange = LaneMath.InverseSqrt(LaneVector.Dot(toCamera, toCamera));
                toCamera = perRange * toCamera;
                Vector512<double> cosine = LaneVector.Dot(toCamera, toSun);
                Vector512<double> byEmission = scale * ArrayLanes.Load(_byEmission, i);
                Vector512<double> byPhase = -(half * scale * ArrayLanes.Load(_points.Factors, i)); // a haversine is (1 - cosine) / 2
                LaneVector byCamera = (byEmission * (normal - (ArrayLanes.Load(_points.CosEmission, i) * toCamera)))
                    + (byPhase * (toSun - (cosine * toCamera)));
                (perRange * byCamera).Store(_byCamera, i);
                bySun += byPhase * (toCamera - (cosine * toSun));
            }

            (ofCentre * perDistance * bySun).Store(_bySun, i);
        }
    }
}
