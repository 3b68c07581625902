using Msisf.Adapters.Catalogues;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Ephemeris;
using Msisf.Core.Metadata;
using Msisf.Core.Render.Options;
using Msisf.Core.Scene;
using Msisf.Core.Sky;
using Msisf.Core.Time;

namespace Msisf.App.Preparation;

/// <summary>What the sky of a run is drawn from.</summary>
/// <param name="Stars">The catalogue; null for no stars.</param>
/// <param name="Files">The files that were read.</param>
internal sealed record SkyInputs(StarCatalogue? Stars, IReadOnlyList<InputFile> Files)
{
    /// <summary>Reads the files.</summary>
    /// <param name="settings">The settings; null for none.</param>
    /// <returns>Null if no sky is wanted.</returns>
    /// <exception cref="MsisfException">A file can't be used.</exception>
    public static SkyInputs? Open(SkySettings? settings, ILog log)
    {
        if (settings is not { IsDrawn: true })
        {
            return null;
        }

        if (settings.Catalogue is not { } catalogue)
        {
            return new SkyInputs(null, []);
        }

        StarCatalogueFile file = SkyOptions.Stars.NamedInErrors(() => StarCatalogueReader.Read(catalogue, settings.Faintest));
        if (file.Catalogue.Stars.Count == 0)
        {
            throw SkyOptions.StarLimit.Wrong(Invariant(
                $"leaves no star: all of {file.File!.Name} are fainter than V {settings.Faintest}. Give a larger number, or another "
                    + $"catalogue."));
        }

        if (file.WithoutMagnitude > 0)
        {
            log.Note(Invariant($"{file.File!.Name}: {file.WithoutMagnitude} stars have no magnitude and are not drawn."));
        }

        return new SkyInputs(file.Catalogue, [file.File!]);
    }
}

/// <summary>How the sky lies about the cameras of a run. Not for several threads, as CSPICE is not.</summary>
/// <param name="ephemeris">Opens the ephemeris, or returns the open one.</param>
/// <param name="settings">What is drawn of it.</param>
/// <param name="groundRadius">Radius of the sphere that stands for the ground, m.</param>
internal sealed class SkyPositions(Func<IEphemeris> ephemeris, SkySettings settings, double groundRadius)
{
    private readonly IReadOnlyList<SkyBody> _bodies = settings.Bodies;

    /// <summary>The sky of each band of a camera; empty where none is drawn.</summary>
    /// <param name="observer">What finite light does to the camera's ground; null for nothing.</param>
    /// <exception cref="MsisfException">A time is outside the kernels' cover, or they lack a body.</exception>
    public IReadOnlyList<SkyAxes> Of(ICamera camera, Instant time, SkyObserver? observer)
    {
        IEphemeris engine = ephemeris();
        foreach (SkyBody body in _bodies)
        {
            SkyOptions.Of(body).Named(() => engine.StateOf(body.NaifNumber, time.Tdb)); // kernels may lack it
        }

        return settings.IsDrawn
            ? [.. camera.Bands.Select(band => SkyAxes.At(time, band.Camera.State, observer, engine, groundRadius, _bodies))]
            : [];
    }

    /// <summary>The Earth as a light of a frame; null where it does not light the ground.</summary>
    /// <exception cref="MsisfException">The time is outside the kernels' cover, or they lack the Earth.</exception>
    public SecondLight? EarthLightOf(ICamera camera, Instant time) => settings.HasEarthshine
        ? SkyOptions.Earthshine.Named(() => EarthLight.At(time, camera.State, ephemeris(), groundRadius))
        : null;
}
