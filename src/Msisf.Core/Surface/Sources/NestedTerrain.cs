using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// Several elevation models as one surface: everywhere the finest model that has data, joined without a crack and without a step
/// (docs/surface.md). It is closed if one of them is of the whole Moon; otherwise there is nothing around the maps. The seams are made
/// when the surface is first needed. Safe for several threads.
/// </summary>
public sealed class NestedTerrain : ITerrain, ISurfaceSource, IGround
{
    /// <summary>Maximum number of models.</summary>
    public const int MaxModels = 100;

    private readonly IReadOnlyList<ITerrainGrid?> _drawn;
    private readonly Lazy<NestedParts> _parts;
    private readonly Lazy<SurfaceModel> _surface;
    private readonly ISeamStore? _seams;
    private readonly OutlineFields _fields;

    /// <summary>Takes the models; nothing is read yet.</summary>
    /// <param name="models">Two or more, in any order; of the whole Moon only the coarsest may be.</param>
    /// <param name="seams">Keeps the seams for another time; null to make them each time.</param>
    /// <exception cref="BadInputException">They are not such models.</exception>
    public NestedTerrain(IEnumerable<ITerrainGrid> models, ISeamStore? seams = null)
    {
        Models = [.. models.Order(new ModelOrder())];
        if (Models.Count is < 2 or > MaxModels)
        {
            throw new BadInputException($"{Models.Count} elevation models: 2 to {MaxModels} make a scene of several.");
        }

        if (Models.Skip(1).FirstOrDefault(model => model.IsWholeBody) is { } whole)
        {
            throw new BadInputException(
                $"{whole.ProductId} is of the whole Moon and finer than {Models[0].ProductId}, of which nothing would be seen. "
                    + "Leave that one out.");
        }

        if (Models.FirstOrDefault(model => model.ReferenceRadius != Models[0].ReferenceRadius) is { } other)
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{other.ProductId} has heights over a sphere of {other.ReferenceRadius:R} m, {Models[0].ProductId} over one of "
                    + $"{Models[0].ReferenceRadius:R} m: they are of different bodies. Leave one of them out."));
        }

        _seams = seams;
        _drawn = Models;
        _fields = new OutlineFields(Models);
        _parts = new Lazy<NestedParts>(() => NestedParts.OfAll(Models, _fields));
        _surface = new Lazy<SurfaceModel>(Join);
    }

    /// <summary>The surface of the same models at levels of detail.</summary>
    /// <param name="scene">The models themselves.</param>
    /// <param name="levels">The level of each model; null for one that is left out. The first is there.</param>
    /// <param name="alike">A surface whose first models may be at the same levels: what these have computed is used again.</param>
    internal NestedTerrain(NestedTerrain scene, IReadOnlyList<ITerrainGrid?> levels, NestedTerrain alike)
    {
        Models = [.. scene.Models.Zip(levels, (model, level) => level ?? model)];
        (_seams, _fields) = (scene._seams, scene._fields);
        _drawn = levels;
        _parts = new Lazy<NestedParts>(() => NestedParts.OfLevels(Models, levels, _fields, alike.PartsAt(levels)));
        _surface = new Lazy<SurfaceModel>(Join);
    }

    /// <summary>The models, the coarsest first; a facet's part is an index here.</summary>
    public IReadOnlyList<ITerrainGrid> Models { get; }

    /// <inheritdoc/>
    public IReadOnlyList<ITerrainGrid> Grounds => [.. WholeParts.Select(part => part.Grid)];

    /// <inheritdoc/>
    public double ReferenceRadius => Models[0].ReferenceRadius;

    /// <inheritdoc/>
    public bool IsWholeBody => Models[0].IsWholeBody;

    /// <inheritdoc/>
    public int PartCount => Models.Count;

    /// <inheritdoc/>
    public string ProductId => string.Join('+', Models.Select(model => model.ProductId));

    /// <inheritdoc/>
    public GridResolution Resolution => _drawn.Last(level => level is not null)!.Projection.Resolution;

    /// <inheritdoc/>
    public IReadOnlyList<GridResolution?> DrawnResolutions => [.. _drawn.Select(level => level?.Projection.Resolution)];

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits
    {
        get
        {
            IReadOnlyList<ITerrainGrid> grounds = Grounds;
            return (grounds.Min(grid => grid.RadiusLimits.Min), grounds.Max(grid => grid.RadiusLimits.Max));
        }
    }

    /// <summary>The surface; made at the first request.</summary>
    /// <exception cref="BadInputException">The models can't be joined.</exception>
    internal SurfaceModel Surface => _surface.Value;

    SurfaceModel ISurfaceSource.Surface => Surface;

    IReadOnlyList<GridPatch> ISurfaceSource.WholeParts => WholeParts;

    /// <summary>The models with the cells that the surface has of them; without the seams, which take long.</summary>
    /// <exception cref="BadInputException">Nothing would be seen of a model.</exception>
    internal IReadOnlyList<GridPatch> Parts => _parts.Value.Kept;

    /// <summary>The models with all their cells.</summary>
    internal IReadOnlyList<GridPatch> WholeParts => _parts.Value.Whole;

    /// <summary>
    /// Distance from the Moon's centre to the ground in a direction, of the finest model there, m; in a seam about that of the surface, and
    /// around maps the reference sphere.
    /// </summary>
    internal double GroundRadius(Vector3D direction) => new CoarserGround(WholeParts, ReferenceRadius).RadiusAt(direction);

    /// <summary>Number of models that have the same heights at other levels.</summary>
    internal int CountSame(IReadOnlyList<ITerrainGrid?> levels) => IsSame(levels).Count(same => same);

    /// <summary>Looks at the models now, so that errors are reported before any work.</summary>
    /// <param name="hasLevels">Whether frames are drawn at levels of detail; without them the surface of the models is made too.</param>
    /// <exception cref="BadInputException">The models can't be joined.</exception>
    public void Prepare(bool hasLevels) => _ = hasLevels ? (object)Parts : Surface;

    /// <summary>How far each model but the coarsest is off the coarser ones along its border; null if it lies on none.</summary>
    public IEnumerable<BorderMisfit?> BorderMisfits() => Enumerable.Range(1, Models.Count - 1).Select(part =>
        _fields.MisfitOf(part) is not { } misfit ? (BorderMisfit?)null : misfit with
        {
            BlendedMetres = OutlineField.WidthOf(misfit.Height.Rms, Models[part - 1].Projection.Resolution.MetresPerPixel),
        });

    /// <inheritdoc/>
    public void ReleasePages()
    {
        foreach (ITerrainGrid model in Models)
        {
            model.ReleasePages();
        }
    }

    /// <summary>The models that have the same heights at other levels; null for the others.</summary>
    private GridPatch?[] PartsAt(IReadOnlyList<ITerrainGrid?> levels) =>
        [.. WholeParts.Zip(IsSame(levels), (part, same) => same ? part : null)];

    /// <summary>
    /// Whether a model has the same heights at other levels: it is at the same level, and the same finer models, which change it, are
    /// drawn, at whatever level.
    /// </summary>
    private IEnumerable<bool> IsSame(IReadOnlyList<ITerrainGrid?> levels)
    {
        int coarsest = _drawn.Zip(levels).TakeWhile(pair => ReferenceEquals(pair.First, pair.Second)).Count();
        int finest = Models.Count - 1
            - _drawn.Zip(levels).Reverse().TakeWhile(pair => pair.First is null == pair.Second is null).Count();
        return _drawn.Zip(levels, (own, other) => ReferenceEquals(own, other))
            .Select((same, part) => same && part >= finest && (part < coarsest || !Models[part].MayHaveGaps));
    }

    double IGround.RadiusAt(Vector3D direction) => TerrainHeight.RadiusOn(Parts, () => Surface.Seams, direction) ?? ReferenceRadius;

    private SurfaceModel Join() => new(Parts, SeamBuilder.Join(Parts, _seams, isDelaunay: true));
}
