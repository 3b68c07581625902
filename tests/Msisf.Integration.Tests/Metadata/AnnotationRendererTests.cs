using Msisf.Adapters.Metadata;
using Msisf.Adapters.Render;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Metadata;
using Msisf.Core.Numerics;
using Msisf.Core.Render;
using Msisf.Core.Tracing;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Metadata;

public class AnnotationRendererTests
{
    private const int Background = 40;

    [Fact]
    public void Write_GridPoints_HaveARedDotWhereTheyShowTheMoonAndNowhereElse()
    {
        // Narrower than the text block, which is left out.
        FrameMetadata frame = ExampleFrame.OfSize(280, 280);
        PixelSampler pixels = ExampleFrame.Sampler(frame, spacing: 20);

        PngPixels image = Annotate(frame, pixels);

        (int, int)[] shown = [.. pixels.Sample().Select(pixel => (pixel.H, pixel.V))];
        Assert.InRange(shown.Length, 100, 195);
        for (int v = 20; v <= 280; v += 20)
        {
            for (int h = 20; h <= 280; h += 20)
            {
                Assert.Equal(shown.Contains((h, v)), IsRed(image, h, v));
            }
        }
    }

    [Fact]
    public void Write_TerrainPixels_HaveTheirDotsAndDirections()
    {
        // A sphere would fill the image: terrain in the left half only, on the plane x = 1700 km. At pixel (60, 60) it lies 46.6 km west
        // and as far north; the lamp's latitude is the same there, so that its ground line runs east.
        PinholeCamera nadir = new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.Identity, 0.1, 200, 200);
        FrameMetadata frame = ExampleFrame.OfSize(200, 200) with { Camera = nadir };
        SurfaceHit OnPlane(Ray ray)
        {
            double parameter = (1.7e6 - ray.Origin.X) / ray.Direction.X;
            return new SurfaceHit(ray.Origin + (parameter * ray.Direction), Vector3D.UnitX, default, parameter);
        }

        FunctionTruth truth = new(
            nadir,
            new Vector3D(1e7, 0.0, 2.74e5),
            (x, y) => x <= 100 ? (OnPlane(nadir.RayThrough(x, y)), new PixelIllumination(IlluminationState.Lit, 1.0)) : null);

        PngPixels image = Annotate(frame, new PixelSampler(new PixelGrid(200, 200, 60, 60), truth, pixelsPerDegree: 4));

        Assert.True(IsRed(image, 60, 60));
        Assert.True(IsRed(image, 80, 60));
        Assert.False(IsRed(image, 40, 60));
        Assert.False(IsRed(image, 120, 60));
        Assert.False(IsRed(image, 180, 120));
    }

    [Theory]
    [InlineData(1.0, 0.0, 1, 0)]
    [InlineData(-1.0, 0.0, -1, 0)]
    [InlineData(0.0, 1.0, 0, -1)]
    [InlineData(0.0, -1.0, 0, 1)]
    public void Write_SunToOneSide_LineRunsThatWay(double sunRight, double sunUp, int stepX, int stepY)
    {
        // Looking along -x with north up: y is right, z is up. One grid point, in the middle.
        PinholeCamera nadir = new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.Identity, 0.1, 101, 101);
        FrameMetadata frame = ExampleFrame.OfSize(101, 101) with
        {
            Camera = nadir,
            SunPositionBodyFixed = 1.5e11 * new Vector3D(0.5, sunRight, sunUp),
        };

        PngPixels image = Annotate(frame, ExampleFrame.Sampler(frame, spacing: 51));

        Assert.True(IsRed(image, 51 + (20 * stepX), 51 + (20 * stepY)));
        Assert.False(IsRed(image, 51 - (20 * stepX), 51 - (20 * stepY)));
        Assert.False(IsRed(image, 51 + (20 * stepY), 51 + (20 * stepX)));
    }

    [Fact]
    public void Write_UndefinedDirection_HasADotAndNoLine()
    {
        PinholeCamera nadir = new(new Vector3D(4e6, 0.0, 0.0), UnitQuaternion.Identity, 0.1, 101, 101);
        FrameMetadata frame = ExampleFrame.OfSize(101, 101) with { Camera = nadir, SunPositionBodyFixed = new Vector3D(1e11, 0.0, 0.0) };

        PngPixels image = Annotate(frame, ExampleFrame.Sampler(frame, spacing: 51));

        Assert.True(IsRed(image, 51, 51));
        Assert.Equal(CountRed(image, 46, 56), CountRed(image, 1, 101));
    }

    [Theory]
    [InlineData(1, false)]
    [InlineData(64, false)]
    [InlineData(280, false)]
    [InlineData(320, true)]
    [InlineData(1024, true)]
    public void Write_TextBlock_IsThereWhereItCanBeRead(int size, bool isThere)
    {
        FrameMetadata frame = ExampleFrame.OfSize(size, size);

        PngPixels image = Annotate(frame, ExampleFrame.Sampler(frame, spacing: size + 1));

        bool hasLightPixel = Enumerable.Range(0, size * size).Any(i => image[i % size, i / size, 0] > 200);
        Assert.Equal(isThere, hasLightPixel);
        Assert.Equal(isThere, image[0, 0, 0] < Background);
        Assert.Equal(Background, image[size - 1, size - 1, 0]);
    }

    /// <summary>At any size of the font.</summary>
    [Theory]
    [InlineData(320)]
    [InlineData(700)]
    [InlineData(1024)]
    public void Write_Text_StaysInItsBox(int width)
    {
        const int height = 460;
        FrameMetadata frame = ExampleFrame.OfSize(width, height);

        PngPixels image = Annotate(frame, ExampleFrame.Sampler(frame, spacing: width + 1));

        int boxWidth = Enumerable.Range(0, width).Count(x => image[x, 0, 0] < Background);
        int boxHeight = Enumerable.Range(0, height).Count(y => image[0, y, 0] < Background);
        (int X, int Y)[] letters =
        [
            .. from y in Enumerable.Range(0, height) from x in Enumerable.Range(0, width) where image[x, y, 0] > 100 select (x, y),
        ];
        Assert.InRange(letters.Max(pixel => pixel.X), boxWidth / 2, boxWidth - 2);
        Assert.InRange(letters.Max(pixel => pixel.Y), boxHeight / 2, boxHeight - 2);
    }

    /// <summary>On white ground and on black: what is red has a dark line around it, what is white dark ground behind it.</summary>
    [Theory]
    [InlineData(0)]
    [InlineData(128)]
    [InlineData(255)]
    public void Write_AnyGround_MarksAndTextStandOut(byte ground)
    {
        const int size = 600;
        FrameMetadata frame = ExampleFrame.OfSize(size, size);
        PixelSampler pixels = ExampleFrame.Sampler(frame, spacing: 60);

        PngPixels image = PngPixels.Read(new MemoryStream(Bytes(frame, pixels, GreyImage(size, size, ground))));

        PixelRecord low = pixels.Sample().Last(pixel => pixel.H < size - 10);
        Assert.True(IsRed(image, low.H, low.V));
        int darkest = Enumerable.Range(low.H - 6, 13).Min(x => image[x - 1, low.V - 1, 0]);
        Assert.InRange(darkest, 0, Math.Max(100, (int)ground - 100));
        int width = Enumerable.Range(0, size).Count(x => image[x, 0, 0] <= ground / 3);
        Assert.True(ground == 0 || (width is > 100 and < size), "the text has no backing");
        Assert.DoesNotContain(
            from y in Enumerable.Range(0, 40) from x in Enumerable.Range(0, 100) select (x, y),
            place => image[place.x, place.y, 0] > image[place.x, place.y, 1] + 30); // no mark under the text
    }

    [Fact]
    public void Write_Twice_GivesTheSameBytesWithoutTimeStamp()
    {
        FrameMetadata frame = ExampleFrame.OfSize(512, 512);
        PixelSampler pixels = ExampleFrame.Sampler(frame, spacing: 50);

        byte[] first = Bytes(frame, pixels, GreyImage(512, 512));
        using MemoryStream checkedCopy = new();
        PngHeader header = PngFile.CopyImage(new MemoryStream(first), checkedCopy, "annotated.png");

        Assert.Equal(first, Bytes(frame, pixels, GreyImage(512, 512)));
        Assert.Equal(first, checkedCopy.ToArray());
        Assert.Equal(new PngHeader(512, 512, 8, 2), header);
    }

    [Fact]
    public void Write_ImageOfAnotherSize_IsBadInput()
    {
        FrameMetadata frame = ExampleFrame.OfSize(64, 64);

        BadInputException failure = Assert.Throws<BadInputException>(
            () => Bytes(frame, ExampleFrame.Sampler(frame, spacing: 8), GreyImage(64, 63)));

        Assert.Contains("64 x 63 px, the frame 64 x 64 px", failure.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Write_CutImage_IsBadInput()
    {
        FrameMetadata frame = ExampleFrame.OfSize(64, 64);

        Assert.Throws<BadInputException>(() => Bytes(frame, ExampleFrame.Sampler(frame, spacing: 8), GreyImage(64, 64)[..60]));
    }

    [Fact]
    public void Write_DestinationFails_ThrowsItsOwnException()
    {
        FrameMetadata frame = ExampleFrame.OfSize(64, 64);
        using MemoryStream full = new(new byte[10]);

        Assert.Throws<NotSupportedException>(() => AnnotationRenderer.Write(
            new MemoryStream(GreyImage(64, 64)), full, frame, ExampleFrame.Sampler(frame, spacing: 8)));
    }

    private static PngPixels Annotate(FrameMetadata frame, PixelSampler pixels) =>
        PngPixels.Read(new MemoryStream(Bytes(frame, pixels, GreyImage(frame.Camera.Width, frame.Camera.Height))));

    private static byte[] Bytes(FrameMetadata frame, PixelSampler pixels, byte[] image)
    {
        using MemoryStream annotated = new();
        AnnotationRenderer.Write(new MemoryStream(image), annotated, frame, pixels);
        return annotated.ToArray();
    }

    /// <summary>Pixel (x, y) from 1.</summary>
    private static bool IsRed(PngPixels image, int x, int y) =>
        image[x - 1, y - 1, 0] > 150 && image[x - 1, y - 1, 1] < Background;

    private static int CountRed(PngPixels image, int first, int last) =>
        Enumerable.Range(first, last - first + 1).Sum(
            y => Enumerable.Range(first, last - first + 1).Count(x => image[x - 1, y - 1, 0] != Background));

    private static byte[] GreyImage(int width, int height, byte ground = Background) => PngBytes.Grey(width, height, ground);
}
