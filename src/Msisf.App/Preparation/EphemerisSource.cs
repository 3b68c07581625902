using Msisf.Adapters.Ephemeris;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Ephemeris;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>The ephemeris engine of a run.</summary>
internal sealed class EphemerisSource(RenderSettings settings, ProgramHost host) : IDisposable
{
    private TimeScale? _timeScale;

    /// <summary>The opened engine; null if it was not needed yet.</summary>
    public OpenedEphemeris? Opened { get; private set; }

    /// <summary>Which kernels give the Moon's frame, where the user names kernels; null before they are opened.</summary>
    public string? Orientation { get; private set; }

    /// <summary>The engine, opened on first use.</summary>
    public IEphemeris Engine()
    {
        if (Opened is null)
        {
            Opened = Open(host, settings.Ephemeris, settings.Body, settings.Kernels, settings.SpacecraftKernels);
            host.Log.Note(Opened.Notice);
            Orientation = NamedOrientation(Opened);
        }

        return Opened.Engine;
    }

    /// <summary>The engine with its kernels, opened on first use.</summary>
    public OpenedEphemeris Kernels()
    {
        Engine();
        return Opened!;
    }

    /// <summary>The leap seconds of the engine's kernels; the call opens no other kernel.</summary>
    public TimeScale TimeScale() => _timeScale ??= Opened?.Engine.TimeScale ?? LeapSecondsKernel.ReadScale(KernelFiles());

    /// <summary>The leap seconds of the installation's kernels and those that a user names.</summary>
    public static TimeScale ReadTimeScale(ProgramHost host, IReadOnlyList<string> kernels) => LightOptions.Kernels.NamedInErrors(
        () => LeapSecondsKernel.ReadScale(KernelList.Expand(NamesOf(host, CelestialBody.Moon, kernels, SpacecraftKernels.None))));

    /// <summary>The kernels that the engine reads, in load order; the call opens no kernel.</summary>
    public IReadOnlyList<string> KernelFiles() => LightOptions.Kernels.NamedInErrors(
        () => KernelList.Expand(NamesOf(host, settings.Body, settings.Kernels, settings.SpacecraftKernels)));

    /// <summary>Opens an engine with the kernels of the installation and those that a user names.</summary>
    /// <param name="ofSpacecraft">Those of the spacecraft.</param>
    public static OpenedEphemeris Open(
        ProgramHost host, EphemerisChoice engine, CelestialBody body, IReadOnlyList<string> kernels,
        SpacecraftKernels ofSpacecraft) => LightOptions.Kernels.NamedInErrors(() => EphemerisFactory.Open(new EphemerisRequest(
            engine, NamesOf(host, body, kernels, ofSpacecraft), host.Installation.Root, host.Environment("MSISF_CSPICE"))
        {
            Body = body,
        }));

    public void Dispose() => Opened?.Dispose();

    private static IReadOnlyList<string> NamesOf(
        ProgramHost host, CelestialBody body, IReadOnlyList<string> kernels, SpacecraftKernels ofSpacecraft) => KernelList.OnTop(
        body.IsMoon ? host.Installation.MetaKernel : host.Installation.BodiesMetaKernel, kernels, ofSpacecraft);

    /// <summary>Which kernels give the Moon's frame; null for those of the installation.</summary>
    /// <exception cref="BadInputException">Two of them give different ones.</exception>
    private string? NamedOrientation(OpenedEphemeris opened)
    {
        if (!settings.Body.IsMoon || (settings.Kernels.Count == 0 && settings.SpacecraftKernels.All.Count == 0))
        {
            return null;
        }

        try
        {
            _ = opened.Catalogue;
        }
        catch (BadInputException) when (!settings.IsMission)
        {
            return null; // CSPICE takes kernels that the built-in reader does not know
        }

        return LightOptions.Kernels.NamedInErrors(() => LunarOrientation.Of(opened.Catalogue));
    }
}
