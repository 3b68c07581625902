namespace Msisf.Core.Surface.Sources;

/// <summary>Joins elevation models and generated windows inside each other to one closed surface.</summary>
internal static class RefinedSurface
{
    /// <summary>
    /// Joins them: the coarsest window to the models as a model is joined to coarser ones, each further window to the one around it, on
    /// whose lattice it lies.
    /// </summary>
    /// <param name="models">The models with all their cells, the coarsest first.</param>
    /// <param name="windows">The windows with all their cells, the coarsest first; at least one.</param>
    /// <param name="places">Where the windows lie.</param>
    /// <param name="seams">Keeps what fills the gaps between the models, which other windows leave as they are.</param>
    /// <param name="rings">Keeps the facets between windows.</param>
    public static SurfaceModel Join(
        IReadOnlyList<GridPatch> models, IReadOnlyList<GridPatch> windows, IReadOnlyList<WindowPlace> places, ISeamStore seams,
        WindowRings rings, GroundBrightness brightness)
    {
        GridPatch coarsest = windows[0].WithCells(KeptCells.Of(windows[0], []));
        GridPatch[] parts = [.. models, .. windows];
        for (int part = models.Count - 1; part >= 0; part--)
        {
            parts[part] = models[part].WithCells(KeptCells.Of(models[part], [.. parts[(part + 1)..models.Count], coarsest]));
        }

        List<SeamVertex> between = [];
        for (int window = 0; window + 1 < windows.Count; window++)
        {
            int part = models.Count + window;
            (GridPatch outer, GridPatch inner) = (windows[window], windows[window + 1]);
            CellRange hole = HoleOf(places[window], places[window + 1]);
            between.AddRange(rings.Get(
                new WindowRings.Ring(places[window], places[window + 1], part, IsOuterBlended: window == 0),
                () => new WindowSeam(outer, part, inner, part + 1).Fill(hole)));
            parts[part] = windows[window].WithCells(Without(windows[window], hole));
        }

        return new SurfaceModel(parts, SeamBuilder.Join([.. parts[..models.Count], coarsest], seams, more: between))
        {
            Brightness = brightness,
        };
    }

    /// <summary>The cells of a window that the next finer one and the ring around that take, from the window's first ones.</summary>
    private static CellRange HoleOf(WindowPlace outer, WindowPlace inner) => new(
        (inner.Cells.FirstLine / 2) - 1 - outer.Cells.FirstLine,
        (inner.Cells.EndLine / 2) + 1 - outer.Cells.FirstLine,
        (inner.Cells.FirstSample / 2) - 1 - outer.Cells.FirstSample,
        (inner.Cells.EndSample / 2) + 1 - outer.Cells.FirstSample);

    private static CellMask Without(GridPatch window, CellRange hole)
    {
        CellMask mask = new(window.Mesh);
        for (int row = 0; row < mask.BlockRows; row++)
        {
            for (int column = 0; column < mask.BlockColumns; column++)
            {
                CellRange block = new CellBlock(row, column).Cells(window.Mesh);
                CellRange gone = new(
                    Math.Max(block.FirstLine, hole.FirstLine), Math.Min(block.EndLine, hole.EndLine),
                    Math.Max(block.FirstSample, hole.FirstSample), Math.Min(block.EndSample, hole.EndSample));
                if (gone == block)
                {
                    mask.RemoveBlock(row, column);
                    continue;
                }

                for (int line = gone.FirstLine; line < gone.EndLine; line++)
                {
                    for (int sample = gone.FirstSample; sample < gone.EndSample; sample++)
                    {
                        mask.Remove(line, sample);
                    }
                }
            }
        }

        mask.Seal();
        return mask;
    }
}
