using Msisf.Core.Camera;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Tests.Support;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

public sealed class LensCacheTests
{
    private const int Width = 50;

    private const int Height = 40;

    private const long BytesOfCentres = 16 * Width * Height;

    /// <summary>px: half the last bit, in single precision, of the 0.05 px by which the lens bends an image of 50 px in a pixel.</summary>
    private const double SinglePrecision = 0.05 / (1 << 24);

    [Fact]
    public void Find_SameCamera_ComputesOnce()
    {
        LensCache cache = new();
        CameraModel camera = Camera("barrel");

        LensSamples? first = Find(cache, camera);

        Assert.NotNull(first);
        Assert.True(first.IsOf(camera));
        Assert.Same(Find(cache, camera, 2), Find(cache, camera, 2));
        Assert.NotSame(Find(cache, camera, 2), Find(cache, camera, 3));
        Assert.NotSame(first, Find(cache, Camera("barrel")));
        Assert.Same(first, Find(cache, camera));
    }

    [Fact]
    public void Find_NoRoom_ForgetsOtherCameras()
    {
        LensCache cache = new(2 * BytesOfCentres);
        (CameraModel one, CameraModel two) = (Camera("barrel"), Camera("fisheye"));
        LensSamples? ofOne = Find(cache, one);
        LensSamples? ofTwo = Find(cache, two);
        Assert.Same(ofOne, Find(cache, one));
        Assert.Same(ofTwo, Find(cache, two));

        CameraModel three = Camera("prism");
        Assert.True(Find(cache, three)!.IsOf(three));
        Assert.NotSame(ofOne, Find(cache, one));
    }

    /// <summary>Centres and further samples of a camera would else push each other out in every frame.</summary>
    [Fact]
    public void Find_NoRoomBesideTheCentres_LeavesThem()
    {
        LensCache cache = new(2 * BytesOfCentres);
        CameraModel camera = Camera("barrel");
        LensSamples? centres = Find(cache, camera);

        Assert.Null(Find(cache, camera, 2));
        Assert.Same(centres, Find(cache, camera));
    }

    [Fact]
    public void Find_Grid_HasThePointsOfEachPixelBesideEachOther()
    {
        CameraModel camera = Camera("fisheye");
        LensSubsamples grid = Find(new LensCache(), camera, 2)!;
        double[] rights = new double[SamplePattern.Lanes];
        double[] downs = new double[SamplePattern.Lanes];

        for (int sample = 0; sample < 4 * Width * Height; sample++)
        {
            (int row, int column) = Math.DivRem(sample / 4, Width);
            (double right, double down) = camera.ToIdeal(
                column + (sample % 2 == 0 ? 0.75 : 1.25), row + (sample % 4 < 2 ? 0.75 : 1.25));
            grid.Read(column, row, rights, downs, start: 0);
            Assert.Equal(right, rights[sample % 4], SinglePrecision / camera.FocalX);
            Assert.Equal(down, downs[sample % 4], SinglePrecision / camera.FocalY);
        }
    }

    /// <summary>Nor is anything gained by forgetting the others.</summary>
    [Fact]
    public void Find_CameraThatNeverFits_LeavesTheOthers()
    {
        LensCache cache = new(BytesOfCentres + 1);
        CameraModel camera = Camera("barrel");
        LensSamples? known = Find(cache, camera);

        Assert.Null(Find(cache, LensCases.Of("barrel", 0.5, 2 * Width, Height)));
        Assert.Same(known, Find(cache, camera));
    }

    [Fact]
    public void Find_ManyThreadsAtOnce_GiveAllTheSameObject()
    {
        LensCache cache = new();
        CameraModel camera = Camera("barrel");
        LensSamples?[] found = new LensSamples?[16];

        System.Threading.Tasks.Parallel.For(0, found.Length, i => found[i] = Find(cache, camera));

        Assert.NotNull(found[0]);
        Assert.All(found, samples => Assert.Same(found[0], samples));
    }

    private static CameraModel Camera(string lens) => LensCases.Of(lens, 0.5, Width, Height);

    private static LensSamples? Find(LensCache cache, CameraModel camera) => cache.Find(camera, 1, CancellationToken.None);

    private static LensSubsamples? Find(LensCache cache, CameraModel camera, int perAxis) => cache.FindFurther(
        camera, Find(cache, camera)!, SamplePattern.Grid(perAxis), 1, CancellationToken.None);
}
