using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using Msisf.Core.Camera;

namespace Msisf.Core.Render.Photometry;

/// <summary>
/// Scales radiance factors by a map: I/F = A f(i, e, g) / f(i0, e0, g0), where A is the map's mean over the pixel and (i0, e0, g0) its
/// geometry. Where the map has no data, the law alone counts. Keeps buffers, so each thread needs its own object.
/// </summary>
internal sealed class AlbedoSampler
{
    private const int MaxPlaces = MapLevelLanes.MaxPlaces;

    private readonly MapFootprints _footprints = new();
    private readonly MapLevelLanes _lanes = new();
    private readonly double[] _codes = new double[MaxPlaces];
    private readonly double[] _farCodes = new double[MaxPlaces];
    private readonly double[] _x = new double[MaxPlaces];
    private readonly double[] _y = new double[MaxPlaces];
    private readonly double[] _parts = new double[MaxPlaces];

    /// <summary>Scales the radiance factors of a row.</summary>
    /// <param name="points">The pixels, with the law's radiance factors.</param>
    /// <param name="camera">The camera that sees them.</param>
    /// <param name="width">Width of the footprints, px.</param>
    /// <param name="factorOfReference">
    /// The law's radiance factor in the map's geometry, above 0; null if it differs from place to place
    /// (<see cref="SunlitPoints.ReferenceFactors"/>).
    /// </param>
    /// <param name="ofLaw">The law's radiance factors, which the map scales.</param>
    /// <param name="isSite">
    /// Whether only pixels count whose middles lie on the map; otherwise also those half a pixel of a level beside it.
    /// </param>
    public void Scale(
        SunlitPoints points, FrameCamera camera, double width, AlbedoMap map, double? factorOfReference, double[] ofLaw,
        bool isSite = false)
    {
        _footprints.Find(points, camera, width, map);
        double perReference = 1.0 / (factorOfReference ?? 1.0);
        double offset = map.Offset * perReference;
        double step = map.Step * perReference;
        Span<double> factors = points.Factors.AsSpan(0, points.Count);
        int first = 0;
        while (first < factors.Length)
        {
            int count = TakePlaces(first, factors.Length, out int places);
            ReadCodes(map, (int)_footprints.Levels[first], places);
            AverageCodes(first, count, places);
            for (int i = 0; i < count; i++)
            {
                if (_codes[i] > 0.0 && (!isSite || IsOn(map.Levels[0], first + i)))
                {
                    double scale = offset + (step * _codes[i]);
                    scale = factorOfReference is null ? scale / points.ReferenceFactors[first + i] : scale;
                    factors[first + i] = ofLaw[first + i] * scale;
                }
            }

            first += count;
        }
    }

    /// <summary>Whether the middle of a pixel lies on a map; longitudes are counted from its left edge, so none is below 0.</summary>
    private bool IsOn(AlbedoMapLevel finest, int pixel) =>
        _footprints.X[pixel] <= finest.Width && _footprints.Y[pixel] >= 0.0 && _footprints.Y[pixel] <= finest.Height;

    /// <summary>Takes the places on the map of pixels of one level, as many as there is room for.</summary>
    private int TakePlaces(int first, int end, out int places)
    {
        ReadOnlySpan<long> levels = _footprints.Levels.AsSpan(first, end - first);
        ReadOnlySpan<double> probeCounts = _footprints.Probes.AsSpan(first, end - first);
        places = 0;
        int pixel = 0;
        for (; pixel < levels.Length && levels[pixel] == levels[0]; pixel++)
        {
            int probes = (int)probeCounts[pixel];
            if (places + probes > MaxPlaces)
            {
                break;
            }

            int i = first + pixel;
            double part = _footprints.Parts[i];
            if (probes == 1)
            {
                (_x[places], _y[places], _parts[places++]) = (_footprints.X[i], _footprints.Y[i], part);
                continue;
            }

            for (int probe = 0; probe < probes; probe++)
            {
                double along = ((probe + 0.5) / probes) - 0.5;
                _x[places] = _footprints.X[i] + (along * _footprints.AxisX[i]);
                _y[places] = _footprints.Y[i] + (along * _footprints.AxisY[i]);
                _parts[places++] = part;
            }
        }

        return pixel;
    }

    /// <summary>Reads the codes at the places, between a level and the next coarser one.</summary>
    private void ReadCodes(AlbedoMap map, int level, int places)
    {
        AlbedoMapLevel finest = map.Levels[0];
        int coarser = Math.Min(level + 1, map.Levels.Count - 1);
        _lanes.Read(map.Levels[level], finest, _x, _y, _codes, places);
        _lanes.Read(map.Levels[coarser], finest, _x, _y, _farCodes, places);
        if (!MixLevels(_codes, _farCodes, _parts, places))
        {
            return;
        }

        MapLevelReader near = new(map, level);
        MapLevelReader far = new(map, coarser);
        for (int i = 0; i < places; i++)
        {
            if (double.IsNaN(_codes[i]))
            {
                _codes[i] = Mixed(near, far, _parts[i], _x[i], _y[i]);
            }
        }
    }

    /// <summary>Whether a code became NaN.</summary>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)] // the first frame would otherwise be shaded with unoptimised vectors
    private static bool MixLevels(Span<double> codes, ReadOnlySpan<double> farCodes, ReadOnlySpan<double> parts, int count)
    {
        Vector512<double> sum = Vector512<double>.Zero;
        int last = count & ~(Vector512<double>.Count - 1);
        for (int i = 0; i < count; i += Vector512<double>.Count)
        {
            Vector512<double> near = ArrayLanes.Load(codes, i);
            Vector512<double> mixed = near + (ArrayLanes.Load(parts, i) * (ArrayLanes.Load(farCodes, i) - near));
            mixed.StoreTo(codes, i);
            sum += i < last ? mixed : Vector512<double>.Zero;
        }

        double all = Vector512.Sum(sum);
        for (int i = last; i < count; i++)
        {
            all += codes[i];
        }

        return double.IsNaN(all);
    }

    private static double Mixed(in MapLevelReader fine, in MapLevelReader coarse, double part, double x, double y)
    {
        double near = fine.At(x, y);
        if (part == 0.0)
        {
            return near;
        }

        double far = coarse.At(x, y);
        return near == 0.0 || far == 0.0 ? Math.Max(near, far) : near + (part * (far - near));
    }

    /// <summary>Leaves one code for each pixel: the mean of its places that have data, 0 if none has.</summary>
    private void AverageCodes(int first, int count, int places)
    {
        if (places == count)
        {
            return;
        }

        int place = 0;
        for (int pixel = 0; pixel < count; pixel++)
        {
            int probes = (int)_footprints.Probes[first + pixel];
            if (probes == 1)
            {
                _codes[pixel] = _codes[place++];
                continue;
            }

            double sum = 0.0;
            int counted = 0;
            foreach (double code in _codes.AsSpan(place, probes))
            {
                sum += code;
                counted += code > 0.0 ? 1 : 0;
            }

            _codes[pixel] = counted == 0 ? 0.0 : sum / counted;
            place += probes;
        }
    }
}
