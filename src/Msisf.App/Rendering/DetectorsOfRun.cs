using Msisf.Core.Camera;
using Msisf.Core.Detector;

namespace Msisf.App.Rendering;

/// <summary>The detector of a run, made for its first frame, which all frames share. Thread-safe.</summary>
internal sealed class DetectorsOfRun(DetectorSettings settings)
{
    private readonly Lock _gate = new();
    private CameraDetector? _detector;

    /// <summary>The detector.</summary>
    /// <param name="camera">A frame's camera; its states do not matter, the rest is the same for all frames.</param>
    /// <param name="threads">Number of threads for making it.</param>
    public CameraDetector Of(ICamera camera, int threads)
    {
        lock (_gate)
        {
            return _detector ??= new CameraDetector(settings, camera, threads);
        }
    }
}
