using System.Globalization;
using Msisf.Benchmarks.Definitions;
using Msisf.Benchmarks.Programs;
using Msisf.Core.Terrain;

namespace Msisf.Benchmarks.Measures;

/// <summary>
/// Many frames in one process: one turn of a polar orbit, with images and meta files; and a few frames of it with all layers.
/// </summary>
internal sealed class Sequences
{
    private const double Altitude = 100e3; // m over the mean radius
    private const double EpochMjd = 55289.0;

    /// <summary>
    /// rad, 286.5 degrees: 29 degrees from the sub-solar point (315.9 E), so that the turn begins and ends near noon and half of it is
    /// night.
    /// </summary>
    private const double AscendingNode = 5.0;

    private const double SecondsADay = 86400.0;

    private readonly Workbench _bench;
    private readonly Repeats _repeats;

    public Sequences(Workbench bench, Repeats repeats)
    {
        _bench = bench;
        _repeats = repeats;
    }

    /// <summary>Images and meta files.</summary>
    public SequenceResult Plain() => Run(_repeats.SequenceFrames, []);

    /// <summary>All layers in FITS as well.</summary>
    public SequenceResult WithLayers() => Run(_repeats.LayeredFrames, ["--layers", "all", "--layers-format", "fits"]);

    private SequenceResult Run(int frames, IReadOnlyList<string> options)
    {
        string folder = _bench.NewOutputFolder();
        ProgramRun run = _bench.Msis.Run(
            [
                .. Orbit(frames),
                .. _bench.ImageOptions(_repeats.SequencePixelsPerDegree, folder),
                "--renderer", "native", "--reflectance", "lambert",
                .. options,
            ],
            watch: MemoryWatch.Own);
        long bytes = new DirectoryInfo(folder).EnumerateFiles().Sum(file => file.Length);
        Workbench.Delete(folder); // gigabytes
        return new SequenceResult(frames, run, bytes);
    }

    /// <summary>The frames are those of a turn of <see cref="Repeats.SequenceFrames"/>, from its first one on.</summary>
    private string[] Orbit(int frames)
    {
        double axis = MoonConstants.MeanRadius + Altitude;
        double turn = 2.0 * Math.PI * Math.Sqrt(axis * axis * axis / MoonConstants.GravitationalParameter);
        double step = turn / _repeats.SequenceFrames / SecondsADay;
        double end = EpochMjd + ((frames - 0.5) * step); // half a step more: a date has not the digits for a whole number of steps
        return
        [
            "--kepler-set", string.Create(CultureInfo.InvariantCulture, $"{{{axis:R},0,0,{AscendingNode:R},{Math.PI / 2.0:R},0}}"),
            "--epoch", EpochMjd.ToString("R", CultureInfo.InvariantCulture),
            "--time-interval", string.Create(CultureInfo.InvariantCulture, $"[{EpochMjd:R}:{step:R}:{end:R}]"),
        ];
    }
}
