using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Terrain;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Hapke's parameters by place, on a grid of latitudes and longitudes round the Moon. Between the grid's points they are linear; beyond its
/// first and last row those of the nearest row count. Immutable.
/// </summary>
public sealed class HapkeMap
{
    /// <summary>Parameters of a place: w, b, c, B0, h and the tangent of the mean slope.</summary>
    public const int Planes = 6;

    private readonly double[][] _planes;
    private readonly int _width;
    private readonly int _height;
    private readonly double _north;
    private readonly double _west;
    private readonly double _step;

    /// <summary>Takes the maps.</summary>
    /// <param name="planes"><see cref="Planes"/> maps, each <c>[line * width + sample]</c>, line 0 northernmost.</param>
    /// <param name="width">Samples round the Moon.</param>
    /// <param name="northDegrees">Latitude of the first line.</param>
    /// <param name="westDegrees">East longitude of the first sample.</param>
    public HapkeMap(double[][] planes, int width, double northDegrees, double westDegrees)
    {
        _planes = planes;
        _width = width;
        _height = planes[0].Length / width;
        _step = 360.0 / width;
        _north = northDegrees;
        _west = westDegrees;
    }

    /// <summary>Computes the radiance factors of pixels with the parameters of their places.</summary>
    /// <param name="points">The pixels with their angles; get the radiance factors.</param>
    /// <param name="reference">
    /// The geometry of a map of the reflectance; the radiance factors there go to <see cref="SunlitPoints.ReferenceFactors"/>. Null if
    /// there is no map.
    /// </param>
    internal void FindFactors(SunlitPoints points, ReferenceGeometry? reference) => FindFactors(points, reference, isForView: true);

    /// <summary>Computes the radiance factors that pixels have in the geometry of a map, and no others.</summary>
    internal void FindReferenceFactors(SunlitPoints points, ReferenceGeometry reference) =>
        FindFactors(points, reference, isForView: false);

    private void FindFactors(SunlitPoints points, ReferenceGeometry? reference, bool isForView)
    {
        Span<double> parameters = stackalloc double[Planes * Vector512<double>.Count];
        Span<Vector512<double>> buffer = stackalloc Vector512<double>[HapkeLanes.BufferLength];
        for (int i = 0; i < points.Count; i += Vector512<double>.Count)
        {
            for (int lane = 0; lane < Vector512<double>.Count; lane++)
            {
                int at = Math.Min(i + lane, points.Count - 1);
                Read(new Vector3D(points.X[at], points.Y[at], points.Z[at]), lane, parameters);
            }

            HapkeLanes lanes = new(
                Vector512<double>.One, Plane(parameters, 0), Plane(parameters, 1), Plane(parameters, 2), Plane(parameters, 3),
                Plane(parameters, 4), Plane(parameters, 5));
            if (isForView)
            {
                HapkeLanes.RadianceFactors(
                    lanes, Lanes(points.CosIncidence, i), Lanes(points.CosEmission, i), Lanes(points.PhaseHaversine, i),
                    Lanes(points.Factors, i), buffer);
            }

            if (reference is { } there)
            {
                HapkeLanes.RadianceFactors(
                    lanes, [Vector512.Create(there.CosIncidence)], [Vector512.Create(there.CosEmission)],
                    [Vector512.Create(there.PhaseHaversine)], Lanes(points.ReferenceFactors, i), buffer);
            }
        }
    }

    /// <summary>Linear between the four grid points round a place.</summary>
    private void Read(Vector3D pointBodyFixed, int lane, Span<double> parameters)
    {
        SelenographicPoint place = SelenographicPoint.Below(pointBodyFixed);
        double line = Math.Clamp((_north - double.RadiansToDegrees(place.Latitude)) / _step, 0.0, _height - 1.0);
        double sample = (double.RadiansToDegrees(place.Longitude) - _west) / _step;
        int upper = Math.Min((int)line, Math.Max(_height - 2, 0));
        int lower = Math.Min(upper + 1, _height - 1);
        double left = Math.Floor(sample);
        int west = Around((int)left);
        int east = Around((int)left + 1);
        double partX = sample - left;
        double partY = line - upper;
        for (int plane = 0; plane < Planes; plane++)
        {
            double[] values = _planes[plane];
            double north = values[(upper * _width) + west] + (partX * (values[(upper * _width) + east] - values[(upper * _width) + west]));
            double south = values[(lower * _width) + west] + (partX * (values[(lower * _width) + east] - values[(lower * _width) + west]));
            parameters[(plane * Vector512<double>.Count) + lane] = north + (partY * (south - north));
        }
    }

    private int Around(int sample)
    {
        int rest = sample % _width;
        return rest < 0 ? rest + _width : rest;
    }

    private static Vector512<double> Plane(Span<double> parameters, int plane) => Vector512.Create<double>(
        parameters.Slice(plane * Vector512<double>.Count, Vector512<double>.Count));

    private static Span<Vector512<double>> Lanes(double[] values, int index) =>
        MemoryMarshal.Cast<double, Vector512<double>>(values.AsSpan(index, Vector512<double>.Count));
}
