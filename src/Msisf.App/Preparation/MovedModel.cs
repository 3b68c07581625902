using Msisf.Adapters.Raster.Heights;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Metadata;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.App.Preparation;

/// <summary>Moves elevation models as the user says: up or down, and over the ground.</summary>
internal static class MovedModel
{
    /// <summary>m: farther off is not a datum, but another place.</summary>
    private const double MaxShift = 100_000.0;

    /// <summary>A model where its path says that it is.</summary>
    /// <param name="path">The path with its options.</param>
    /// <param name="model">The model, which is closed with the result, also if this fails.</param>
    /// <exception cref="MsisfException">It can't be moved so.</exception>
    public static ElevationModel Of(ModelPath path, ElevationModel model)
    {
        if (path is { Heights.IsEmpty: true, Placement: (false, 0.0, 0.0) })
        {
            return model;
        }

        try
        {
            bool hasOffset = RasterOf(model.Grid) is not null; // its values became heights with the offset
            double offset = path.Heights.Offset ?? 0.0;
            Check(path, model, hasOffset);
            if (model.IsWholeMoon)
            {
                return model;
            }

            ITerrainGrid grid = (ITerrainGrid)model.Grid;
            grid = hasOffset || offset == 0.0 ? grid : new OffsetGrid(grid, offset);
            grid = path.Placement.IsShifted
                ? SurfaceOptions.Ldem.NamedInErrors(() => ShiftedGrid.Of(grid, path.Placement.East, path.Placement.North))
                : grid;
            return model.At(grid, new PartMove(offset, path.Placement.East, path.Placement.North));
        }
        catch
        {
            model.Dispose();
            throw;
        }
    }

    /// <summary>Raises the models that are to meet those around them by what makes them do so in the mean.</summary>
    /// <param name="models">The models, which are replaced.</param>
    /// <param name="paths">Their paths with options.</param>
    /// <param name="log">Is told by how much.</param>
    public static void MeetBorders(List<ElevationModel> models, IReadOnlyList<string> paths, ILog log)
    {
        HashSet<ITerrainGrid> wanted = [.. models.Where((_, index) => ModelPath.Parse(paths[index]).Placement.MeetsBorder)
            .Select(model => (ITerrainGrid)model.Grid)];
        if (wanted.Count == 0)
        {
            return;
        }

        IReadOnlyList<double> offsets = AutomaticOffset.Of([.. models.Select(model => (ITerrainGrid)model.Grid)], wanted.Contains);
        for (int i = 0; i < models.Count; i++)
        {
            ElevationModel model = models[i];
            if (wanted.Contains((ITerrainGrid)model.Grid))
            {
                PartMove moved = model.Moved ?? default;
                models[i] = model.At(
                    new OffsetGrid((ITerrainGrid)model.Grid, offsets[i]), moved with { Offset = moved.Offset + offsets[i] });
                log.Note(Invariant(
                    $"{model.Grid.ProductId} is raised by {offsets[i]:F2} m (offset=auto), so that it meets the ground along its border "
                        + $"in the mean."));
            }
        }
    }

    private static void Check(ModelPath path, ElevationModel model, bool hasOffset)
    {
        if (path.Heights.Scale is not null && !hasOffset)
        {
            throw Wrong(path, "the label of a PDS3 model says what its values mean; scale= is for other rasters. Leave it out.");
        }

        if (path.Heights.HoldsMeans is not null && !hasOffset)
        {
            throw Wrong(path, "the product of a PDS3 model says what its values are; values= is for other rasters. Leave it out.");
        }

        if (model.IsWholeMoon && (!hasOffset || path.Placement != default))
        {
            throw Wrong(
                path, "a model of the whole Moon is what others are joined to, and is not moved. Move the others the other way.");
        }

        if (!hasOffset && Math.Abs(path.Heights.Offset ?? 0.0) > MoonConstants.MaxRelief)
        {
            throw Wrong(path, Invariant(
                $"offset={path.Heights.Offset:R} is more than {MoonConstants.MaxRelief:R} m, by which the Moon's ground is off its sphere. "
                    + $"Give a smaller one."));
        }

        if (double.Hypot(path.Placement.East, path.Placement.North) > MaxShift)
        {
            throw Wrong(path, Invariant($"shift= is at most {MaxShift / 1000.0:R} km: farther off is another place."));
        }
    }

    /// <summary>The raster whose samples a model has; null of a PDS3 model.</summary>
    internal static GeoTiffGrid? RasterOf(ITerrain grid) => grid as GeoTiffGrid ?? (grid as ChangedGrid)?.Source as GeoTiffGrid;

    private static UsageException Wrong(ModelPath path, string what) =>
        SurfaceOptions.Ldem.Wrong($"{path.Path}: {what}");
}
