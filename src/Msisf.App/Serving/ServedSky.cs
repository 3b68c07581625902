using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Settings;

namespace Msisf.App.Serving;

/// <summary>The catalogues of stars of a server's sessions: each is in memory once, as long as a session has it. Thread-safe.</summary>
internal sealed class ServedSky(ILog log)
{
    private readonly Lock _gate = new();
    private readonly Dictionary<(string? Catalogue, double? Faintest), WeakReference<SkyInputs>> _inputs = [];

    /// <summary>What a sky is drawn from; null where none is drawn.</summary>
    /// <exception cref="MsisfException">A file can't be used.</exception>
    public SkyInputs? Of(SkySettings? settings)
    {
        if (settings is not { IsDrawn: true })
        {
            return null;
        }

        lock (_gate)
        {
            (string?, double?) key = (settings.Catalogue, settings.Faintest);
            if (_inputs.TryGetValue(key, out WeakReference<SkyInputs>? kept) && kept.TryGetTarget(out SkyInputs? inputs))
            {
                return inputs;
            }

            SkyInputs opened = SkyInputs.Open(settings, log)!;
            foreach ((string?, double?) gone in _inputs.Keys.Where(known => !_inputs[known].TryGetTarget(out _)).ToArray())
            {
                _inputs.Remove(gone);
            }

            _inputs[key] = new WeakReference<SkyInputs>(opened);
            return opened;
        }
    }
}
