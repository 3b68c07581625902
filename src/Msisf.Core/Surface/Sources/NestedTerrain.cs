using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// Several elevation models as one surface: everywhere the finest model that has data, joined without a crack and without a step
/// (docs/elevation-seams.md). It is closed if one of them is of the whole Moon; else there is nothing around the maps. The seams are made
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
    /// <param name="blend">Which of two models gives way where they meet.</param>
    /// <exception cref="BadInputException">They are no such models.</exception>
    public NestedTerrain(IEnumerable<ITerrainGrid> models, ISeamStore? seams = null, NestBlend blend = NestBlend.Outward)
    {
        Models = [.. models.Order(new ModelOrder(blend))];
        if (Models.Count is < 2 or > MaxModels)
        {
            throw new BadInputException($"{Models.Count} elevation models: 2 to {MaxModels} make a scene of several.");
        }

        if (blend == NestBlend.Inward && !Models[0].IsWholeBody)
        {
            throw new BadInputException(
                $"{Models[0].ProductId}, the coarsest of several elevation models, is not of the whole Moon: there is no ground to which "
                    + "its border could be bent. Give one that is as well, for instance LDEM_4.");
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
        (Blend, _fields) = (blend, new OutlineFields(Models));
        _parts = new Lazy<NestedParts>(() => NestedParts.OfAll(Models, FieldsIfOutward));
        _surface = new Lazy<SurfaceModel>(Join);
    }

    /// <summary>The surface of the same models at levels of detail.</summary>
    /// <param name="scene">The models themselves.</param>
    /// <param name="levels">The level of each model; null for one that is left out. The first is there.</param>
    /// <param name="alike">A surface whose first models may be at the same levels: what these have computed is used again.</param>
    internal NestedTerrain(NestedTerrain scene, IReadOnlyList<ITerrainGrid?> levels, NestedTerrain alike)
    {
        Models = [.. scene.Models.Zip(levels, (model, level) => level ?? model)];
        (_seams, _fields, Blend) = (scene._seams, scene._fields, scene.Blend);
        _drawn = levels;
        _parts = new Lazy<NestedParts>(() => NestedParts.OfLevels(Models, levels, FieldsIfOutward, alike.PartsAt(levels)));
        _surface = new Lazy<SurfaceModel>(Join);
    }

    /// <summary>The models, the coarsest first; a facet's part is an index here.</summary>
    public IReadOnlyList<ITerrainGrid> Models { get; }

    /// <inheritdoc/>
    public IReadOnlyList<ITerrainGrid> Grounds => Blend == NestBlend.Outward ? [.. WholeParts.Select(part => part.Grid)] : Models;

    /// <summary>Which of two models gives way where they meet.</summary>
    public NestBlend Blend { get; }

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

    /// <summary>Looks at the models now, so that an error is told before any work.</summary>
    /// <param name="hasLevels">Whether frames are drawn at levels of detail; without them the surface of the models is made too.</param>
    /// <exception cref="BadInputException">The models can't be joined.</exception>
    public void Prepare(bool hasLevels) => _ = hasLevels ? (object)Parts : Surface;

    /// <summary>How far each model but the coarsest is off the coarser ones along its border; null if it lies on none.</summary>
    public IEnumerable<BorderMisfit?> BorderMisfits() => Enumerable.Range(1, Models.Count - 1).Select(part =>
        _fields.MisfitOf(part) is not { } misfit ? (BorderMisfit?)null : misfit with
        {
            BlendedMetres = WholeParts[part].Grid is BorderBlend bent
                ? bent.Width * bent.Projection.Resolution.MetresPerPixel
                : OutlineField.WidthOf(misfit.Height.Rms, Models[part - 1].Projection.Resolution.MetresPerPixel),
        });

    /// <inheritdoc/>
    public void ReleasePages()
    {
        foreach (ITerrainGrid model in Models)
        {
            model.ReleasePages();
        }
    }

    private OutlineFields? FieldsIfOutward => Blend == NestBlend.Outward ? _fields : null;

    /// <summary>The models that have the same heights at other levels; null for the others.</summary>
    private GridPatch?[] PartsAt(IReadOnlyList<ITerrainGrid?> levels) =>
        [.. WholeParts.Zip(IsSame(levels), (part, same) => same ? part : null)];

    /// <summary>
    /// Whether a model has the same heights at other levels: it is at the same level, and so are the models that change it. These are the
    /// coarser ones if it is bent to meet them; else finer ones, which count if they are drawn, at whatever level.
    /// </summary>
    private IEnumerable<bool> IsSame(IReadOnlyList<ITerrainGrid?> levels)
    {
        int coarsest = _drawn.Zip(levels).TakeWhile(pair => ReferenceEquals(pair.First, pair.Second)).Count();
        int finest = Models.Count - 1
            - _drawn.Zip(levels).Reverse().TakeWhile(pair => pair.First is null == pair.Second is null).Count();
        return _drawn.Zip(levels, (own, other) => ReferenceEquals(own, other))
            .Select((same, part) => Blend == NestBlend.Inward
                ? part < coarsest
                : same && part >= finest && (part < coarsest || !Models[part].MayHaveGaps));
    }

    double IGround.RadiusAt(Vector3D direction) => TerrainHeight.RadiusOn(Parts, () => Surface.Seams, direction) ?? ReferenceRadius;

    private SurfaceModel Join() => new(Parts, SeamBuilder.Join(Parts, _seams, isDelaunay: Blend == NestBlend.Outward));
}

/// <summary>Which of two models gives way where a finer one meets a coarser one (docs/elevation-seams.md).</summary>
public enum NestBlend
{
    /// <summary>
    /// The coarser one: the finer model keeps its samples to the last, and the difference at its border is carried into the coarser one.
    /// </summary>
    Outward,

    /// <summary>The finer one: along its border it is bent to meet the facets of the coarser one.</summary>
    Inward,
}
