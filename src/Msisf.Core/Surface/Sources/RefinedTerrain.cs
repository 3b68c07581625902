using Msisf.Core.Camera;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// Elevation models with invented detail below their resolution, of which each frame shows as much as its pixels need
/// (docs/invented-detail.md). Safe for several threads; a view does not depend on those before it.
/// </summary>
public sealed class RefinedTerrain : ITerrain, IGround
{
    /// <summary>log2 of m: the narrowest cells; the vertices' lattice would be too fine for exact signs with narrower ones.</summary>
    public const int LeastLevel = -5;

    /// <summary>Views that are kept; frames near each other share one.</summary>
    private const int KeptViews = 2;

    /// <summary>
    /// Windows that are kept with their bounds, some more than a view has: those of views near each other are mostly the same.
    /// </summary>
    private const int KeptWindows = 20;

    /// <summary>96 MiB of heights, which is what the windows of one view can have, and as many factors of the reflectance.</summary>
    private const int HeightBytes = 96 << 20;
    private const int BrightnessBytes = HeightBytes / 8;

    private readonly ITerrain _models;
    private readonly IGroundDetail _detail;
    private readonly int _finestLevel;
    private readonly DetailTiles<double> _tiles;
    private readonly DetailTiles<float> _brightness;
    private readonly WindowPlan _plan;
    private readonly SeamMemory _seams = new();
    private readonly WindowRings _rings = new();
    private readonly Lock _joining = new();
    private readonly Lazy<IReadOnlyList<GridPatch>> _whole;
    private readonly Lock _gate = new();
    private readonly LinkedList<RefinedView> _views = [];
    private readonly LinkedList<(WindowPlace Place, bool IsCoarsest, GridPatch Surface)> _windows = [];

    /// <summary>Takes models and their ground; nothing is read yet.</summary>
    /// <param name="models">A model of the whole Moon, or several.</param>
    /// <param name="finestLevel">Cells are 2^this m wide at least.</param>
    /// <exception cref="BadInputException">It is a map of a part of the Moon.</exception>
    public RefinedTerrain(ITerrain models, IGroundDetail detail, int finestLevel)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(finestLevel, LeastLevel);
        (_models, _detail, _finestLevel) = (models, detail, finestLevel);
        _tiles = new DetailTiles<double>(HeightBytes, detail.ReadRadii);
        _brightness = new DetailTiles<float>(BrightnessBytes, detail.ReadBrightness);
        _whole = new Lazy<IReadOnlyList<GridPatch>>(() => SurfaceModel.WholePartsOf(models));
        _plan = new WindowPlan(detail, RequireWhole(models).Models, finestLevel);
    }

    /// <inheritdoc/>
    public string ProductId => _models.ProductId;

    /// <inheritdoc/>
    public GridResolution Resolution => _models.Resolution;

    /// <inheritdoc/>
    public double ReferenceRadius => _models.ReferenceRadius;

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits => _detail.RadiusLimits;

    /// <summary>Number of models, and 1 for the generated ground, of which a view may show several windows or none.</summary>
    public int PartCount => _models.PartCount + 1;

    /// <inheritdoc/>
    public IReadOnlyList<ITerrainGrid> Models => _models.Models;

    /// <inheritdoc/>
    public string? InventedName => _detail.Name;

    /// <summary>The models with all their cells, the coarsest first.</summary>
    internal IReadOnlyList<GridPatch> WholeParts => _whole.Value;

    /// <summary>Refuses models in which no detail can be invented.</summary>
    /// <exception cref="BadInputException">It is a map of a part of the Moon.</exception>
    public static ITerrain RequireWhole(ITerrain terrain) => terrain.IsWholeBody
        ? terrain
        : throw new BadInputException(
            $"{terrain.ProductId} is a map of a part of the Moon. Detail is invented in models of the whole Moon, and in such maps inside "
                + "one: give one as well, for instance LDEM_4.");

    /// <summary>The surface that a camera sees.</summary>
    /// <param name="subsamplesPerAxis">Samples along a pixel's edge.</param>
    public RefinedView For(ICamera camera, int subsamplesPerAxis)
    {
        IReadOnlyList<WindowPlace> places = _plan.Of(camera, subsamplesPerAxis);
        lock (_gate)
        {
            RefinedView view = _views.FirstOrDefault(known => known.Places.SequenceEqual(places))
                ?? new RefinedView(this, _models, places, () => Join(places));
            _views.Remove(view);
            _views.AddFirst(view);
            if (_views.Count > KeptViews)
            {
                _views.RemoveLast();
            }

            return view;
        }
    }

    /// <inheritdoc/>
    public void ReleasePages() => _models.ReleasePages();

    /// <summary>With all its detail.</summary>
    double IGround.RadiusAt(Vector3D direction) => _detail.RadiusAt(direction, Math.ScaleB(1.0, _finestLevel));

    private SurfaceModel Join(IReadOnlyList<WindowPlace> places)
    {
        if (places.Count == 0)
        {
            return SurfaceModel.Of(_models);
        }

        GridPatch[] windows = [.. places.Select((place, index) => WindowAt(place, index == 0))];
        lock (_joining)
        {
            return RefinedSurface.Join(WholeParts, windows, places, _seams, _rings, new GroundBrightness(_brightness, places));
        }
    }

    /// <summary>A window; the coarsest goes over into the models along its border, as a model into coarser ones.</summary>
    private GridPatch WindowAt(WindowPlace place, bool isCoarsest)
    {
        lock (_gate)
        {
            var known = _windows.FirstOrDefault(window => window.Place == place && window.IsCoarsest == isCoarsest);
            if (known.Surface is not null)
            {
                _windows.Remove(known);
            }
            else
            {
                DetailWindow window = new(_detail, _tiles, place);
                known = (place, isCoarsest, new GridPatch(
                    isCoarsest ? new BorderBlend(window, new CoarserGround(WholeParts, ReferenceRadius)) : window));
            }

            _windows.AddFirst(known);
            if (_windows.Count > KeptWindows)
            {
                _windows.RemoveLast();
            }

            return known.Surface;
        }
    }
}
