using Msisf.Adapters.Raster.Heights;
using Msisf.Adapters.Synthesis;
using Msisf.App.Host;
using Msisf.App.Settings;
using Msisf.App.Settings.Specs;
using Msisf.Core.Camera;
using Msisf.Core.Lod;
using Msisf.Core.Metadata;
using Msisf.Core.Surface;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;
using Msisf.Core.Tiles.Selection;
using Msisf.Core.Tracing;

namespace Msisf.App.Preparation;

/// <summary>The elevation model of a run and the data derived from it, each computed once. Thread-safe.</summary>
internal sealed class ElevationModel : IDisposable
{
    private readonly IReadOnlyList<IDisposable> _files;
    private readonly IGlobalGrid? _moon;
    private readonly Lazy<Dspsa> _selection;
    private readonly Lazy<TerrainTracer> _tracer;
    private readonly Lazy<ModelLevels> _levels;
    private readonly Func<double?, IFrameTerrain> _detailOf;
    private readonly IReadOnlyList<BorderMisfit?> _misfits = [];
    private readonly IReadOnlyList<PartMove?> _moves = [];

    /// <summary>A model of the whole Moon.</summary>
    internal ElevationModel(IGlobalGrid moon, LdemSet set, IDisposable file, Func<ModelLevels> openLevels)
        : this(moon, [set], [file])
    {
        _moon = moon;
        _selection = new Lazy<Dspsa>(() => new Dspsa(moon));
        _levels = new Lazy<ModelLevels>(openLevels);
        _detailOf = error => error is double pixels ? new ModelDetail(Levels, pixels) : new FullDetail(moon);
    }

    internal ElevationModel(ITerrainGrid grid, LdemSet set, IDisposable file)
        : this(grid, [set], [file])
    {
        Lazy<MapLevels> levels = new(() => MapLevels.Open(grid));
        _detailOf = error => error is double pixels ? new ModelDetail(levels.Value, pixels) : new FullDetail(grid);
    }

    private ElevationModel(ITerrain grid, IReadOnlyList<LdemSet> sets, IReadOnlyList<IDisposable> files)
    {
        Grid = grid;
        Sets = sets;
        _files = files;
        _tracer = new Lazy<TerrainTracer>(() => new TerrainTracer(grid));
        _selection = new Lazy<Dspsa>(() => throw NotWholeMoon());
        _levels = new Lazy<ModelLevels>(() => throw NotWholeMoon());
        _detailOf = _ => new FullDetail(grid);
    }

    internal ElevationModel(NestedTerrain nested, IReadOnlyList<BorderMisfit?> misfits, IReadOnlyList<ElevationModel> models)
        : this(nested, [.. models.Select(model => model.Set)], models)
    {
        (_misfits, _moves) = (misfits, [.. models.Select(model => model.Moved)]);
        Lazy<NestedLevels> levels = new(() => new NestedLevels(nested, [.. models.Select(model => model.LevelsInScene(models.Count))]));
        _detailOf = error => error is double pixels ? new SceneDetail(levels.Value, pixels) : new FullDetail(nested);
    }

    private ElevationModel(RefinedTerrain refined, ElevationModel model, IReadOnlyList<ElevationModel> closed)
        : this((ITerrain)refined, model.Sets, closed) =>
        (_detailOf, _misfits, _moves) = (_ => new RefinedDetail(refined), model._misfits, model._moves);

    /// <summary>How far the user moved it; null if not at all.</summary>
    public PartMove? Moved { get; private init; }

    /// <summary>The samples; of several models the surface that they make together.</summary>
    public ITerrain Grid { get; }

    /// <summary>Whether it is a model of the whole Moon, which has tiles and patterns.</summary>
    public bool IsWholeMoon => _moon is not null;

    /// <summary>The samples of a model of the whole Moon.</summary>
    /// <exception cref="UsageException">It is a map of a part.</exception>
    public IGlobalGrid WholeMoon => _moon ?? throw NotWholeMoon();

    /// <summary>Identifies the model; the fingerprint is the same on every computer.</summary>
    public LdemFingerprint Fingerprint() => LdemFingerprint.Of(Sets);

    /// <summary>The labels of the model; of several models those of the coarsest.</summary>
    public LdemSet Set => Sets[0];

    /// <summary>The labels of all models, in the order of a facet's parts.</summary>
    public IReadOnlyList<LdemSet> Sets { get; }

    /// <summary>Whether any model is synthetic, not the real Moon.</summary>
    public bool IsSynthetic => Sets.Any(set => set.IsSynthetic);

    /// <summary>
    /// Names and resolutions of several models, in the order of a facet's parts; empty for one. With invented detail also of one, and of
    /// the windows of it.
    /// </summary>
    /// <param name="drawn">The resolution at which each is drawn; null for one that is left out.</param>
    public IReadOnlyList<ElevationPart> PartsAt(IReadOnlyList<GridResolution?> drawn) => Grid.PartCount == 1 ? [] :
    [
        .. Grid.Models.Select((grid, part) => new ElevationPart(
            grid.ProductId, Sets[part].IsSynthetic, grid.Projection.Resolution, drawn[part])
        {
            Moved = part < _moves.Count ? _moves[part] : null,
            Misfit = part > 0 && part <= _misfits.Count && _misfits[part - 1] is { } misfit ? PartMisfit.Of(misfit) : null,
        }),
        .. drawn.Skip(Sets.Count).Select(window => new ElevationPart(Grid.InventedName!, IsSynthetic: true, window!.Value, window)),
    ];

    /// <summary>Traces single rays; created on first use.</summary>
    public TerrainTracer Tracer => _tracer.Value;

    /// <summary>A model of the whole Moon and its coarser levels of detail; opened on first use.</summary>
    public LodLevels Levels => _levels.Value.Levels;

    /// <summary>What frames show of the model, or of several; levels of detail are opened at the first frame.</summary>
    /// <param name="errorPixels">
    /// px: how far coarser levels may shift a point in the image; null to draw from the full model always.
    /// </param>
    public IFrameTerrain DetailOf(double? errorPixels) => _detailOf(errorPixels);

    /// <summary>
    /// The model and its levels as a part of a scene: they share the memory, and leave places without data to coarser models.
    /// </summary>
    private TerrainLevels LevelsInScene(int models) => IsWholeMoon
        ? Levels
        : MapLevels.Open((ITerrainGrid)Grid, TerrainLevels.DefaultCacheBytes / models, keepsGaps: true);

    /// <summary>The same map at another place, with which this is closed.</summary>
    /// <param name="grid">The samples there.</param>
    /// <param name="moved">How far it was moved in all.</param>
    public ElevationModel At(ITerrainGrid grid, PartMove moved) => new(grid, Set, this) { Moved = moved };

    /// <summary>The same model with invented detail.</summary>
    /// <param name="detail">What is invented.</param>
    /// <param name="isClosedWithIt">Whether this model is closed with the refined one, also if this fails.</param>
    /// <exception cref="BadInputException">It is a map of a part of the Moon.</exception>
    public ElevationModel Refined(RefineSettings detail, ProgramHost host, bool isClosedWithIt = true)
    {
        try
        {
            return SurfaceOptions.Ldem.NamedInErrors(() =>
            {
                IGroundDetail ground = InventedGround.Of(detail.Seed, RefinedTerrain.RequireWhole(Grid).Grounds);
                RefinedTerrain terrain = new(Grid, ground, detail.FinestLevel);
                host.Log.Note(Invariant(
                    $"Detail: INVENTED below the resolution of {Grid.ProductId}, from seed {detail.Seed}, in cells of {detail.Cell:R} m "
                        + $"and wider; it is not on the real Moon."));
                return new ElevationModel(terrain, this, isClosedWithIt ? [this] : []);
            });
        }
        catch
        {
            if (isClosedWithIt)
            {
                Dispose();
            }

            throw;
        }
    }

    /// <summary>The tiles that a frame needs, with reasons.</summary>
    public TileSelection Select(Frame frame, int threads, CancellationToken cancellation) => _selection.Value.Select(
        frame.Camera, frame.Light.IsSun ? frame.Light.PositionBodyFixed : null, threads, cancellation);

    /// <summary>Distance from the Moon's centre to the terrain in a direction, m; around a map that to the reference sphere.</summary>
    public double GroundRadius(Vector3D directionBodyFixed) => TerrainHeight.RadiusBelow(Grid, directionBodyFixed);

    /// <summary>How far a position lies below the terrain, m; 0 or less if it is above.</summary>
    public double DepthBelowGround(Vector3D positionBodyFixed) =>
        positionBodyFixed.Length > GroundLimit ? 0.0 : -HeightOverTerrain(positionBodyFixed);

    /// <summary>m: no ground is higher; around a map it is the reference sphere.</summary>
    private double GroundLimit => IsWholeMoon ? Grid.RadiusLimits.Max : Math.Max(Grid.RadiusLimits.Max, Grid.ReferenceRadius);

    /// <summary>Height of a position over the surface of the model below it, m.</summary>
    public double HeightOverTerrain(Vector3D positionBodyFixed) =>
        positionBodyFixed.Length - GroundRadius(positionBodyFixed);

    public void Dispose()
    {
        if (_levels.IsValueCreated)
        {
            _levels.Value.Dispose();
        }

        foreach (IDisposable file in _files)
        {
            file.Dispose();
        }
    }

    private UsageException NotWholeMoon() => new(
        $"{Set.Location}: only one model of the whole Moon has tiles; a map of a part of it, or several models, have none. Take such a "
            + $"model for them.");
}
