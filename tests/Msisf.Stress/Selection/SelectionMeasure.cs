using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;
using Msisf.Core.Tiles.Selection;

namespace Msisf.Stress.Selection;

/// <summary>The tiles that the selection keeps, against images by rays through every facet.</summary>
/// <param name="moon">The Moon.</param>
/// <param name="selection">Selects its tiles.</param>
/// <param name="firstCamera">Number of the first of its <see cref="CameraCases"/>.</param>
internal sealed class SelectionMeasure(JudgedMoon moon, Dspsa selection, int firstCamera) : IMeasure<SelectionMeasure>
{
    /// <summary>Of each image, about.</summary>
    private const int Pixels = 600;

    private readonly CaseCount _differences = new();
    private readonly CaseCount _missed = new();
    private long _pixels;
    private long _lit;
    private long _kept;

    /// <summary>The worst of each quantity.</summary>
    public IEnumerable<StressFigure> Figures =>
    [
        _differences.ToFigure($"{moon.Grid.ProductId}: pixels that differ from the image with all tiles", string.Empty, 0.0),
        _missed.ToFigure(
            $"{moon.Grid.ProductId}: tiles that a pixel's ray meets and that are missed, light at the camera", string.Empty, 0.0),
        new StressFigure($"{moon.Grid.ProductId}: pixels compared", "pixels", _pixels, null, $"{_lit} lit, {_kept} tiles kept in all"),
    ];

    /// <inheritdoc/>
    public void Try(int number, CaseRandom random)
    {
        (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(firstCamera + number, moon.Grid, Pixels);
        TileSelection tiles = selection.Select(camera, sun);
        BruteForceImage whole = new(moon.Facets, camera, sun, isThere: null);
        BruteForceImage selected = new(moon.Facets, camera, sun, TilesThere.In(tiles));
        string Text() => $"CameraCases {firstCamera + number} ({kind})";
        _differences.Note(whole.DifferencesFrom(selected), camera.Width * camera.Height, Text);

        bool[] isKept = TilesThere.In(selection.Select(camera, null));
        _missed.Note(isKept.Zip(whole.HitTiles).Count(tile => tile.Second && !tile.First), whole.HitTiles.Count(isHit => isHit), Text);

        _pixels += camera.Width * camera.Height;
        _lit += whole.Lit;
        _kept += tiles.Kept.Count;
    }

    /// <inheritdoc/>
    public void Add(SelectionMeasure other)
    {
        _differences.Add(other._differences);
        _missed.Add(other._missed);
        _pixels += other._pixels;
        _lit += other._lit;
        _kept += other._kept;
    }
}
