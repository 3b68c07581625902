using System.Diagnostics;

namespace Msisf.App.Host;

/// <summary>
/// Measures the time of each part of a run, s, summed over all frames, also over frames that run concurrently. Thread-safe.
/// </summary>
internal sealed class RunTimes
{
    private readonly Lock _gate = new();
    private readonly double[] _seconds = new double[Enum.GetValues<Phase>().Length];
    private readonly long _start = Stopwatch.GetTimestamp();

    public RunTimes(TimeProvider clock)
    {
        using Process process = Process.GetCurrentProcess();
        double sinceStart = (clock.GetUtcNow().UtcDateTime - process.StartTime.ToUniversalTime()).TotalSeconds;
        Add(Phase.StartUp, Math.Max(0.0, sinceStart));
    }

    /// <summary>Ends <see cref="Phase.Options"/>.</summary>
    public void BeginRun() => Add(Phase.Options, Stopwatch.GetElapsedTime(_start).TotalSeconds);

    public void Add(Phase phase, double seconds)
    {
        lock (_gate)
        {
            _seconds[(int)phase] += seconds;
        }
    }

    public T Measure<T>(Phase phase, Func<T> work)
    {
        long start = Stopwatch.GetTimestamp();
        try
        {
            return work();
        }
        finally
        {
            Add(phase, Stopwatch.GetElapsedTime(start).TotalSeconds);
        }
    }

    public void Measure(Phase phase, Action work) => Measure(phase, () =>
    {
        work();
        return true;
    });

    /// <summary>Time of a part up to now, s.</summary>
    public double SecondsOf(Phase phase)
    {
        lock (_gate)
        {
            return _seconds[(int)phase];
        }
    }

    /// <summary>The part of a total that is in no phase, s; 0 if phases that run at the same time take longer together.</summary>
    /// <param name="totalSeconds"><see cref="TotalSeconds"/>, read once by the caller: it grows.</param>
    public double OtherSeconds(double totalSeconds) => Math.Max(
        0.0,
        totalSeconds - Enum.GetValues<Phase>().Where(phase => phase is not (Phase.Parse or Phase.Trace)).Sum(SecondsOf));

    /// <summary>Time since the process began, s.</summary>
    public double TotalSeconds => SecondsOf(Phase.StartUp) + Stopwatch.GetElapsedTime(_start).TotalSeconds;
}

/// <summary>The parts of a run whose times <c>--timing</c> prints separately.</summary>
internal enum Phase
{
    /// <summary>From the start of the process to the first line of the program's own work.</summary>
    StartUp,

    /// <summary>From there to the beginning of the run: parsing and reading the options.</summary>
    Options,

    /// <summary>Reading or computing the spacecraft's states: positions, times and attitudes.</summary>
    States,

    /// <summary>Opening the ephemeris engine and its kernels, and computing the Sun's positions.</summary>
    Sun,

    /// <summary>Opening the elevation model and its summary.</summary>
    Model,

    /// <summary>Telling from the cameras what the images will show.</summary>
    Preview,

    /// <summary>Checksums of the inputs, the manifest, and the check of existing frames.</summary>
    Manifest,

    /// <summary>Selection of the tiles.</summary>
    Selection,

    /// <summary>Checking and making patterns.</summary>
    Patterns,

    /// <summary>Running POV-Ray, from the start of its process to its exit.</summary>
    PovRay,

    /// <summary>Parse time that POV-Ray reports.</summary>
    Parse,

    /// <summary>Trace time that POV-Ray reports.</summary>
    Trace,

    /// <summary>Drawing by the program's own renderer.</summary>
    Draw,

    /// <summary>Turning the light of a frame into the numbers of the camera's detector.</summary>
    Detector,

    /// <summary>Writing the image, scene and annotation files.</summary>
    Output,

    /// <summary>Writing the meta file with its pixels.</summary>
    Xml,

    /// <summary>Reading catalogues, finding the craters of frames, and writing their files.</summary>
    Navigation,

    /// <summary>Writing the layers: the ground truth of every pixel.</summary>
    Layers,

    /// <summary>Reading catalogues of stars, finding those of frames, and adding their light.</summary>
    Sky,
}
