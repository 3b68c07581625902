using System.Collections.Concurrent;
using Msisf.Adapters.Tiles;
using Msisf.Core.Tiles;

namespace Msisf.App.Rendering;

/// <summary>
/// The patterns of a run's scenes: each is checked, or made, once a run, however many frames show it. Safe for several threads.
/// </summary>
internal sealed class ScenePatterns : IDisposable
{
    private readonly ConcurrentDictionary<SurfacePart, bool> _ready = new();
    private readonly PatternRepository _repository;
    private readonly LevelMeshBuilders _builders;

    /// <param name="repository">Where they are; disposed with this.</param>
    /// <param name="builders">Make their meshes.</param>
    public ScenePatterns(PatternRepository repository, LevelMeshBuilders builders)
    {
        _repository = repository;
        _builders = builders;
    }

    public void Dispose() => _repository.Dispose();

    /// <summary>The folder of the patterns.</summary>
    public string Folder => _repository.FolderOf(_builders.PixelsPerDegree);

    /// <summary>How many have been checked or made.</summary>
    public int Count => _ready.Count;

    /// <summary>File name of a part's mesh, without folder.</summary>
    public string FileNameOf(SurfacePart part) => Path.GetFileName(_repository.PathOf(part, _builders.PixelsPerDegree));

    /// <summary>Triangles of some parts.</summary>
    public long CountFaces(IEnumerable<SurfacePart> parts) =>
        parts.Sum(part => (long)TileMesh.CountsOf(TileMeshLayout.For(part, _builders.PixelsPerDegree)).Faces);

    /// <summary>Makes sure that the patterns are there.</summary>
    /// <returns>How many had to be made.</returns>
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
