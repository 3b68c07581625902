using System.Collections.Concurrent;
using Msisf.Adapters.Tiles;
using Msisf.App.Preparation;
using Msisf.App.Settings;
using Msisf.Core.Camera;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.Core.Tracing;

namespace Msisf.App.Rendering;

/// <summary>The surface of a run as POV-Ray's scenes include it: as meshes in pattern files. Thread-safe.</summary>
internal interface ISceneSurface : IDisposable
{
    string Folder { get; }

    /// <summary>Name of that folder in the pattern repository.</summary>
    string FolderName { get; }

    /// <summary>Number of patterns that were checked or made.</summary>
    int Count { get; }

    ISceneMeshes Select(Frame frame, int threads, CancellationToken cancellation);
}

/// <summary>The meshes that a frame needs.</summary>
internal interface ISceneMeshes
{
    /// <summary>File names of the patterns, without folder, in the order in which they are included.</summary>
    IReadOnlyList<string> FileNames { get; }

    /// <summary>Number of triangles; where a model ends, an upper bound.</summary>
    long Faces { get; }

    /// <summary>Resolution of the finest and of the coarsest level of detail; those of the model if the image shows none.</summary>
    (GridResolution Finest, GridResolution Coarsest) Levels { get; }

    /// <summary>Resolution at which each of several models is drawn; empty for one model.</summary>
    IReadOnlyList<GridResolution?> PartResolutions { get; }

    SceneAxes Axes { get; }

    /// <summary>Resolution of the grid whose cells <see cref="Tracer"/> names; of several models of the finest.</summary>
    GridResolution TracedResolution { get; }

    /// <summary>Traces the rays of the frame's ground truth.</summary>
    ITerrainTracer Tracer { get; }

    /// <summary>Makes the patterns that are missing.</summary>
    /// <returns>Number of patterns that were made.</returns>
    int Ensure(CancellationToken cancellation);

    /// <summary>File names of the patterns that some rows of the image need.</summary>
    IReadOnlyList<string> FileNamesFor(PixelRows rows, CancellationToken cancellation);
}

/// <summary>Makes the surface of a run for POV-Ray.</summary>
internal static class SceneSurfaces
{
    /// <summary>The surface of a run's model.</summary>
    public static ISceneSurface Of(ElevationModel model, RenderSettings settings)
    {
        PatternRepository repository = new(settings.PatternRepository);
        return model.IsWholeMoon && settings.LevelOfDetailError is null
            ? new TileSurface(model, repository)
            : new BlockSurface(model.Grid, model.DetailOf(settings.LevelOfDetailError), settings.DetailSubsamplesPerAxis, repository);
    }
}

/// <summary>The patterns of a run, each checked or made once per run. Thread-safe.</summary>
/// <typeparam name="T">Names a pattern.</typeparam>
internal sealed class ReadyPatterns<T>
    where T : struct
{
    private readonly ConcurrentDictionary<T, bool> _ready = new();

    /// <summary>Number of patterns that were checked or made.</summary>
    public int Count => _ready.Count;

    /// <summary>Makes the patterns that are missing.</summary>
    /// <param name="ensure">Checks or makes those that were not asked for before.</param>
    /// <returns>Number of patterns that were made.</returns>
    public int Ensure(IEnumerable<T> wanted, Func<T[], PatternSet> ensure)
    {
        T[] unknown = [.. wanted.Where(pattern => !_ready.ContainsKey(pattern))];
        if (unknown.Length == 0)
        {
            return 0;
        }

        PatternSet set = ensure(unknown);
        foreach (T pattern in unknown)
        {
            _ready[pattern] = true;
        }

        return set.Written;
    }
}
