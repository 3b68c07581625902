using System.Globalization;

namespace Msisf.Stress.Fuzz;

/// <summary>The program with damaged input of every kind.</summary>
public sealed class FuzzStress : IStressTest
{
    /// <summary>Cases block a thread each while their run needs some; the pool adds new ones too slowly.</summary>
    private const int PoolThreads = 32;

    /// <inheritdoc/>
    public string Name => "fuzz";

    /// <inheritdoc/>
    public string Subject =>
        "Whole calls in this process, with command lines, response, batch and configuration files, labels, images, GeoTIFFs, pyramids, "
            + "summaries, kernels and manifests that are right but for seeded "
        + "damage: flipped bits, lost, inserted and repeated pieces, swapped words, extreme numbers, moved lines, other encodings, "
        + "deep nesting.";

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        int cases = length == StressLength.Full ? 100_000 : 300;
        ThreadPool.GetMinThreads(out int workers, out int ports);
        ThreadPool.SetMinThreads(Math.Max(workers, PoolThreads), ports);
        DirectoryInfo folder = Directory.CreateDirectory(
            Path.Combine(RoomForCases(), FormattableString.Invariant($"msisf fuzz {Environment.ProcessId}")));
        try
        {
            using FuzzWorld world = new(folder.FullName);
            using SemaphoreSlim atOnce = new(Environment.ProcessorCount);
            IFuzzTarget[] turns = TurnsOf(world);
            CaseCount refused = RightInputs.Check(turns.Distinct(), folder.FullName, seed);
            MemoryPeak.Reset();
            FuzzMeasure found = SeededCases.Run(cases, seed, () => new FuzzMeasure(turns, folder.FullName, atOnce, seed));
            return new StressReport(
                Name,
                cases,
                [refused.ToFigure("right inputs, before any damage, that are refused", "", 0.0), .. FiguresOf(found, cases)],
                []);
        }
        finally
        {
            ThreadPool.SetMinThreads(workers, ports);
            folder.Delete(recursive: true);
        }
    }

    /// <summary>What is damaged, in turns.</summary>
    private static IFuzzTarget[] TurnsOf(FuzzWorld world)
    {
        TextInputs texts = new(world);
        ModelInputs models = new(world);
        return
        [
            new ArgumentTarget(world), texts.ResponseFiles, texts.BatchFiles, texts.ConfigFiles, texts.Manifests, texts.Kernels,
            models.Labels, models.Images, ModelInputs.GeoTiffs, models.Pyramids,
        ];
    }

    private static StressFigure[] FiguresOf(FuzzMeasure found, int cases) =>
    [
        found.CountOf(FuzzFault.Bug).ToFigure("calls that ended with exit code 70 or an exception", "", 0.0),
        found.CountOf(FuzzFault.UnknownExitCode).ToFigure("calls that ended with an exit code that is not documented", "", 0.0),
        found.CountOf(FuzzFault.Hang).ToFigure(
            string.Create(
                CultureInfo.InvariantCulture,
                $"calls that were told to end after {FuzzRunner.LongestWork.TotalSeconds} s and did not within "
                    + $"{FuzzRunner.LongestEnd.TotalSeconds} s"), "", 0.0),
        found.CountOf(FuzzFault.ErrorLine).ToFigure("failures without their one line of error, or with more", "", 0.0),
        found.CountOf(FuzzFault.PartialOutput).ToFigure("calls that left a temporary file, half an image or half a meta file", "", 0.0),
        found.CountOf(FuzzFault.Memory).ToFigure(
            FormattableString.Invariant($"calls in which the process came to more than {FuzzMeasure.MaxMemory / 1e9} GB"), "", 0.0),
        new StressFigure("calls that failed, as most of them should", "", cases - found.Successes, null, "no single one"),
    ];

    /// <summary>
    /// Cases make many small files, and each is written through to the disk: in memory where the system has such a place.
    /// </summary>
    private static string RoomForCases() => Directory.Exists("/dev/shm") ? "/dev/shm" : Path.GetTempPath();
}
