using Msisf.Adapters.Metadata;
using Msisf.Adapters.Render;
using Msisf.Core.Metadata;
using Msisf.Core.Render.Photometry;
using Msisf.Integration.Tests.Metadata;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Integration.Tests.Render;

/// <summary>A grey image of our own as the annotation reads it: by Skia.</summary>
public class PngWriterTests
{
    private const int Size = 64;

    [Theory]
    [InlineData(8)]
    [InlineData(16)]
    public void Write_ThenAnnotated_HasTheSameGreysAndRedDots(int bitDepth)
    {
        // Too small for the text block; grey 2 (x + y) + 1 everywhere, in 16 bits with a low byte that 8 bits round away.
        byte[] greys = [.. Enumerable.Range(0, Size * Size).Select(i => (byte)((2 * ((i % Size) + (i / Size))) + 1))];
        FrameMetadata frame = ExampleFrame.OfSize(Size, Size);
        using MemoryStream own = new();
        if (bitDepth == 8)
        {
            PngWriter.Write(own, greys, Size, GreyTransfer.Srgb);
        }
        else
        {
            PngWriter.Write(own, [.. greys.Select(grey => (ushort)(grey * 257))], Size, GreyTransfer.Srgb);
        }

        own.Position = 0;
        using MemoryStream annotated = new();
        AnnotationRenderer.Write(own, annotated, frame, ExampleFrame.Sampler(frame, spacing: 32));
        annotated.Position = 0;
        PngPixels image = PngPixels.Read(annotated);

        Assert.Equal((Size, Size), (image.Width, image.Height));
        Assert.True(image[31, 31, 0] > 200 && image[31, 31, 1] < 100, "the grid point in the middle shows the Moon and has a red dot");
        for (int i = 0; i < Size; i++)
        {
            Assert.Equal([greys[i], greys[i], greys[i]], new[] { image[i, 0, 0], image[i, 0, 1], image[i, 0, 2] });
        }
    }
}
