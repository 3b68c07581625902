using System.Diagnostics;
using System.Globalization;
using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>A long series of small frames in one process: whether its last frames cost what its first did.</summary>
public sealed class LongSeriesStress : IStressTest
{
    private const string Output = "frames";
    private const string Times = "times.tsv";

    /// <summary>Memory is settled by then.</summary>
    private const int SettledFrame = 1000;

    /// <summary>1: a tenth may hold more frames with much ground in sight than another.</summary>
    private const double MaxGrowth = 1.25;

    /// <summary>
    /// 1: a short series lasts a second or two, in which the machine may have had other work, such as the other tests. A cost that grows
    /// with the number of frames made would be 19 times as much.
    /// </summary>
    private const double MaxGrowthOfShort = 4.0;

    /// <summary>s.</summary>
    private const double LongestStatus = 2.0;

    /// <inheritdoc/>
    public string Name => "long-series";

    /// <inheritdoc/>
    public string Subject =>
        "10,000 frames (1,200 at everyday length) of 64 x 64 px by the native renderer in one process: "
            + "time of a frame and memory at its end against its beginning; "
            + "then msis status, and the same call again, which finds all frames made.";

    /// <inheritdoc/>
    public bool IsOfThisMachine => true;

    /// <inheritdoc/>
    public string? MissingPart => Msis.MissingPart;

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        bool isFull = length == StressLength.Full;
        FrameSeries series = new(isFull ? 10_000 : 1_200, Size: 64);
        using TemporaryFolder folder = new();
        (double settled, double last) = Memory(folder, series);
        double[] seconds = SecondsOfFrames(folder[Times]);
        int tenth = seconds.Length / 10;
        double first = Median(seconds.AsSpan(0, tenth));
        double growth = Median(seconds.AsSpan(seconds.Length - tenth)) / first;
        double again = SecondsOf(folder, series.Arguments(Output), isRightEnd: run => run.Output.Split('\n').Length > 2 * series.Frames);
        double status = SecondsOf(folder, ["status", Output], isRightEnd: _ => true);
        string frames = Text($"{seconds.Length} frames");
        double mostGrowth = isFull ? MaxGrowth : MaxGrowthOfShort;
        return new StressReport(
            Name,
            seconds.Length,
            [
                new StressFigure(
                    "median time of a frame in the last tenth, over that in the first",
                    string.Empty,
                    growth,
                    mostGrowth,
                    Text($"{frames}, {1000.0 * first:0.00} ms in the first tenth")),
                new StressFigure(
                    Text($"resident memory after the last frame, over that after {SettledFrame} frames"),
                    string.Empty,
                    last / settled,
                    MaxGrowth,
                    Text($"{frames}, {last / 1e6:0} MB at the end")),
                new StressFigure("msis status", "s", status, isFull ? LongestStatus : null, frames),
                new StressFigure("the same call again, which skips all frames", "s", again, null, frames),
            ],
            []);
    }

    /// <summary>Makes the frames; their paths on standard output tell how far it is.</summary>
    private static (double Settled, double Last) Memory(TemporaryFolder folder, FrameSeries series)
    {
        const int FilesOfFrame = 2;
        const int LinesOfLook = FilesOfFrame * SettledFrame / 10;
        int lines = 0;
        double settled = double.NaN;
        double last = double.NaN;
        int id = 0;
        using RunningProgram program = Msis.Start(folder.Path, series.Arguments(Output, "--frame-times", Times), text =>
        {
            int before = lines;
            lines += text.Count('\n');
            if (lines / LinesOfLook > before / LinesOfLook && ProcessTable.MemoryOf(id) is long bytes)
            {
                settled = lines <= FilesOfFrame * SettledFrame ? bytes : settled;
                last = bytes;
            }
        });
        id = program.Id;
        program.End(Msis.Limit).Succeeded();
        return (settled, last);
    }

    private static double SecondsOf(TemporaryFolder folder, IReadOnlyList<string> arguments, Func<ChildRun, bool> isRightEnd)
    {
        Stopwatch watch = Stopwatch.StartNew();
        ChildRun run = Msis.Run(folder.Path, arguments).Succeeded();
        return isRightEnd(run) ? watch.Elapsed.TotalSeconds : double.NaN;
    }

    /// <summary>A line is step, name, seconds; in the order of the steps.</summary>
    private static double[] SecondsOfFrames(string file) =>
    [
        .. File.ReadLines(file).Select(line => line.Split('\t'))
            .OrderBy(fields => int.Parse(fields[0], CultureInfo.InvariantCulture))
            .Select(fields => double.Parse(fields[2], CultureInfo.InvariantCulture)),
    ];

    private static double Median(ReadOnlySpan<double> values)
    {
        double[] sorted = values.ToArray();
        Array.Sort(sorted);
        return sorted[sorted.Length / 2];
    }

    private static string Text(FormattableString text) => FormattableString.Invariant(text);
}
