using Msisf.Core.Render.Options;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Tells which part of the light from the ground is done. Before the first samples are there, nobody knows how many are needed; then the
/// groups of points say it, and after each round anew. Thread-safe.
/// </summary>
/// <param name="options">Receiver of the reports, and how many sets of points a frame has.</param>
internal sealed class IndirectProgress(NativeRenderOptions options)
{
    /// <summary>All samples over the first ones: a guess, until these are there.</summary>
    private const double TypicalRatio = 8.0;

    /// <summary>Placing the points that stand for the ground, and looking which of them are seen from where, over all: a guess.</summary>
    private const double TypicalPreparation = 0.1;

    /// <summary>The two steps of the preparation that are reported.</summary>
    private const double Steps = 2.0;

    private readonly Lock _gate = new();
    private double _prepared;
    private int _sets;
    private int _strips;
    private int _stripsDone;
    private double _done;
    private double? _all;

    /// <summary>Adds a part of a step of the preparation.</summary>
    public void Prepare(double part)
    {
        lock (_gate)
        {
            _prepared += part / Steps;
            options.Progress?.Report(TypicalPreparation * Math.Min(1.0, _prepared));
        }
    }

    /// <summary>Begins a set of points with the first samples of each strip.</summary>
    public void Begin(int strips) => (_strips, _stripsDone, _done, _all) = (strips, 0, 0.0, null);

    /// <summary>Begins another round.</summary>
    /// <param name="cost">What is left to do (<see cref="Trial.CostOf"/>).</param>
    public void Expect(double cost) => _all = _done + cost;

    /// <summary>Adds what the samples of a strip have cost.</summary>
    public void Add(double cost)
    {
        lock (_gate)
        {
            _stripsDone++;
            _done += cost;
            Report(_all is { } all ? Math.Min(1.0, _done / all) : _stripsDone / (TypicalRatio * _strips));
        }
    }

    /// <summary>Ends a set of points.</summary>
    public void End()
    {
        _sets++;
        Report(0.0);
    }

    /// <summary>Ends the frame.</summary>
    public void Finish() => options.Progress?.Report(1.0);

    private void Report(double part)
    {
        double sets = _sets + part;
        double all = options is { Adaptive: null, SubsamplesPerAxis: 1 } ? 1.0 : sets + 1.0; // nobody knows how many
        options.Progress?.Report(Math.Min(1.0, TypicalPreparation + ((1.0 - TypicalPreparation) * sets / all)));
    }
}
