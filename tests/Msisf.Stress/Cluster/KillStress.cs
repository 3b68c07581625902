using System.Globalization;
using Msisf.TestSupport;

namespace Msisf.Stress.Cluster;

/// <summary>Kills the program and POV-Ray at random moments, many times.</summary>
public sealed class KillStress : IStressTest
{
    private const int KillsOfFolder = 6;

    /// <inheritdoc/>
    public string Name => "kills";

    /// <inheritdoc/>
    public string Subject =>
        "kill -9 at random moments of runs that make 300 frames (150 at everyday length) by the native renderer "
            + "or 4 by POV-Ray from an empty pattern repository: "
            + "of the program (a node that vanishes) or of POV-Ray. Up to six kills a folder, "
            + "each of a run that goes on where the one before was killed; "
            + "then a run that may end, msis verify, and a comparison with a set and patterns that one undisturbed process made.";

    /// <inheritdoc/>
    public string? MissingPart => Msis.MissingPart ?? (TestParts.Program("povray") is null ? "POV-Ray" : null);

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        (int frames, int native, int program, int povRay) = length == StressLength.Full ? (300, 480, 240, 220) : (150, 4, 2, 2);
        SetJudge judge = new();
        CaseCount unnoticed = new();
        using KilledSet nativeSet = new(frames, size: 64, isPovRay: false);
        using KilledSet povRaySet = new(frames: 4, size: 32, isPovRay: true);
        int kills = Kill(native, "native, msis", new CaseRandom(seed, part: 0), (most, random, what) =>
            nativeSet.Run(most, isPovRayKilled: false, random, judge, unnoticed, what));
        kills += Kill(program, "POV-Ray, msis", new CaseRandom(seed, part: 1), (most, random, what) =>
            povRaySet.Run(most, isPovRayKilled: false, random, judge, unnoticed, what));
        kills += Kill(povRay, "POV-Ray itself", new CaseRandom(seed, part: 2), (most, random, what) =>
            povRaySet.Run(most, isPovRayKilled: true, random, judge, unnoticed, what));
        return new StressReport(
            Name, kills,
            [.. judge.Figures(), unnoticed.ToFigure("runs that lost a POV-Ray and did not end with exit code 3", string.Empty, 0.0)], []);
    }

    private static int Kill(int kills, string kind, CaseRandom random, Func<int, CaseRandom, string, int> run)
    {
        int done = 0;
        for (int folder = 1; done < kills; folder++)
        {
            done += run(
                Math.Min(KillsOfFolder, kills - done), random, string.Create(CultureInfo.InvariantCulture, $"{kind}, folder {folder}"));
        }

        return done;
    }
}
