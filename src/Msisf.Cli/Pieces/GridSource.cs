using System.CommandLine;
using System.Data.Common;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.Cli.Options;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.MySql;

namespace Msisf.Cli.Pieces;

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

    public static GridSource Open(ParseResult line, SourceOptions source, DatabaseOptions database, ProgramHost host)
    {
        int resolution = source.ReadResolution(line);
        string? ldem = line.GetValue(source.Ldem) is string path ? OptionText.FilePath(source.Ldem, path) : null;
        bool isDatabase = line.GetValue(database.Source) is string name
            && OptionText.Choice(database.Source, name, [("ldem", false), ("mysql", true)]);
        string? optionFile = line.GetValue(database.DefaultsFile) is string file ? OptionText.FilePath(database.DefaultsFile, file) : null;
        if (isDatabase)
        {
            return ldem is null
                ? FromDatabase(DatabaseSettings.Read(optionFile, host.Environment), resolution, host)
                : throw new UsageException("--ldem and --source mysql contradict each other. Give one of them.");
        }

        if (optionFile is not null)
        {
            throw new UsageException("--defaults-file is for --source mysql only. Leave it out, or give --source mysql.");
        }

        ElevationModel model = ElevationModel.Open(ldem, resolution, isSparing: true, host);
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
