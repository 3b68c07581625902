using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Where lenses are sampled, computed once for each camera and pattern of samples and shared by all frames. Safe for several threads.
/// </summary>
/// <param name="maxSamples">Samples that are kept, of 16 bytes each.</param>
internal sealed class LensCache(long maxSamples = LensCache.DefaultMaxSamples)
{
    /// <summary>Centre and nine samples of each pixel of 1024 x 1024 px and of their margin for a point spread function.</summary>
    private const long DefaultMaxSamples = 11_000_000;

    private readonly Lock _gate = new();
    private readonly List<LensSamples> _kept = [];

    /// <summary>Finds the samples of a camera, or computes them if there is room.</summary>
    /// <param name="model">The camera, with a lens.</param>
    /// <param name="pattern">Where the samples of a pixel lie.</param>
    /// <param name="threads">Maximum number of threads; the samples do not depend on it.</param>
    /// <returns>Null if there is no room for them, even without the samples of all other cameras.</returns>
    public LensSamples? Find(CameraModel model, SamplePattern pattern, int threads, CancellationToken cancellation)
    {
        lock (_gate)
        {
            if (_kept.Find(samples => samples.IsOf(model, pattern)) is { } known)
            {
                return known;
            }

            long room = maxSamples - ((long)model.Width * model.Height * pattern.Count);
            if (_kept.Where(samples => samples.IsOf(model)).Sum(Count) > room)
            {
                return null;
            }

            if (_kept.Sum(Count) > room)
            {
                // Frames that are being drawn keep theirs until they are finished.
                _kept.RemoveAll(samples => !samples.IsOf(model));
            }

            LensSamples found = new();
            found.Prepare(model, pattern, threads, cancellation);
            _kept.Add(found);
            return found;
        }
    }

    private static long Count(LensSamples samples) => samples.Right.Length;
}
