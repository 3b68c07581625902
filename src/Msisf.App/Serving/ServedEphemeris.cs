using System.Collections.Concurrent;
using Msisf.Adapters.Ephemeris;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Metadata;

namespace Msisf.App.Serving;

/// <summary>The ephemeris engines of a server, each opened once, and the checksums of what frames are made from. Thread-safe.</summary>
internal sealed class ServedEphemeris(ProgramHost host) : IDisposable
{
    private readonly Lock _gate = new();
    private readonly Dictionary<EphemerisChoice, EphemerisSource> _sources = [];
    private readonly ConcurrentDictionary<(string Model, bool IgnoreSun), Lazy<RunInputs>> _inputs = new();

    /// <summary>The opened engine that settings ask for.</summary>
    public EphemerisSource Of(RenderSettings settings)
    {
        lock (_gate)
        {
            if (!_sources.TryGetValue(settings.Ephemeris, out EphemerisSource? source))
            {
                source = new EphemerisSource(settings, host);
                source.Engine();
                _sources.Add(settings.Ephemeris, source);
            }

            return source;
        }
    }

    /// <summary>The files of a model and the kernels, with their checksums, which are computed once.</summary>
    public IReadOnlyList<InputFile> InputsOf(ServedModel model, RenderSettings settings) => _inputs.GetOrAdd(
        (model.Name, settings.IgnoreSun),
        key => new Lazy<RunInputs>(() =>
        {
            RunInputs inputs = new(() => key.IgnoreSun ? [] : Of(settings).KernelFiles(), host, CancellationToken.None);
            inputs.Begin(model.Opened.Sets, []);
            return inputs;
        })).Value.All(camera: null);

    /// <summary>Closes the engines.</summary>
    public void Dispose()
    {
        foreach (Lazy<RunInputs> inputs in _inputs.Values.Where(inputs => inputs.IsValueCreated))
        {
            inputs.Value.Dispose();
        }

        foreach (EphemerisSource source in _sources.Values)
        {
            source.Dispose();
        }
    }
}
