using Msisf.Core.Camera;

namespace Msisf.Core.Render.Visibility;

/// <summary>
/// Where lenses are sampled, computed once for each camera and pattern of samples and shared by all frames. Safe for several threads.
/// </summary>
/// <param name="maxBytes">Memory of the samples that are kept.</param>
internal sealed class LensCache(long maxBytes = LensCache.DefaultMaxBytes)
{
    /// <summary>Centre and 16 samples of each pixel of 1024 x 1024 px and of their margin for a point spread function.</summary>
    private const long DefaultMaxBytes = 176_000_000;

    private readonly Lock _gate = new();
    private readonly List<Kept> _kept = [];

    /// <summary>Finds the samples of a camera at its pixels' centres, or computes them if there is room.</summary>
    /// <param name="model">The camera, with a lens.</param>
    /// <param name="threads">Maximum number of threads; the samples do not depend on it.</param>
    /// <returns>Null if there is no room for them, even without the samples of all other cameras.</returns>
    public LensSamples? Find(CameraModel model, int threads, CancellationToken cancellation)
    {
        lock (_gate)
        {
            if (_kept.Find(kept => kept.Model == model && kept.Centres is not null) is { } known)
            {
                return known.Centres;
            }

            long bytes = 2L * sizeof(double) * model.Width * model.Height;
            if (!TryMakeRoom(model, bytes))
            {
                return null;
            }

            LensSamples found = new();
            found.Prepare(model, threads, cancellation);
            _kept.Add(new Kept(model, bytes, found, null));
            return found;
        }
    }

    /// <summary>Finds several samples of each pixel; the other parameters and the result are those of <see cref="Find"/>.</summary>
    /// <param name="centres">The camera's samples at the pixels' centres.</param>
    /// <param name="pattern">Where the samples of a pixel lie.</param>
    public LensSubsamples? FindFurther(
        CameraModel model, LensSamples centres, SamplePattern pattern, int threads, CancellationToken cancellation)
    {
        lock (_gate)
        {
            if (_kept.Find(kept => kept.Further?.IsOf(model, pattern) == true) is { } known)
            {
                return known.Further;
            }

            long bytes = LensSubsamples.BytesOf(model, pattern);
            if (!TryMakeRoom(model, bytes))
            {
                return null;
            }

            LensSubsamples found = new(model, centres, pattern, threads, cancellation);
            _kept.Add(new Kept(model, bytes, null, found));
            return found;
        }
    }

    /// <summary>Forgets the samples of other cameras if that makes room; frames that are being drawn keep theirs until they end.</summary>
    private bool TryMakeRoom(CameraModel model, long bytes)
    {
        long room = maxBytes - bytes;
        if (_kept.Where(kept => kept.Model == model).Sum(kept => kept.Bytes) > room)
        {
            return false;
        }

        if (_kept.Sum(kept => kept.Bytes) > room)
        {
            _kept.RemoveAll(kept => kept.Model != model);
        }

        return true;
    }

    private sealed record Kept(CameraModel Model, long Bytes, LensSamples? Centres, LensSubsamples? Further);
}
