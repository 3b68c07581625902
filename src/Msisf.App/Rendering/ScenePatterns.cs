using System.Collections.Concurrent;
using Msisf.Adapters.Tiles;
using Msisf.Core.Tiles;

namespace Msisf.App.Rendering;

/// <summary>The patterns of a run's scenes, each checked or made once per run. Thread-safe.</summary>
internal sealed class ScenePatterns : IDisposable
{
    private readonly ConcurrentDictionary<SurfacePart, bool> _ready = new();
    private readonly PatternRepository _repository;
    private readonly LevelMeshBuilders _builders;

    /// <param name="repository">The folder of the patterns; disposed with this object.</param>
    /// <param name="builders">The builders of the meshes.</param>
    public ScenePatterns(PatternRepository repository, LevelMeshBuilders builders)
    {
        _repository = repository;
        _builders = builders;
    }

    public void Dispose() => _repository.Dispose();

    /// <summary>The folder of the patterns.</summary>
    public string Folder => _repository.FolderOf(_builders.PixelsPerDegree);

    /// <summary>Number of patterns that were checked or made.</summary>
    public int Count => _ready.Count;

    /// <summary>File name of a part's mesh, without folder.</summary>
    public string FileNameOf(SurfacePart part) => Path.GetFileName(_repository.PathOf(part, _builders.PixelsPerDegree));

    /// <summary>Counts the triangles of surface parts.</summary>
    public long CountFaces(IEnumerable<SurfacePart> parts) =>
        parts.Sum(part => (long)TileMesh.CountsOf(TileMeshLayout.For(part, _builders.PixelsPerDegree)).Faces);

    /// <summary>Makes the patterns that are missing.</summary>
    /// <returns>Number of patterns that were made.</returns>
    public int Ensure(IEnumerable<SurfacePart> parts, CancellationToken cancellation)
    {
        SurfacePart[] unknown = [.. parts.Where(part => !_ready.ContainsKey(part))];
        if (unknown.Length == 0)
        {
            return 0;
        }

        PatternSet set = _repository.EnsureParts(unknown, _builders, Environment.ProcessorCount, cancellation);
        foreach (SurfacePart part in unknown)
        {
            _ready[part] = true;
        }

        return set.Written;
    }
}
