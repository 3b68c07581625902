using System.Globalization;
using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>Disks that are full or read-only in the middle of a run.</summary>
public sealed class StorageStress : IStressTest
{
    private const string Output = "frames";
    private const string Patterns = "patterns";
    private const string Copy = "copy";


    /// <summary>
    /// Runs the program where the storage fails and again where it does not, and copies what came of it. $1 says how many KB the disk has
    /// at first.
    /// </summary>
    private const string FullDisk = """
        size=$1; shift
        mkdir frames patterns copy disk
        mount -t tmpfs -o size=64m none disk
        mkdir disk/frames disk/patterns
        head -c "$((64 * 1024 - size))K" /dev/zero >disk/ballast
        mount --bind disk/frames frames
        mount --bind disk/patterns patterns
        code=0; "$@" >first.txt 2>&1 || code=$?
        echo "$code"
        rm disk/ballast
        code=0; "$@" >second.txt 2>&1 || code=$?
        echo "$code"
        cp -R frames patterns copy
        """;

    /// <summary>The same on a read-only mount of the folder named by $1, after a run of the first frames.</summary>
    private const string ReadOnly = """
        folder=$1; shift
        mkdir frames patterns copy
        "$@" --frames 1:3 >before.txt 2>&1
        mount --bind "$folder" "$folder"
        mount -o remount,bind,ro "$folder"
        code=0; "$@" >first.txt 2>&1 || code=$?
        echo "$code"
        mount -o remount,bind,rw "$folder"
        code=0; "$@" >second.txt 2>&1 || code=$?
        echo "$code"
        cp -R frames patterns copy
        """;

    /// <inheritdoc/>
    public string Name => "storage";

    /// <inheritdoc/>
    public string Subject =>
        "Runs whose disk is full at a random moment (a small tmpfs for frames and patterns), "
            + "or whose folder of outputs or patterns becomes read-only; then the same call with room enough. Both renderers.";

    /// <inheritdoc/>
    public string? MissingPart =>
        Msis.MissingPart ?? MountNamespace.MissingPart ?? (TestParts.Program("povray") is null ? "POV-Ray" : null);

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int times = length == StressLength.Full ? 20 : 1;
        CaseRandom random = new(seed, part: 0);
        SetJudge judge = new();
        CaseCount unclear = new();
        int cases = 0;
        foreach (FrameSeries series in (FrameSeries[])[new(60, Size: 64), new(4, Size: 32, Patterns)])
        {
            using TemporaryFolder alone = new();
            Msis.Run(alone.Path, series.Arguments(Output)).Succeeded();
            List<(string Script, string Argument)> tried = [(ReadOnly, Output)];
            if (series.Patterns is not null)
            {
                tried.Add((ReadOnly, Patterns));
            }

            for (int i = 0; i < times; i++)
            {
                (int least, int most) = i % 2 == 0 ? (50, 250) : (250, 700);
                tried.Add((FullDisk, Kilobytes(random, least, most)));
            }

            foreach ((string script, string argument) in tried)
            {
                Try(series, script, argument, alone, judge, unclear);
            }

            cases += tried.Count;
        }

        return new StressReport(
            Name, cases,
            [.. judge.Figures(), unclear.ToFigure(
                "runs that could not write and did not end with a line that says so and exit code 2 or 3", string.Empty, 0.0)], []);
    }

    private static void Try(FrameSeries series, string script, string argument, TemporaryFolder alone, SetJudge judge, CaseCount unclear)
    {
        using TemporaryFolder folder = new();
        string what = $"{(script == FullDisk ? "disk of KB" : "read-only")} {argument}, {(series.Patterns is null ? "native" : "POV-Ray")}";
        string[] codes = MountNamespace.Run(folder.Path, script, [argument, Msis.Program, .. series.Arguments(Output)]).Split('\n');
        string first = File.ReadAllText(folder["first.txt"]);
        ChildRun last = new(int.Parse(codes[1], CultureInfo.InvariantCulture), string.Empty, File.ReadAllText(folder["second.txt"]));

        // 0: it was enough; 2: it is known before the first frame that it is not; 3: it is found out meanwhile.
        unclear.Note(
            codes[0] != "0" && (codes[0] is not ("2" or "3") || !first.Contains("msis: error:", StringComparison.Ordinal)),
            () => $"{what}: exit code {codes[0]}: {SetJudge.OneLine(first)}");
        FrameFolder set = new(folder[Path.Combine(Copy, Output)]);
        judge.Judge(set, new FrameFolder(alone[Output]), last, inFlight: set.FramesMade, what);
        if (series.Patterns is not null)
        {
            FrameFolder patterns = new(folder[Path.Combine(Copy, Patterns, "LDEM_4")]);
            judge.NoteDifferences(patterns, new FrameFolder(alone[Path.Combine(Patterns, "LDEM_4")]), what);
            judge.NoteLeftovers(patterns.Leftovers, what);
        }
    }

    private static string Kilobytes(CaseRandom random, int from, int to) =>
        ((int)random.Logarithmic(from, to)).ToString(CultureInfo.InvariantCulture);
}
