using Msisf.Adapters.Tiles;
using Msisf.Core.Blocks;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>A surface as frames show it, at one level of each model, as blocks with their patterns. Thread-safe.</summary>
internal sealed class BlockLevel
{
    private readonly Lazy<TerrainTracer> _tracer;

    /// <param name="models">The models themselves.</param>
    /// <param name="drawn">They at the levels that are drawn.</param>
    /// <param name="repository">The folder of the patterns.</param>
    public BlockLevel(ITerrain models, ITerrain drawn, PatternRepository repository)
    {
        Name = NameOf(ResolutionsOf(models), ResolutionsOf(drawn));
        Resolution = drawn.Resolution;
        PartResolutions = drawn.DrawnResolutions;
        Blocks = new SceneBlocks(drawn);
        Patterns = new BlockPatterns(repository, Blocks, drawn, Name);
        _tracer = new Lazy<TerrainTracer>(() => new TerrainTracer(drawn));
    }

    /// <summary>The level of each model, "x" for one that is left out; empty for the models themselves.</summary>
    public string Name { get; }

    /// <summary>Resolution of the finest model that is drawn.</summary>
    public GridResolution Resolution { get; }

    /// <summary>Of several models the resolution at which each is drawn; null for one that is left out. Empty for one model.</summary>
    public IReadOnlyList<GridResolution?> PartResolutions { get; }

    /// <summary>The facets.</summary>
    public SceneBlocks Blocks { get; }

    /// <summary>Their files.</summary>
    public BlockPatterns Patterns { get; }

    /// <summary>Traces single rays; created on first use.</summary>
    public ITerrainTracer Tracer => _tracer.Value;

    private static IReadOnlyList<GridResolution?> ResolutionsOf(ITerrain terrain) =>
        terrain.DrawnResolutions is { Count: > 0 } several ? several : [terrain.Resolution];

    private static string NameOf(IReadOnlyList<GridResolution?> models, IReadOnlyList<GridResolution?> drawn)
    {
        int?[] levels = [.. models.Zip(drawn, (model, level) => level is { } there ? model!.Value.HalvingsTo(there) : (int?)null)];
        return levels.All(level => level == 0)
            ? string.Empty
            : string.Join('-', levels.Select(level => level?.ToString(CultureInfo.InvariantCulture) ?? "x"));
    }
}
