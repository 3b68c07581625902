using Msisf.Adapters.Ephemeris;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Scene;

namespace Msisf.App.Cluster;

/// <summary>A run that was checked as if it were to be made at once.</summary>
/// <param name="Mode">How its states are given.</param>
/// <param name="Settings">Its options.</param>
/// <param name="Engine">The ephemeris engine that was opened for it; null for none.</param>
/// <param name="States">All of them.</param>
/// <param name="Frames">Those that are to be made.</param>
/// <param name="Model">The elevation model.</param>
internal sealed record PlannedRun(
    Mode Mode, RenderSettings Settings, EphemerisChoice? Engine, IReadOnlyList<SpacecraftState> States, IReadOnlyList<Frame> Frames,
    ElevationModel Model)
    : IDisposable
{
    public void Dispose() => Model.Dispose();
}
