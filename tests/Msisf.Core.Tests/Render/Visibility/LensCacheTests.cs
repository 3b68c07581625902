using Msisf.Core.Camera;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Tests.Support;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

public sealed class LensCacheTests
{
    private const int Width = 50;

    private const int Height = 40;

    [Fact]
    public void Find_SameCameraAndOffset_ComputesOnce()
    {
        LensCache cache = new();
        CameraModel camera = Camera("barrel");

        LensSamples? first = Find(cache, camera, 0.25);

        Assert.NotNull(first);
        Assert.NotSame(first, Find(cache, camera, -0.25));
        Assert.Same(first, Find(cache, camera, 0.25));
        Assert.NotSame(first, Find(cache, Camera("barrel"), 0.25));
    }

    [Fact]
    public void Find_NoRoom_ForgetsOtherCamerasOnly()
    {
        LensCache cache = new(2 * Width * Height);
        (CameraModel one, CameraModel two) = (Camera("barrel"), Camera("fisheye"));
        LensSamples? left = Find(cache, one, -0.25);
        LensSamples? right = Find(cache, one, 0.25);

        Assert.Null(Find(cache, one, 0.0));
        Assert.Same(left, Find(cache, one, -0.25));
        Assert.Same(right, Find(cache, one, 0.25));

        Assert.True(Find(cache, two, 0.0)!.IsOf(two, 0.0, 0.0));
        Assert.NotSame(left, Find(cache, one, -0.25));
    }

    /// <summary>Nor is anything gained by forgetting the others.</summary>
    [Fact]
    public void Find_CameraThatNeverFits_LeavesTheOthers()
    {
        LensCache cache = new((Width * Height) + 1);
        CameraModel camera = Camera("barrel");
        LensSamples? known = Find(cache, camera, 0.25);

        Assert.Null(Find(cache, LensCases.Of("barrel", 0.5, 2 * Width, Height), 0.25));
        Assert.Same(known, Find(cache, camera, 0.25));
    }

    [Fact]
    public void Find_ManyThreadsAtOnce_GiveAllTheSameObject()
    {
        LensCache cache = new();
        CameraModel camera = Camera("barrel");
        LensSamples?[] found = new LensSamples?[16];

        System.Threading.Tasks.Parallel.For(0, found.Length, i => found[i] = Find(cache, camera, 0.125));

        Assert.NotNull(found[0]);
        Assert.All(found, samples => Assert.Same(found[0], samples));
    }

    private static CameraModel Camera(string lens) => LensCases.Of(lens, 0.5, Width, Height);

    private static LensSamples? Find(LensCache cache, CameraModel camera, double offset) =>
        cache.Find(camera, offset, 0.0, 1, CancellationToken.None);
}
