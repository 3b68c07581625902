using System.Runtime.CompilerServices;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface;
using Msisf.Core.Terrain;
using Msisf.Core.Tests.Support;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Core.Tests.Render.Visibility;

public sealed class VisibilityPassTests
{
    private static readonly FunctionGrid Grid = FunctionGrid.Rugged(4);

    [Theory]
    [InlineData("whole-disc")]
    [InlineData("one-metre")]
    [InlineData("disc-1e9")]
    [InlineData("limb")]
    public void Read_Row_HasTheBitsOfSinglePixels(string name)
    {
        const int Size = 77; // no whole number of vectors
        VisibleSurface seen = new VisibilityPass(new SurfaceModel(Grid)).Run(
            RenderScenes.Named(name).Camera(Grid, Size, Size), 1, CancellationToken.None);
        SurfaceRow row = new();
        int pixels = 0;
        for (int y = 1; y <= Size; y++)
        {
            seen.Read(y, row);
            pixels += row.Count;
            Assert.Equal(Enumerable.Range(1, Size).Count(x => seen.TryGet(x, y, out _)), row.Count);
            for (int i = 0; i < row.Count; i++)
            {
                Assert.True(seen.TryGet(row.Columns[i] + 1, y, out SurfaceHit hit));
                Assert.Equal(hit.PointBodyFixed, new Vector3D(row.X[i], row.Y[i], row.Z[i]));
                Assert.Equal(hit.NormalBodyFixed, new Vector3D(row.NormalX[i], row.NormalY[i], row.NormalZ[i]));
                Assert.Equal(hit.RayParameter, row.Parameters[i]);
                Assert.Equal(hit.Facet, seen.FacetOf(y, row.Facets[i]));
            }
        }

        Assert.InRange(pixels, Size * Size / 3, Size * Size);
    }

    [Theory]
    [InlineData("whole-disc")]
    [InlineData("wide-angle")]
    [InlineData("across-pole")]
    public void Run_SeveralThreads_GiveTheSameFrame(string name)
    {
        const int Size = 150;
        VisibilityPass pass = new(new SurfaceModel(Grid));
        PinholeCamera camera = RenderScenes.Named(name).Camera(Grid, Size, Size);
        VisibilityPass other = new(new SurfaceModel(Grid));
        other.Run(RenderScenes.Named("limb").Camera(Grid, Size + 9, Size), 2, CancellationToken.None); // leaves what must not show

        VisibleSurface one = pass.Run(camera, 1, CancellationToken.None);
        VisibleSurface four = other.Run(camera, 4, CancellationToken.None);

        Assert.Equal(one.Counts, four.Counts);
        for (int pixel = 0; pixel < Size * Size; pixel++)
        {
            (int x, int y) = ((pixel % Size) + 1, (pixel / Size) + 1);
            Assert.Equal(one.TryGet(x, y, out SurfaceHit hit), four.TryGet(x, y, out SurfaceHit same));
            Assert.Equal(hit, same);
        }
    }

    /// <summary>A pole in the very middle of a pixel: a corner of 1440 facets.</summary>
    [Theory]
    [InlineData(1.0)]
    [InlineData(-1.0)]
    public void Run_CornerOfManyFacetsAtAPixelsCentre_HasNoHole(double pole)
    {
        FunctionGrid sphere = FunctionGrid.OfHeights(4, (_, _) => 0.0);
        PinholeCamera camera = new(
            new Vector3D(0.0, 0.0, pole * 1_800_000.0), CameraCases.Attitude(new Vector3D(0.0, 0.0, -pole), Vector3D.UnitY), 1.0, 65, 65);

        VisibleSurface seen = new VisibilityPass(new SurfaceModel(sphere)).Run(camera, 1, CancellationToken.None);

        Assert.True(seen.TryGet(33, 33, out SurfaceHit hit));
        Assert.Equal(0.0, hit.PointBodyFixed.X, Rounding.OfPlaces);
        Assert.Equal(0.0, hit.PointBodyFixed.Y, Rounding.OfPlaces);
        Assert.Equal(pole * MoonConstants.ReferenceRadius, hit.PointBodyFixed.Z, 1e-2);
        Assert.Equal(pole > 0.0 ? -1 : 719, hit.Facet.Line);
    }

    /// <summary>Camera within the ground: only the insides of facets, which are not seen.</summary>
    [Fact]
    public void Run_CameraUnderTheGround_SeesNothing()
    {
        PinholeCamera camera = new(new Vector3D(1e6, 0.0, 0.0), CameraCases.Attitude(Vector3D.UnitX, Vector3D.UnitY), 2.0, 32, 32);

        VisibleSurface seen = new VisibilityPass(new SurfaceModel(Grid)).Run(camera, 1, CancellationToken.None);

        Assert.Equal(0, seen.Counts.FacetsDrawn);
        Assert.False(seen.TryGet(16, 16, out _));
    }

    /// <summary>
    /// 265 million samples, of which a near camera must not read more than a few; counted by hand from 40 x 40 km at 474 m a cell.
    /// </summary>
    [Fact]
    public void Run_NearCamera_ReadsLittle()
    {
        long read = 0;
        FunctionGrid fine = new(64, (_, _) =>
        {
            read++;
            return MoonConstants.ReferenceRadius;
        });
        VisibilityPass pass = new(new SurfaceModel(fine));
        PinholeCamera camera = new(
            new Vector3D(1_787_400.0, 0.0, 0.0), CameraCases.Attitude(-Vector3D.UnitX, Vector3D.UnitY), 0.76, 64, 64);
        read = 0; // the model itself has read the lines at the poles

        VisibleSurface seen = pass.Run(camera, 1, CancellationToken.None);

        Assert.Equal(64 * 64, Enumerable.Range(0, 64 * 64).Count(pixel => seen.TryGet((pixel % 64) + 1, (pixel / 64) + 1, out _)));
        Assert.InRange(seen.Counts.CellsSieved, 84 * 84, 20 * 1024);
        Assert.InRange(read, 84 * 84, 2 * 70 * 33 * 33); // 20 km either way of unread relief make it 70 blocks at most
    }

    /// <summary>Buffers that only doubled left 1.47 times the memory of the facets behind.</summary>
    [Fact]
    public void Run_FirstFrame_LeavesLittleMemoryBehind()
    {
        PinholeCamera camera = RenderScenes.Named("disc-1e9").Camera(Grid, 600, 600);

        VisibleSurface seen = new VisibilityPass(new SurfaceModel(Grid)).Run(camera, 1, CancellationToken.None);

        long recorded = seen.Counts.FacetsDrawn * Unsafe.SizeOf<FacetRecord>();
        Assert.True(seen.ReplacedBytes < recorded / 4, $"{recorded} {seen.ReplacedBytes}");
        Assert.True(recorded > 1_000_000, $"{recorded} {seen.ReplacedBytes}");
    }

    [Fact]
    public void Run_RadiusBeyondTheModelsLimits_IsRefused()
    {
        FunctionGrid broken = FunctionGrid.OfHeights(2, (line, sample) => line == 180 && sample == 10 ? 25_000.0 : 0.0);
        VisibilityPass pass = new(new SurfaceModel(broken));

        BadInputException error = Assert.Throws<BadInputException>(
            () => pass.Run(RenderScenes.Named("disc-1e9").Camera(broken, 16, 16), 2, CancellationToken.None));

        Assert.Contains("TEST_GRID", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Run_Cancelled_Throws() => Assert.ThrowsAny<OperationCanceledException>(
        () => new VisibilityPass(new SurfaceModel(Grid)).Run(
            RenderScenes.Named("limb").Camera(Grid, 16, 16), 1, new CancellationToken(canceled: true)));
}
