using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// The models of a surface of several: their heights, of which one goes over into the other along the borders, and the cells that the
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
                string name = parts[part].Grid.ProductId;
                throw new BadInputException(whole[part].WithCells(KeptCells.Of(whole[part], [])).IsLeftOut
                    ? $"{name} has no cell whose samples all have data. Give a file with heights, or leave it out."
                    : $"Nothing of {name} would be seen: finer models cover all of it. Leave it out.");
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
    /// <param name="models">The models, the coarsest first.</param>
    /// <param name="fields">What models get from finer ones.</param>
    public static NestedParts OfAll(IReadOnlyList<ITerrainGrid> models, OutlineFields fields) =>
        new(WholeOf(models, models, fields, new GridPatch?[models.Count]), needsAll: true);

    /// <summary>Takes levels of the models.</summary>
    /// <param name="models">The models, the coarsest first.</param>
    /// <param name="grids">Their levels; null for one that is left out.</param>
    /// <param name="fields">What models get from finer ones.</param>
    /// <param name="known">Parts of a surface that is alike, whose heights and bounds are used; null for others.</param>
    public static NestedParts OfLevels(
        IReadOnlyList<ITerrainGrid> models, IReadOnlyList<ITerrainGrid?> grids, OutlineFields fields,
        IReadOnlyList<GridPatch?> known) => new(WholeOf(models, grids, fields, known), needsAll: false);

    private static List<GridPatch> WholeOf(
        IReadOnlyList<ITerrainGrid> models, IReadOnlyList<ITerrainGrid?> grids, OutlineFields fields, IReadOnlyList<GridPatch?> known)
    {
        bool[] isDrawn = [.. grids.Select(grid => grid is not null)];
        List<GridPatch> whole = [];
        for (int part = 0; part < grids.Count; part++)
        {
            if (known[part] is { } same)
            {
                whole.Add(same);
            }
            else if (grids[part] is not { } grid)
            {
                GridPatch model = new(models[part]);
                whole.Add(model.WithCells(CellMask.NoneOf(model.Mesh)));
            }
            else
            {
                CoarserGround? coarser = grid.IsWholeBody ? null : new CoarserGround(whole, models[0].ReferenceRadius);
                whole.Add(new GridPatch(OutwardBlend.Of(grid, fields.Of(part, isDrawn), coarser)));
            }
        }

        return whole;
    }
}
