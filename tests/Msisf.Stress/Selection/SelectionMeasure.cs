using Msisf.Core.Camera;
using Msisf.Core.Numerics;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tiles;

namespace Msisf.Stress.Selection;

/// <summary>The tiles that the selection keeps, against pictures by rays through every facet.</summary>
/// <param name="moon">The Moon.</param>
/// <param name="summary">What the selection goes by.</param>
/// <param name="firstCamera">Number of the first of its <see cref="CameraCases"/>.</param>
internal sealed class SelectionMeasure(JudgedMoon moon, ElevationSummary summary, int firstCamera) : IMeasure<SelectionMeasure>
{
    /// <summary>Of each picture, about.</summary>
    private const int Pixels = 600;

    private readonly FigureBuilder _differences = new($"{moon.Grid.ProductId}: pixels that differ from the picture with all tiles", string.Empty, 0.0);
    private readonly FigureBuilder _missed = new($"{moon.Grid.ProductId}: tiles that a pixel's ray meets and that are missed, light at the camera", string.Empty, 0.0);
    private long _pixels;
    private long _lit;
    private long _kept;

    /// <inheritdoc/>
    public IEnumerable<StressFigure> Figures =>
    [
        _differences.ToFigure(),
        _missed.ToFigure(),
        new StressFigure($"{moon.Grid.ProductId}: pixels compared", "pixels", _pixels, null, $"{_lit} lit, {_kept} tiles kept in all"),
    ];

    /// <inheritdoc/>
    public IEnumerable<StressSeries> Series => [];

    /// <inheritdoc/>
    public void Try(int number, Random random)
    {
        (PinholeCamera camera, Vector3D sun, string kind) = CameraCases.Make(firstCamera + number, moon.Grid, Pixels);
        TileSelection selection = Dspsa.Select(camera, sun, moon.Grid, summary);
        BruteForcePicture whole = new(moon.Facets, camera, sun, isThere: null);
        BruteForcePicture selected = new(moon.Facets, camera, sun, TilesThere.In(selection));
        string Text() => $"CameraCases {firstCamera + number} ({kind})";
        for (int pixel = whole.DifferencesFrom(selected); pixel > 0; pixel--)
        {
            _differences.Count(Text);
        }

        bool[] isKept = TilesThere.In(Dspsa.Select(camera, null, moon.Grid, summary));
        for (int missed = isKept.Zip(whole.HitTiles).Count(tile => tile.Second && !tile.First); missed > 0; missed--)
        {
            _missed.Count(Text);
        }

        _pixels += camera.Width * camera.Height;
        _lit += whole.Lit;
        _kept += selection.Kept.Count;
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
