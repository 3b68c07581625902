using System.Data.Common;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Terrain;
using Msisf.MySql;

namespace Msisf.App.Preparation;

/// <summary>The elevation model that patterns are made of, from a file or the database.</summary>
internal sealed class GridSource : IDisposable
{
    private readonly IDisposable _owner;

    private GridSource(IElevationGrid grid, IDisposable owner)
    {
        Grid = grid;
        _owner = owner;
    }

    public IElevationGrid Grid { get; }

    /// <summary>Opens it.</summary>
    public static GridSource Open(WholeMoonSettings settings, ProgramHost host)
    {
        if (settings.IsDatabase)
        {
            return FromDatabase(PatternsOptions.DefaultsFile.Concerned(() => DatabaseSettings.Read(settings.DefaultsFile, host.Environment)), settings.PixelsPerDegree, host);
        }

        ElevationModel model = ElevationModel.Open(settings.Ldem, settings.PixelsPerDegree, isSparing: true, host);
        return new GridSource(model.Grid, model);
    }

    public void Dispose() => _owner.Dispose();

    private static GridSource FromDatabase(DatabaseSettings settings, int resolution, ProgramHost host)
    {
        DbDataSource connections = MySqlProvider.Open(settings, Path.Combine(AppContext.BaseDirectory, "mysql"));
        try
        {
            LdemTableGrid grid = LdemTableGrid.Open(connections, resolution);
            host.Log.Note($"Elevation: {grid.ProductId} (database {settings.Database}).");
            return new GridSource(grid, connections);
        }
        catch
        {
            connections.Dispose();
            throw;
        }
    }
}
