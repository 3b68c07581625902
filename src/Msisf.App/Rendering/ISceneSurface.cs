using Msisf.App.Preparation;

namespace Msisf.App.Rendering;

/// <summary>The surface of a run as POV-Ray's scenes include it: as meshes in pattern files. Thread-safe.</summary>
internal interface ISceneSurface : IDisposable
{
    /// <summary>The folder of the patterns.</summary>
    string Folder { get; }

    /// <summary>Name of that folder in the pattern repository.</summary>
    string FolderName { get; }

    /// <summary>Number of patterns that were checked or made.</summary>
    int Count { get; }

    /// <summary>Selects what a frame needs.</summary>
    /// <param name="frame">The frame.</param>
    /// <param name="threads">Number of threads that it may use.</param>
    /// <param name="cancellation">Cancels the work.</param>
    ISceneMeshes Select(Frame frame, int threads, CancellationToken cancellation);
}
