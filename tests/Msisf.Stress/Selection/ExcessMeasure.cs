using Msisf.Core.Camera;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;

namespace Msisf.Stress.Selection;

/// <summary>
/// How many more tiles are kept than can be seen, with the light at the camera. A tile counts as seen if a corner, a middle or the middle
/// of a side of one of its facets is (<see cref="TileSight"/>): pixels would miss slivers that antialiasing meets.
/// </summary>
/// <param name="moon">The Moon, at 4 px/deg.</param>
/// <param name="selection">Selects its tiles.</param>
/// <param name="firstCamera">Number of the first of its <see cref="CameraCases"/>.</param>
internal sealed class ExcessMeasure(JudgedMoon moon, Dspsa selection, int firstCamera) : IMeasure<ExcessMeasure>
{
    /// <summary>Kept over seen, of all cameras together: what docs/surface.md states, with room for other cameras.</summary>
    private const double TotalLimit = 1.2;

    /// <summary>Pixels of the image, for the camera's sake.</summary>
    private const int Pixels = 1_000_000;

    private readonly List<(double Ratio, double Altitude, string Text)> _cameras = [];
    private long _kept;
    private long _seen;
    private long _blind;

    /// <summary>The worst of each quantity.</summary>
    public IEnumerable<StressFigure> Figures
    {
        get
        {
            (double Ratio, double Altitude, string Text)[] sorted = Sorted();
            StressFigure At(double share, string name)
            {
                (double ratio, _, string text) = sorted[(int)Math.Min(share * sorted.Length, sorted.Length - 1)];
                return new StressFigure($"tiles kept to tiles seen, a camera's: {name}", "1", ratio, null, text);
            }

            return
            [
                new StressFigure(
                    "tiles kept to tiles seen, all cameras together",
                    "1",
                    (double)_kept / _seen,
                    TotalLimit,
                    $"{_kept} kept, {_seen} seen"),
                At(0.5, "median"), At(0.9, "90 percent"), At(0.99, "99 percent"), At(1.0, "worst"),
                new StressFigure("cameras that keep tiles and see none", "cameras", _blind, null, string.Empty),
            ];
        }
    }

    /// <summary>Errors over the range of an input.</summary>
    public IEnumerable<StressSeries> Series
    {
        get
        {
            SeriesBuilder distribution = new(0.0, 1.0, 50, isLogarithmic: false);
            SeriesBuilder byAltitude = new(50.0, 1e9, 29, isLogarithmic: true);
            (double Ratio, double Altitude, string Text)[] sorted = Sorted();
            for (int place = 0; place < sorted.Length; place++)
            {
                distribution.Add((place + 0.5) / sorted.Length, sorted[place].Ratio);
                byAltitude.Add(sorted[place].Altitude, sorted[place].Ratio);
            }

            return
            [
                distribution.ToSeries("tiles kept to tiles seen", "1", "share of the cameras that do better", "1", null),
                byAltitude.ToSeries("tiles kept to tiles seen", "1", "distance of the camera from the reference sphere", "m", null),
            ];
        }
    }

    /// <inheritdoc/>
    public void Try(int number, CaseRandom random)
    {
        (PinholeCamera camera, _, string kind) = CameraCases.Make(firstCamera + number, moon.Grid, Pixels);
        IReadOnlyList<TileChoice> kept = selection.Select(camera, null).Kept;
        int seen = kept.Count(choice => TileSight.IsSeen(moon.Facets, camera, choice.Tile));
        _kept += kept.Count;
        _seen += seen;
        _blind += seen == 0 && kept.Count > 0 ? 1 : 0;
        if (seen > 0)
        {
            double altitude = Math.Abs(camera.PositionBodyFixed.Length - MoonConstants.ReferenceRadius);
            _cameras.Add(
                ((double)kept.Count / seen, altitude, $"CameraCases {firstCamera + number} ({kind}): {kept.Count} kept, {seen} seen"));
        }
    }

    /// <inheritdoc/>
    public void Add(ExcessMeasure other)
    {
        _cameras.AddRange(other._cameras);
        _kept += other._kept;
        _seen += other._seen;
        _blind += other._blind;
    }

    private (double Ratio, double Altitude, string Text)[] Sorted() => [.. _cameras.OrderBy(camera => camera.Ratio)];
}
