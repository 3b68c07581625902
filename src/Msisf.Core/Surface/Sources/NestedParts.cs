using Msisf.Core.Errors;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// The models of a surface of several: their heights, which go over into those of coarser ones along the borders, and the cells that the
/// surface has of each.
/// </summary>
internal sealed class NestedParts
{
    private readonly Lazy<IReadOnlyList<GridPatch>> _kept;

    private NestedParts(IReadOnlyList<GridPatch> whole, bool needsAll)
    {
        Whole = whole;
        _kept = new Lazy<IReadOnlyList<GridPatch>>(() => KeptOf(whole, needsAll));
    }

    private static GridPatch[] KeptOf(IReadOnlyList<GridPatch> whole, bool needsAll)
    {
        GridPatch[] parts = new GridPatch[whole.Count];
        for (int part = parts.Length - 1; part >= 0; part--)
        {
            parts[part] = whole[part].IsLeftOut
                ? whole[part]
                : whole[part].WithCells(KeptCells.Of(whole[part], [.. parts[(part + 1)..].Where(finer => !finer.IsLeftOut)]));
            if (parts[part].IsLeftOut && needsAll)
            {
                throw new BadInputException(
                    $"Of {parts[part].Grid.ProductId} nothing would be seen: finer models cover all of it. Leave it out.");
            }
        }

        return parts;
    }

    /// <summary>The models with all their cells, the coarsest first; those that are left out have none.</summary>
    public IReadOnlyList<GridPatch> Whole { get; }

    /// <summary>The models with the cells that finer ones leave.</summary>
    /// <exception cref="BadInputException">Nothing would be seen of a model, and none may be left out.</exception>
    public IReadOnlyList<GridPatch> Kept => _kept.Value;

    /// <summary>Takes all models as they are.</summary>
    public static NestedParts OfAll(IReadOnlyList<ITerrainGrid> models) => new(WholeOf(models, models, [], same: 0), needsAll: true);

    /// <summary>Takes levels of the models.</summary>
    /// <param name="models">The models, the coarsest first.</param>
    /// <param name="grids">Their levels; null for one that is left out.</param>
    /// <param name="alike">The parts of a surface that is alike.</param>
    /// <param name="same">How many of its first parts are the same: their heights and bounds are used.</param>
    public static NestedParts OfLevels(
        IReadOnlyList<ITerrainGrid> models, IReadOnlyList<ITerrainGrid?> grids, IReadOnlyList<GridPatch> alike, int same) =>
        new(WholeOf(models, grids, alike, same), needsAll: false);

    private static List<GridPatch> WholeOf(
        IReadOnlyList<ITerrainGrid> models, IReadOnlyList<ITerrainGrid?> grids, IReadOnlyList<GridPatch> alike, int same)
    {
        List<GridPatch> whole = [.. alike.Take(same)];
        for (int part = same; part < grids.Count; part++)
        {
            if (grids[part] is not { } grid)
            {
                GridPatch model = new(models[part]);
                whole.Add(model.WithCells(CellMask.NoneOf(model.Mesh)));
            }
            else
            {
                whole.Add(part == 0 ? new GridPatch(grid) : new GridPatch(new BorderBlend(grid, new CoarserGround(whole))));
            }
        }

        return whole;
    }
}
