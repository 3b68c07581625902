using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Render;
using Msisf.Core.Terrain;
using Msisf.MySql;

namespace Msisf.App.Preparation;

/// <summary>The elevation model of a run, opened at the first request: some cameras are placed over it before a frame needs it.</summary>
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
            settings.Ldem, settings.LevelOfDetailError is not null || settings.Native.Refine is not null, host, cancellation)
        : ModelOpening.Open(
            settings.Ldem.SingleOrDefault(), settings.Resolution, isSparing: settings.Renderer == RendererKind.PovRay, host,
            settings.Body, cancellation);
}

/// <summary>The elevation model from which patterns are made, read from a file or the database.</summary>
internal sealed class GridSource : IDisposable
{
    private readonly IDisposable _owner;

    private GridSource(IGlobalGrid grid, IDisposable owner)
    {
        Grid = grid;
        _owner = owner;
    }

    public IGlobalGrid Grid { get; }

    /// <summary>Opens the elevation model.</summary>
    public static GridSource Open(WholeMoonSettings settings, ProgramHost host, CancellationToken cancellation)
    {
        if (settings.IsDatabase)
        {
            DatabaseSettings database = PatternsOptions.DefaultsFile.NamedInErrors(
                () => DatabaseSettings.Read(settings.DefaultsFile, host.Environment));
            return FromDatabase(database, settings.PixelsPerDegree, host, cancellation);
        }

        ElevationModel model = ModelOpening.Open(
            settings.Ldem, settings.PixelsPerDegree, isSparing: true, host, cancellation: cancellation);
        return new GridSource(model.WholeMoon, model);
    }

    public void Dispose() => _owner.Dispose();

    private static GridSource FromDatabase(DatabaseSettings settings, int resolution, ProgramHost host, CancellationToken cancellation)
    {
        if (settings.IsUnverified)
        {
            host.Log.Note($"The server {settings.Server} is not verified: no ssl-ca says who may answer (docs/database.md, TLS).");
        }

        Database database = Database.Open(settings, cancellation);
        try
        {
            LdemTableGrid grid = LdemTableGrid.Open(database, resolution);
            host.Log.Note($"Elevation: {grid.ProductId} (database {settings.Database}).");
            return new GridSource(grid, database);
        }
        catch
        {
            database.Dispose();
            throw;
        }
    }
}
