using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.Core.Render;

namespace Msisf.App.Preparation;

/// <summary>The elevation model of a run, opened at the first request: some cameras are placed over it before a frame needs it.</summary>
/// <param name="host">Knows the folder of the installation, and receives log messages and times.</param>
/// <param name="cancellation">Ends the first look at a large raster.</param>
internal sealed class ModelOnDemand(RenderSettings settings, ProgramHost host, CancellationToken cancellation) : IDisposable
{
    private ElevationModel? _model;

    public bool IsOpen => _model is not null;

    public ElevationModel Opened => _model ??= host.Times.Measure(
        Phase.Model, () => settings.Native.Refine is { } refine ? Open().Refined(refine, host) : Open());

    public void Dispose() => _model?.Dispose();

    /// <summary>With invented detail, as with levels of detail, few frames or none show the models alone.</summary>
    private ElevationModel Open() => settings.Ldem.Count > 1
        ? ModelOpening.OpenSeveral(
            settings.Ldem, settings.NestBlend, settings.LevelOfDetailError is not null || settings.Native.Refine is not null, host,
            cancellation)
        : ModelOpening.Open(
            settings.Ldem.SingleOrDefault(), settings.Resolution, isSparing: settings.Renderer == RendererKind.PovRay, host,
            settings.Body, cancellation);
}
