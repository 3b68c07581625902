using Msisf.Core.Camera;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>The buffers with which one thread draws the further samples of bands.</summary>
internal sealed class SubsampleWorker
{
    private readonly ProjectedBlock _block = new();
    private readonly SubsampleCells _cells = new();
    private readonly SubsampleBand _band = new();
    private readonly List<VisibleBlock> _touching = [];

    /// <summary>Draws the further samples of a band and finds the parts of its pixels.</summary>
    /// <param name="frame">The frame, drawn with one sample a pixel at the pixels' centres.</param>
    /// <param name="pixels">The pixels that get samples.</param>
    /// <param name="band">The band; with samples.</param>
    /// <param name="parts">Receives the parts.</param>
    /// <param name="merged">Receives the parts without regard to borders of shadows; null if nobody wants them.</param>
    /// <param name="pieces">Knows parts that need no receivers for their samples; null for none.</param>
    /// <param name="samples">All samples of the frame's lens, if they are known.</param>
    public void Draw(
        SurfaceModel surface, VisibilityPass frame, SampledPixels pixels, SampledBand band, PixelParts parts, PixelParts? merged = null,
        IPieces? pieces = null, LensSubsamples? samples = null)
    {
        ImageView view = frame.View;
        _band.Begin(pixels, view.Camera.Model, band);
        if (frame.Lens is { } lens)
        {
            DrawLens(surface, view, lens, samples, frame.Blocks);
        }
        else
        {
            DrawPinhole(surface, view, frame.Blocks);
        }

        parts.Take(_band, view.Camera.Model, mayBeSplit: true, pieces);
        merged?.Take(_band, view.Camera.Model, mayBeSplit: false);
    }

    private void DrawPinhole(SurfaceModel surface, ImageView view, IReadOnlyList<VisibleBlock> blocks)
    {
        _cells.Begin(view);
        foreach (VisibleBlock visible in blocks)
        {
            if (visible.Rows.First <= _band.LastRow && visible.Rows.End > _band.FirstRow)
            {
                _block.Read(surface, visible.Block, view);
                _block.Project(view);
                _cells.Draw(_block, _band);
            }
        }
    }

    private void DrawLens(
        SurfaceModel surface, ImageView view, LensSamples lens, LensSubsamples? samples, IReadOnlyList<VisibleBlock> blocks)
    {
        TangentBox tangents = _band.PlaceInLens(view.Camera.Model, samples);
        _touching.Clear();
        double width = 0.0;
        foreach (VisibleBlock visible in blocks)
        {
            if (visible.Tangents.Meets(tangents))
            {
                _touching.Add(visible);
                width += Math.Sqrt(Math.Max(0.0, visible.Tangents.Area));
            }
        }

        double cell = width * view.PixelsPerTangent / (_touching.Count * CellBlock.Size);
        LensTile[] tiles =
        [
            .. lens.TilesOf(_band.FirstRow / VisibleSurface.BandRows, cell).Select(_band.Place).Where(tile => !tile.Pixels.IsEmpty),
        ];
        ImageView[] views = [.. tiles.Select(tile => new ImageView(view.Camera, lens, tile))];
        foreach (VisibleBlock visible in _touching)
        {
            _block.Read(surface, visible.Block, view);
            for (int tile = 0; tile < views.Length; tile++)
            {
                if (visible.Tangents.Meets(tiles[tile].Tangents))
                {
                    _band.Narrow(tiles[tile]);
                    _cells.Begin(views[tile]);
                    _block.Project(views[tile]);
                    _cells.Draw(_block, _band);
                }
            }
        }
    }
}
