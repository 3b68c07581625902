using Msisf.Adapters.Ephemeris;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;
using Msisf.Stress.Reference;
using Msisf.TestSupport;

namespace Msisf.Stress.Time;

/// <summary>The built-in kernel reader beside CSPICE.</summary>
public sealed class EnginesStress : IStressTest
{
    private const double Start = 15021.0; // MJD, 1900-01-02
    private const double End = 70171.0; // MJD, 2050-12-31

    /// <inheritdoc/>
    public string Name => "engines";

    /// <inheritdoc/>
    public string Subject =>
        "CSPICE and the built-in reader at random times outside the kernels' cover: the errors.";

    /// <inheritdoc/>
    public string? MissingPart => TestParts.CSpiceLibrary is null ? "CSPICE (scripts/get-cspice.sh)" : null;

    /// <inheritdoc/>
    public StressReport Run(StressLength length, int seed)
    {
        using BuiltInKernels kernels = ProjectKernels.Open();
        using OpenedEphemeris cspice = ProjectKernels.OpenCSpice();
        Found found = new(kernels.Ephemeris, cspice.Engine);
        CaseRandom random = new(seed, part: 0);
        int outside = length == StressLength.Full ? 2_000 : 20; // CSPICE's error needs all kernels read anew
        for (int count = 0; count < outside; count++)
        {
            double away = random.Logarithmic(1.0, 6e5);
            found.NoteOutside(ProjectKernels.OfMjd(random.Below(2) == 0 ? Start - 2.0 - away : End + 2.0 + away));
        }

        return new StressReport(
            Name,
            outside,
            [
                found.Errors.ToFigure("times outside with different errors, or none", "", 0.0),
            ],
            []);
    }

    private sealed class Found(BuiltInEphemeris builtIn, IEphemeris cspice)
    {
        public CaseCount Errors { get; } = new();

        public void NoteOutside(Instant time)
        {
            string? builtInError = Refusals.Of(() => builtIn.SunPositionBodyFixed(time));
            string? cspiceError = Refusals.Of(() => cspice.SunPositionBodyFixed(time));
            Errors.Note(builtInError is null || builtInError != cspiceError, () => MjdText.Of(time.Mjd));
        }
    }
}
