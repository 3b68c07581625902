using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Terrain;
using Msisf.MySql;

namespace Msisf.App.Preparation;

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
